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

constexpr auto model_names =
    mpm::words<FitModel>({{FitModel::linear, "linear"}, {FitModel::quadratic, "quadratic"}});

using Eigen::MatrixXd;
using Eigen::VectorXd;

int coefficient_count(FitModel model) { return model == FitModel::linear ? 2 : 3; }

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
  const std::string what = "a " + std::string(name(model)) + " fit needs at least " + needed;
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

/// (weighted) sums of squares: about the curve, and about the mean.
struct Scatter {
  double residual, total;
};

Scatter scatter(const MatrixXd& design, const VectorXd& y, const VectorXd& root_weight,
                const VectorXd& solution) {
  const VectorXd weight = root_weight.cwiseAbs2();
  const double mean = weight.dot(y) / weight.sum();
  return {(root_weight.asDiagonal() * (y - design * solution)).squaredNorm(),
          (root_weight.asDiagonal() * (y.array() - mean).matrix()).squaredNorm()};
}

}  // namespace

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

double Fit::operator()(double x) const {
  const double z = (x - scaled.centre) / scaled.scale;
  double value = 0;
  for (auto c = scaled.coefficients.rbegin(); c != scaled.coefficients.rend(); ++c) value = value * z + *c;
  return value;
}

std::optional<double> Fit::band(double x, double confidence) const {
  if (standard_errors.empty()) return std::nullopt;
  const int count = static_cast<int>(coefficients.size());
  const VectorXd p = powers((x - scaled.centre) / scaled.scale, count);
  const Eigen::Map<const MatrixXd> c(scaled.covariance.data(), count, count);
  return student_t_two_sided(confidence, degrees_of_freedom) * std::sqrt(std::max(0.0, p.dot(c * p)));
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
  const auto n = static_cast<Eigen::Index>(x.size());
  MatrixXd design(n, count);
  VectorXd values(n), root_weight = VectorXd::Ones(n);
  for (Eigen::Index i = 0; i < n; ++i) {
    const auto at = static_cast<std::size_t>(i);
    design.row(i) = powers((x[at] - fit.scaled.centre) / fit.scaled.scale, count).transpose();
    values(i) = y[at];
    if (!y_error.empty()) root_weight(i) = 1 / y_error[at];
  }
  const Eigen::ColPivHouseholderQR<MatrixXd> qr(root_weight.asDiagonal() * design);
  if (qr.rank() < count) {
    fit.failure = "the x lie too close together for a " + std::string(name(model)) + " fit";
    return fit;
  }
  const VectorXd solution = qr.solve(root_weight.asDiagonal() * values);
  const MatrixXd to_x = powers_of_x(count, fit.scaled.centre, fit.scaled.scale);
  const VectorXd coefficients = to_x * solution;
  fit.scaled.coefficients.assign(solution.begin(), solution.end());
  fit.coefficients.assign(coefficients.begin(), coefficients.end());

  fit.degrees_of_freedom = fit.points - count;
  fit.weighted = !y_error.empty();
  const Scatter sums = scatter(design, values, root_weight, solution);
  if (sums.total > 0 && fit.degrees_of_freedom > 0) fit.r2 = 1 - sums.residual / sums.total;
  double variance = 1;
  if (fit.degrees_of_freedom > 0) {
    const double reduced = sums.residual / fit.degrees_of_freedom;
    fit.residual_standard_deviation = std::sqrt(reduced);
    variance = y_error.empty() ? reduced : std::max(1.0, reduced);
  } else if (y_error.empty()) {
    return fit;
  }
  // (X^T W X)^-1 = P R^-1 R^-T P^T
  const MatrixXd r_inverse = qr.matrixR()
                                 .topLeftCorner(count, count)
                                 .template triangularView<Eigen::Upper>()
                                 .solve(MatrixXd::Identity(count, count));
  const MatrixXd half = qr.colsPermutation() * r_inverse;
  const MatrixXd covariance = variance * half * half.transpose();
  const MatrixXd in_x = to_x * covariance * to_x.transpose();
  fit.scaled.covariance = by_rows(covariance);
  fit.covariance = by_rows(in_x);
  for (int k = 0; k < count; ++k) fit.standard_errors.push_back(std::sqrt(in_x(k, k)));
  return fit;
}

}  // namespace analysis
