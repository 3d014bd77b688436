#include "analysis/fit.hpp"

#include <fmt/format.h>

#include <Eigen/Core>
#include <Eigen/QR>
#include <algorithm>
#include <cmath>
#include <set>

#include "analysis/student_t.hpp"
#include "libmpm/core/enumerators.hpp"

namespace analysis {
namespace {

constexpr auto model_names = mpm::words<FitModel>({{FitModel::linear, "linear"},
                                                   {FitModel::quadratic, "quadratic"},
                                                   {FitModel::power, "power"},
                                                   {FitModel::exponential, "exponential"}});

using Eigen::MatrixXd;
using Eigen::VectorXd;

int coefficient_count(FitModel model) { return model == FitModel::quadratic ? 3 : 2; }

std::string failure_of(FitModel model, std::span<const double> x, std::span<const double> y,
                       std::span<const double> y_error) {
  const auto finite = [](double v) { return std::isfinite(v); };
  const std::string needed = std::to_string(coefficient_count(model));
  if (x.size() != y.size() || (!y_error.empty() && y_error.size() != y.size()))
    return "x, y and the errors of y have unequal lengths";
  if (!std::ranges::all_of(x, finite)) return "an x is not finite";
  if (!std::ranges::all_of(y, finite)) return "a y is not finite";
  if (!std::ranges::all_of(y_error, [](double e) { return std::isfinite(e) && e > 0; }))
    return "an error of y is not a positive number";
  const std::string what = (model == FitModel::exponential ? "an " : "a ") + std::string(name(model)) +
                           " fit needs at least " + needed;
  if (x.size() < static_cast<std::size_t>(coefficient_count(model)))
    return what + " points; there are " + std::to_string(x.size());
  const std::size_t distinct = std::set<double>(x.begin(), x.end()).size();
  if (distinct < static_cast<std::size_t>(coefficient_count(model)))
    return what + " different x; there are " + std::to_string(distinct);
  return {};
}

/// Coefficients in x from those in z = (x - centre)/scale: c = T d.
MatrixXd powers_of_x(int count, double centre, double scale) {
  MatrixXd t = MatrixXd::Zero(count, count);
  t(0, 0) = 1;
  for (int k = 1; k < count; ++k)  // z^k = z^(k-1) (x - centre)/scale
    for (int i = 0; i <= k; ++i) t(i, k) = ((i > 0 ? t(i - 1, k - 1) : 0) - centre * t(i, k - 1)) / scale;
  return t;
}

std::vector<double> by_rows(const MatrixXd& m) {
  std::vector<double> values;
  for (Eigen::Index i = 0; i < m.rows(); ++i)
    for (Eigen::Index j = 0; j < m.cols(); ++j) values.push_back(m(i, j));
  return values;
}

VectorXd powers(double z, int count) {
  VectorXd p(count);
  p(0) = 1;
  for (int k = 1; k < count; ++k) p(k) = p(k - 1) * z;
  return p;
}

/// Values and the square roots of their weights.
struct Data {
  VectorXd y, root_weight;

