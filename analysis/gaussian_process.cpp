#include "analysis/gaussian_process.hpp"

#include <Eigen/Cholesky>
#include <algorithm>
#include <cmath>
#include <limits>

namespace analysis {
namespace {

using Eigen::Index;
using Eigen::MatrixXd;
using Eigen::VectorXd;

constexpr double infinity = std::numeric_limits<double>::infinity();
/// Of what is searched, in logarithms: lengths of scaled inputs, and shares of the values' variance.
constexpr double shortest = 0.02, longest = 20, least_variance = 1e-3, most_variance = 1e3;
constexpr double least_scatter = 1e-10, most_scatter = 1;

/// Matern of 5/2 at a scaled distance: (1 + s + s^2 / 3) exp(-s), s = sqrt(5) r.
double matern(double s) { return (1 + s + s * s / 3) * std::exp(-s); }

std::string failure_of(const MatrixXd& inputs, std::span<const double> values,
                       std::span<const double> deviations) {
  const auto finite = [](double v) { return std::isfinite(v); };
  if (inputs.rows() != std::ssize(values) || (!deviations.empty() && deviations.size() != values.size()))
    return "inputs, values and their deviations have unequal lengths";
  if (inputs.cols() == 0) return "there is no input";
  if (inputs.rows() < 3 * inputs.cols())
    return "a surface over " + std::to_string(inputs.cols()) + " inputs needs at least " +
           std::to_string(3 * inputs.cols()) + " runs; there are " + std::to_string(inputs.rows());
  if (!inputs.allFinite() || !std::ranges::all_of(values, finite) ||
      !std::ranges::all_of(deviations, [](double d) { return std::isfinite(d) && d >= 0; }))
    return "a number is not finite, or a deviation is negative";
  for (Index k = 0; k < inputs.cols(); ++k)
    if (!(inputs.col(k).maxCoeff() > inputs.col(k).minCoeff()))
      return "input " + std::to_string(k + 1) + " has one value";
  return {};
}

}  // namespace

/// Minus the logarithm of how likely the data are, the mean being the best one, over the logarithms of
/// lengths, variance and scatter.
struct GaussianProcess::Likelihood {
  const MatrixXd& x;
  const VectorXd &y, &noise;

  struct Answer {
    double value = infinity;
    VectorXd gradient;
  };
  Index size() const { return x.cols() + 2; }

  VectorXd lower() const {
    VectorXd l = VectorXd::Constant(size(), std::log(shortest));
    l(size() - 2) = std::log(least_variance), l(size() - 1) = std::log(least_scatter);
    return l;
  }
  VectorXd upper() const {
    VectorXd u = VectorXd::Constant(size(), std::log(longest));
    u(size() - 2) = std::log(most_variance), u(size() - 1) = std::log(most_scatter);
    return u;
  }