  Data(std::span<const double> values, std::span<const double> errors)
      : y(Eigen::Map<const VectorXd>(values.data(), std::ssize(values))),
        root_weight(VectorXd::Ones(y.size())) {
    for (Eigen::Index i = 0; i < std::ssize(errors); ++i)
      root_weight(i) = 1 / errors[static_cast<std::size_t>(i)];
  }
};

/// Fills in what the (weighted) sums of squares about the curve and about the mean say. Gives back the
/// variance of a value of weight 1; empty where it is not known: no errors, and no point to spare.
std::optional<double> judge(const Data& data, const VectorXd& curve, bool weighted, Fit& fit) {
  const VectorXd weight = data.root_weight.cwiseAbs2();
  const double mean = weight.dot(data.y) / weight.sum();
  const double residual = (data.root_weight.asDiagonal() * (data.y - curve)).squaredNorm();
  const double total = (data.root_weight.asDiagonal() * (data.y.array() - mean).matrix()).squaredNorm();
  fit.degrees_of_freedom = fit.points - coefficient_count(fit.model);
  fit.weighted = weighted;
  if (total > 0 && fit.degrees_of_freedom > 0) fit.r2 = 1 - residual / total;
  if (fit.degrees_of_freedom > 0) {
    const double reduced = residual / fit.degrees_of_freedom;
    fit.residual_standard_deviation = std::sqrt(reduced);
    return weighted ? std::max(1.0, reduced) : reduced;
  }
  return weighted ? std::optional(1.0) : std::nullopt;
}

/// variance (X^T W X)^-1, where that is P R^-1 R^-T P^T.
MatrixXd covariance_of(double variance, const Eigen::ColPivHouseholderQR<MatrixXd>& qr, int count) {
  const MatrixXd r_inverse = qr.matrixR()
                                 .topLeftCorner(count, count)
                                 .template triangularView<Eigen::Upper>()
                                 .solve(MatrixXd::Identity(count, count));
  const MatrixXd half = qr.colsPermutation() * r_inverse;
  return variance * half * half.transpose();
}

/// `to_x`: how the coefficients change with the scaled ones.
void set_covariance(const MatrixXd& scaled, const MatrixXd& to_x, Fit& fit) {
  const MatrixXd in_x = to_x * scaled * to_x.transpose();
  fit.scaled.covariance = by_rows(scaled);
  fit.covariance = by_rows(in_x);
  for (Eigen::Index k = 0; k < in_x.rows(); ++k) fit.standard_errors.push_back(std::sqrt(in_x(k, k)));
}

/// What a curve is straight in.
double straight(FitModel model, double x) { return model == FitModel::power ? std::log(x) : x; }

/// What a power law or an exponential needs beyond failure_of; empty: it is there.
std::string failure_of_logarithms(FitModel model, std::span<const double> x, std::span<const double> y) {
  if (!std::ranges::all_of(y, [&](double v) { return v * y.front() > 0; }))
    return "the y are not all of one sign, as those of " +
           std::string(model == FitModel::power ? "a " : "an ") + std::string(name(model)) + " curve are";
  if (model == FitModel::power && !std::ranges::all_of(x, [](double v) { return v > 0; }))
    return "the x are not all above zero";
  return {};
}

}  // namespace

bool is_polynomial(FitModel model) { return model == FitModel::linear || model == FitModel::quadratic; }

std::optional<FitModel> fit_model(std::string_view name) {
  const auto found = std::ranges::find(model_names, name);
  if (found == model_names.end()) return std::nullopt;
  return static_cast<FitModel>(found - model_names.begin());
}

std::string_view name(FitModel model) { return model_names[static_cast<std::size_t>(model)]; }

std::span<const std::string_view> fit_model_names() { return model_names; }

std::optional<double> Fit::reduced_chi2() const {
  if (!weighted || !residual_standard_deviation) return std::nullopt;
  return *residual_standard_deviation * *residual_standard_deviation;
}

std::string Fit::r2_text() const {
  if (r2) return fmt::format("{:.4f}", *r2);
  if (degrees_of_freedom > 0 || !ok()) return "";
  return fmt::format("not judged ({} points, {} coefficients)", points, coefficients.size());
}

Fit::Prefactor Fit::prefactor(double factor, double y_factor) const {
  // z at x = 1 / factor
  const double z = (-std::log(factor) - scaled.centre) / scaled.scale;
  const double value = scaled.sign * std::exp(scaled.coefficients[0] + scaled.coefficients[1] * z) * y_factor;
  if (scaled.covariance.empty()) return {value, {}};
  const VectorXd p = powers(z, 2);
  const Eigen::Map<const MatrixXd> c(scaled.covariance.data(), 2, 2);
  return {value, std::abs(value) * std::sqrt(std::max(0.0, p.dot(c * p)))};
}

double Fit::operator()(double x) const {
  const double z = (straight(model, x) - scaled.centre) / scaled.scale;
  double value = 0;
  for (auto c = scaled.coefficients.rbegin(); c != scaled.coefficients.rend(); ++c) value = value * z + *c;
  return is_polynomial(model) ? value : scaled.sign * std::exp(value);
}

std::optional<double> Fit::band(double x, double confidence) const {
  if (standard_errors.empty()) return std::nullopt;
  const int count = static_cast<int>(coefficients.size());
  const VectorXd p = powers((straight(model, x) - scaled.centre) / scaled.scale, count);
  const Eigen::Map<const MatrixXd> c(scaled.covariance.data(), count, count);
  const double slope = is_polynomial(model) ? 1 : std::abs((*this)(x));  // dy / d(ln y)
  return student_t_two_sided(confidence, degrees_of_freedom) * slope * std::sqrt(std::max(0.0, p.dot(c * p)));
}

Fit fit_polynomial(FitModel model, std::span<const double> x, std::span<const double> y,
                   std::span<const double> y_error) {
  Fit fit;
  fit.model = model;
  fit.points = static_cast<int>(x.size());
  fit.failure = failure_of(model, x, y, y_error);
  if (!fit.ok()) return fit;

  const auto [low, high] = std::ranges::minmax(x);
  fit.x_min = low;
  fit.x_max = high;
  fit.scaled.centre = low + (high - low) / 2;
  fit.scaled.scale = (high - low) / 2;

  const int count = coefficient_count(model);
  const Data data(y, y_error);
  MatrixXd design(data.y.size(), count);
  for (Eigen::Index i = 0; i < data.y.size(); ++i)
    design.row(i) =
        powers((x[static_cast<std::size_t>(i)] - fit.scaled.centre) / fit.scaled.scale, count).transpose();
  const Eigen::ColPivHouseholderQR<MatrixXd> qr(data.root_weight.asDiagonal() * design);
  if (qr.rank() < count) {
    fit.failure = "the x lie too close together for a " + std::string(name(model)) + " fit";
    return fit;
  }
  const VectorXd solution = qr.solve(data.root_weight.asDiagonal() * data.y);
  const MatrixXd to_x = powers_of_x(count, fit.scaled.centre, fit.scaled.scale);
  const VectorXd coefficients = to_x * solution;
  fit.scaled.coefficients.assign(solution.begin(), solution.end());
  fit.coefficients.assign(coefficients.begin(), coefficients.end());
  if (const auto variance = judge(data, design * solution, !y_error.empty(), fit))
    set_covariance(covariance_of(*variance, qr, count), to_x, fit);
  return fit;
}

Fit fit_curve(FitModel model, std::span<const double> x, std::span<const double> y,
              std::span<const double> y_error) {
  if (is_polynomial(model)) return fit_polynomial(model, x, y, y_error);
  Fit fit;
  fit.model = model;
  fit.points = static_cast<int>(x.size());
  fit.failure = failure_of(model, x, y, y_error);
  if (fit.ok()) fit.failure = failure_of_logarithms(model, x, y);
  if (!fit.ok()) return fit;

  std::vector<double> along, logarithm, error_of_logarithm;
  for (std::size_t i = 0; i < x.size(); ++i) {
    along.push_back(straight(model, x[i]));
    logarithm.push_back(std::log(std::abs(y[i])));
    error_of_logarithm.push_back((y_error.empty() ? 1 : y_error[i]) / std::abs(y[i]));
  }
  const Fit line = fit_polynomial(FitModel::linear, along, logarithm, error_of_logarithm);
  if (!line.ok()) {
    fit.failure = "the x lie too close together for a curve";
    return fit;
  }
  fit.x_min = std::ranges::min(x), fit.x_max = std::ranges::max(x);
  fit.scaled = line.scaled;
  fit.scaled.covariance.clear();
  fit.scaled.sign = y.front() > 0 ? 1 : -1;

  const Data data(y, y_error);
  VectorXd d = Eigen::Map<const VectorXd>(line.scaled.coefficients.data(), 2);
  const auto curve = [&](const VectorXd& at) {
    VectorXd values(data.y.size());
    for (Eigen::Index i = 0; i < values.size(); ++i)
      values(i) =
          fit.scaled.sign *
          std::exp(
              powers((along[static_cast<std::size_t>(i)] - fit.scaled.centre) / fit.scaled.scale, 2).dot(at));
    return values;
  };
  const auto misfit = [&](const VectorXd& at) {
    return (data.root_weight.asDiagonal() * (data.y - curve(at))).squaredNorm();
  };
  const auto tangent = [&](const VectorXd& values) {
    MatrixXd j(values.size(), 2);
    for (Eigen::Index i = 0; i < values.size(); ++i)
      j.row(i) =
          values(i) *
          powers((along[static_cast<std::size_t>(i)] - fit.scaled.centre) / fit.scaled.scale, 2).transpose();
    return MatrixXd(data.root_weight.asDiagonal() * j);
  };
  bool settled = false;
  constexpr int most_steps = 100, most_halvings = 40;
  for (int k = 0; k < most_steps && !settled; ++k) {
    const VectorXd values = curve(d);
    const VectorXd step =
        tangent(values).colPivHouseholderQr().solve(data.root_weight.asDiagonal() * (data.y - values));
    double share = 1;  // shorter steps until the misfit falls, or is the same but for rounding
    const double most = misfit(d) * (1 + 1e-10);
    int halvings = 0;
    while (halvings < most_halvings && !(misfit(d + share * step) <= most)) share /= 2, ++halvings;
    if (halvings < most_halvings) d += share * step;
    settled = halvings == most_halvings || step.norm() <= 1e-11 * (1 + d.norm());
  }
  if (!settled || !d.allFinite()) {
    fit.failure = "no least sum of squares was found in " + std::to_string(most_steps) + " steps";
    return fit;
  }
  const double slope = d(1) / fit.scaled.scale;
  const double c0 = fit.scaled.sign * std::exp(d(0) - slope * fit.scaled.centre);
  fit.scaled.coefficients.assign(d.begin(), d.end());
  fit.coefficients = {c0, slope};
  if (!std::isfinite(c0) || c0 == 0) {
    fit.failure = fmt::format("its value at x = {} is too large or too small to be written",
                              model == FitModel::power ? "1" : "0");
    return fit;
  }
  if (const auto variance = judge(data, curve(d), !y_error.empty(), fit)) {
    MatrixXd to_x(2, 2);
    to_x << c0, -c0 * fit.scaled.centre / fit.scaled.scale, 0, 1 / fit.scaled.scale;
    const Eigen::ColPivHouseholderQR<MatrixXd> qr(tangent(curve(d)));
    set_covariance(covariance_of(*variance, qr, 2), to_x, fit);
  }
  return fit;
}

}  // namespace analysis