  Answer operator()(const VectorXd& at) const {
    const Index n = x.rows(), d = x.cols();
    const double variance = std::exp(at(d)), scatter = std::exp(at(d + 1));
    const VectorXd inverse = (-2 * at.head(d)).array().exp();  // 1 / length^2
    MatrixXd k(n, n), slope(n, n);                             // slope: dk / d(r^2)
    for (Index i = 0; i < n; ++i)
      for (Index j = 0; j <= i; ++j) {
        const double square = ((x.row(i) - x.row(j)).array().square() * inverse.transpose().array()).sum();
        const double s = std::sqrt(5 * square);
        k(i, j) = k(j, i) = variance * matern(s);
        slope(i, j) = slope(j, i) = -variance * 5.0 / 6 * (1 + s) * std::exp(-s);
      }
    MatrixXd covariance = k;
    covariance.diagonal() += noise + VectorXd::Constant(n, scatter);
    const Eigen::LLT<MatrixXd> factor(covariance);
    if (factor.info() != Eigen::Success) return {};
    const MatrixXd inverse_covariance = factor.solve(MatrixXd::Identity(n, n));
    const VectorXd one = inverse_covariance.rowwise().sum();
    const double mean = one.dot(y) / one.sum();
    const VectorXd weights = inverse_covariance * (y.array() - mean).matrix();
    Answer answer;
    answer.value = 0.5 * (y.array() - mean).matrix().dot(weights) +
                   MatrixXd(factor.matrixL()).diagonal().array().log().sum();
    // d value / d theta = tr((covariance^-1 - w w^T) dK) / 2
    const MatrixXd outer = inverse_covariance - weights * weights.transpose();
    answer.gradient.resize(size());
    for (Index m = 0; m < d; ++m) {
      double sum = 0;
      for (Index i = 0; i < n; ++i)
        for (Index j = 0; j < i; ++j) {
          const double step = x(i, m) - x(j, m);
          sum += outer(i, j) * slope(i, j) * -2 * step * step * inverse(m);
        }
      answer.gradient(m) = sum;  // both halves of a symmetric sum, times 1/2
    }
    answer.gradient(d) = 0.5 * outer.cwiseProduct(k).sum();
    answer.gradient(d + 1) = 0.5 * scatter * outer.trace();
    return answer;
  }
};

namespace {

/// The least value within bounds: steps of [Broyden, Fletcher, Goldfarb, Shanno], cut at the bounds.
template <class Function>
std::pair<double, VectorXd> least(const Function& function, VectorXd at) {
  const VectorXd lower = function.lower(), upper = function.upper();
  const auto inside = [&](const VectorXd& p) { return VectorXd(p.cwiseMax(lower).cwiseMin(upper)); };
  at = inside(at);
  auto answer = function(at);
  if (!std::isfinite(answer.value)) return {infinity, at};
  MatrixXd h = MatrixXd::Identity(at.size(), at.size());
  constexpr int most_steps = 80;
  for (int step = 0; step < most_steps; ++step) {
    VectorXd direction = -h * answer.gradient;
    // at a bound nothing leads out
    for (Index i = 0; i < at.size(); ++i)
      if ((at(i) <= lower(i) && direction(i) < 0) || (at(i) >= upper(i) && direction(i) > 0))
        direction(i) = 0;
    if (direction.dot(answer.gradient) >= 0) {
      if (h.isIdentity()) break;
      h.setIdentity();
      continue;
    }
    constexpr double longest_step = 2;  // in logarithms
    double share = std::min(1.0, longest_step / direction.cwiseAbs().maxCoeff());
    VectorXd next;
    auto there = answer;
    bool lower_value = false;
    for (int halving = 0; halving < 25 && !lower_value; ++halving, share /= 2) {
      next = inside(at + share * direction);
      there = function(next);
      lower_value = there.value < answer.value + 1e-4 * answer.gradient.dot(next - at);
    }
    if (!lower_value) {
      if (h.isIdentity()) break;
      h.setIdentity();
      continue;
    }
    const VectorXd s = next - at, g = there.gradient - answer.gradient;
    const double gain = answer.value - there.value;
    at = next;
    answer = there;
    if (const double curvature = s.dot(g); curvature > 1e-12) {
      const MatrixXd left = MatrixXd::Identity(at.size(), at.size()) - s * g.transpose() / curvature;
      h = left * h * left.transpose() + s * s.transpose() / curvature;
    }
    if (gain < 1e-7) break;
  }
  return {answer.value, at};
}

}  // namespace

GaussianProcess::GaussianProcess(const MatrixXd& inputs, std::span<const double> values,
                                 std::span<const double> deviations)
    : failure_(failure_of(inputs, values, deviations)) {
  if (!ok()) return;
  low_ = inputs.colwise().minCoeff();
  width_ = inputs.colwise().maxCoeff().transpose() - low_;
  x_ = (inputs.rowwise() - low_.transpose()).array().rowwise() / width_.transpose().array();
  y_ = Eigen::Map<const VectorXd>(values.data(), std::ssize(values));
  offset_ = y_.mean();
  scale_ = std::sqrt((y_.array() - offset_).square().mean());
  if (!(scale_ > 0)) scale_ = 1;
  y_ = (y_.array() - offset_) / scale_;
  noise_ = VectorXd::Zero(y_.size());
  for (Index i = 0; i < std::ssize(deviations); ++i)
    noise_(i) = std::pow(deviations[static_cast<std::size_t>(i)] / scale_, 2);
  find_lengths();
  solve();
}

void GaussianProcess::find_lengths() {
  const Likelihood likelihood{x_, y_, noise_};
  const Index d = x_.cols();
  double best = infinity;
  for (const double length : {0.3, 1.0, 3.0}) {
    VectorXd start = VectorXd::Constant(likelihood.size(), std::log(length));
    start(d) = 0, start(d + 1) = std::log(1e-4);
    const auto [value, at] = least(likelihood, start);
    if (!(value < best)) continue;
    best = value;
    lengths_ = at.head(d).array().exp();
    variance_ = std::exp(at(d));
    scatter_ = std::exp(at(d + 1));
  }
  if (!std::isfinite(best)) failure_ = "the covariance of the runs cannot be factored";
}

double GaussianProcess::kernel(const VectorXd& a, const VectorXd& b) const {
  return variance_ * matern(std::sqrt(5 * (a - b).cwiseQuotient(lengths_).squaredNorm()));
}

void GaussianProcess::solve() {
  if (!ok()) return;
  const Index n = x_.rows();
  MatrixXd covariance(n, n);
  for (Index i = 0; i < n; ++i)
    for (Index j = 0; j <= i; ++j)
      covariance(i, j) = covariance(j, i) = kernel(x_.row(i).transpose(), x_.row(j).transpose());
  covariance.diagonal() += noise_ + VectorXd::Constant(n, scatter_);
  const Eigen::LLT<MatrixXd> factor(covariance);
  factor_ = factor.matrixL();
  one_ = factor.solve(VectorXd::Ones(n));
  mean_ = one_.dot(y_) / one_.sum();
  weights_ = factor.solve((y_.array() - mean_).matrix());

  // Leaving out run i, the mean found anew: its error is w_i / q_ii, of variance 1 / q_ii, with
  // q = covariance^-1 - one one^T / sum(one).
  const MatrixXd inverse = factor.solve(MatrixXd::Identity(n, n));
  double squares = 0;
  int covered = 0;
  left_out_scores_.resize(n);
  for (Index i = 0; i < n; ++i) {
    const double q = inverse(i, i) - one_(i) * one_(i) / one_.sum();
    const double error = weights_(i) / q;
    left_out_scores_(i) = -error * std::sqrt(q);
    squares += error * error;
    covered += std::abs(error) <= half_width_95 / std::sqrt(q);
  }
  neighbour_ = 0;
  for (Index i = 0; i < n; ++i) {
    double nearest = infinity;
    for (Index j = 0; j < n; ++j)
      if (j != i)
        nearest =
            std::min(nearest, (x_.row(i) - x_.row(j)).transpose().cwiseQuotient(lengths_).squaredNorm());
    neighbour_ += std::sqrt(nearest) / static_cast<double>(n);
  }
  if (!(neighbour_ > 0)) neighbour_ = 1;
  const double total = y_.squaredNorm();
  cross_validation_ = {std::sqrt(squares / static_cast<double>(n)) * scale_,
                       total > 0 ? std::optional(1 - squares / total) : std::nullopt,
                       static_cast<double>(covered) / static_cast<double>(n)};
}

MatrixXd GaussianProcess::covariance(const MatrixXd& places) const {
  const Index n = x_.rows(), m = places.rows();
  const MatrixXd scaled_places =
      (places.rowwise() - low_.transpose()).array().rowwise() / width_.transpose().array();
  MatrixXd of_runs(n, m), prior(m, m);
  for (Index j = 0; j < m; ++j) {
    const VectorXd x = scaled_places.row(j).transpose();
    for (Index i = 0; i < n; ++i) of_runs(i, j) = kernel(x, x_.row(i).transpose());
    for (Index i = 0; i <= j; ++i) prior(i, j) = prior(j, i) = kernel(x, scaled_places.row(i).transpose());
  }
  const MatrixXd half = factor_.triangularView<Eigen::Lower>().solve(of_runs);
  const VectorXd rest = VectorXd::Ones(m) - of_runs.transpose() * one_;
  return scale_ * scale_ * (prior - half.transpose() * half + rest * rest.transpose() / one_.sum());
}

std::vector<double> GaussianProcess::left_out_scores() const {
  return {left_out_scores_.begin(), left_out_scores_.end()};
}

double GaussianProcess::surprise(const VectorXd& place) const {
  const VectorXd x = scaled(place);
  double sum = 1, weights = 1;  // as if one run about were off by what the surface says
  for (Index i = 0; i < x_.rows(); ++i) {
    const double square = (x - x_.row(i).transpose()).cwiseQuotient(lengths_).squaredNorm();
    const double weight = std::exp(-0.5 * square / (neighbour_ * neighbour_));
    sum += weight * std::pow(left_out_scores_(i), 2);
    weights += weight;
  }
  return sum / weights;
}

ValueWithDeviation GaussianProcess::at(const VectorXd& input) const {
  const VectorXd x = scaled(input);
  VectorXd k(x_.rows());
  for (Index i = 0; i < x_.rows(); ++i) k(i) = kernel(x, x_.row(i).transpose());
  const VectorXd half = factor_.triangularView<Eigen::Lower>().solve(k);
  const double rest = 1 - one_.dot(k);  // what the mean is not known from
  const double variance = variance_ - half.squaredNorm() + rest * rest / one_.sum();
  return {offset_ + scale_ * (mean_ + k.dot(weights_)), scale_ * std::sqrt(std::max(0.0, variance))};
}

double GaussianProcess::Path::operator()(const VectorXd& input) const {
  const VectorXd x = of_->scaled(input);
  double value = mean_ + amplitude_ * weights_.dot(((frequencies_ * x + phases_).array().cos()).matrix());
  for (Index i = 0; i < of_->x_.rows(); ++i)
    if (update_(i) != 0) value += update_(i) * of_->kernel(x, of_->x_.row(i).transpose());
  return of_->offset_ + of_->scale_ * value;
}

/// A draw that knows nothing of the runs becomes one that agrees with them (Matheron's rule).
GaussianProcess::Path GaussianProcess::finish(Path path) const {
  VectorXd left = y_ - path.update_;  // less the noise of this draw
  for (Index i = 0; i < x_.rows(); ++i)
    left(i) -= path.mean_ +
               path.amplitude_ *
                   path.weights_.dot(
                       ((path.frequencies_ * x_.row(i).transpose() + path.phases_).array().cos()).matrix());
  const VectorXd half = factor_.triangularView<Eigen::Lower>().solve(left);
  path.update_ = factor_.transpose().triangularView<Eigen::Upper>().solve(half);
  return path;
}

}  // namespace analysis
