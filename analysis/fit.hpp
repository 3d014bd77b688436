#pragma once
/// Least squares with standard errors.
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace analysis {

enum class FitModel {
  linear,       ///< y = c0 + c1 x
  quadratic,    ///< y = c0 + c1 x + c2 x^2
  power,        ///< y = c0 x^c1, x > 0; c0 is the value at x = 1 of the unit
  exponential,  ///< y = c0 exp(c1 x)
};
bool is_polynomial(FitModel);

/// "linear", "quadratic", ...; in the order of FitModel.
std::span<const std::string_view> fit_model_names();
/// Empty for a name that is none of them.
std::optional<FitModel> fit_model(std::string_view name);
std::string_view name(FitModel);

/// A fitted curve, or why there is none. Never holds a nan.
struct Fit {
  FitModel model = FitModel::linear;
  std::string failure;  ///< why there is no fit; empty: there is one
  /// c0, c1, ... [unit of y / unit of x^k; of the other models: that of y, and 1 or 1 / unit of x]
  std::vector<double> coefficients;
  /// Of the coefficients, same units. Empty where they are unknown: as many points as coefficients and no
  /// errors.
  std::vector<double> standard_errors;
  std::vector<double> covariance;  ///< of the coefficients, by rows; empty where standard_errors is
  /// 1 - (weighted) residual / total sum of squares; empty where all y are equal, and where as many points as
  /// coefficients leave no residual to judge by.
  std::optional<double> r2;
  std::optional<double>
      residual_standard_deviation;  ///< sqrt(sum w r^2 / dof), w = 1 without errors; empty at dof 0
  int points = 0;
  int degrees_of_freedom = 0;  ///< points - coefficients
  double x_min = 0, x_max = 0;

  bool weighted = false;  ///< by the errors of y

  bool ok() const { return failure.empty(); }
  /// Weighted squares of the residuals per degree of freedom. Above 1 the points scatter more than their
  /// errors say: the model does not hold within them. Empty without errors or without a point to spare.
  std::optional<double> reduced_chi2() const;
  /// "0.9987"; "not judged (2 points, 2 coefficients)"; "" where all y are equal.
  std::string r2_text() const;
  /// The curve at x. Only where ok().
  double operator()(double x) const;
  /// Half width, at x, of the interval that covers the true curve at this confidence (of one x, not of all at
  /// once): Student's t times the standard error of the curve. Empty where standard errors are unknown.
  std::optional<double> band(double x, double confidence = 0.95) const;

  /// c0 of a power law where x counts in units of 1 / factor and y in units of 1 / y_factor, and its standard
  /// error; for captions. Only of FitModel::power where ok().
  struct Prefactor {
    double value;
    std::optional<double> standard_error;
  };
  Prefactor prefactor(double factor, double y_factor) const;

  /// The same in z = (x - centre) / scale, in which it was solved; the curve and its band are taken from
  /// here. Of a power law and an exponential: ln |y| = d0 + d1 z, for a power law with ln x in place of x.
  struct Scaled {
    double centre = 0, scale = 1;
    double sign = 1;  ///< of y
    std::vector<double> coefficients, covariance;
  } scaled;
};

/// Least squares by QR in x shifted and scaled to [-1, 1].
///
/// Without errors every point weighs the same, and standard errors follow from the scatter about the curve.
/// With errors (standard deviations of y, > 0) the weights are 1 / error^2, and the covariance (X^T W X)^-1
/// is raised by chi^2 / dof where that is above 1 (points that scatter more than their errors say, as the
/// Particle Data Group does it). Bad data give a Fit whose `failure` says what: unequal lengths, numbers that
/// are not finite, errors not positive, fewer points or fewer distinct x than coefficients. Checked against
/// certified values by tests/analysis/fit_test.cpp.
Fit fit_polynomial(FitModel, std::span<const double> x, std::span<const double> y,
                   std::span<const double> y_error = {});

/// The same for every model. A power law and an exponential are no sums of their coefficients: Gauss and
/// Newton's steps from the straight line through the logarithms make the sum of (y - curve)^2 w least, with
/// weights and standard errors as above, which are those of the curve's tangent. All y have to be of one
/// sign, of a power law all x above zero.
Fit fit_curve(FitModel, std::span<const double> x, std::span<const double> y,
              std::span<const double> y_error = {});

}  // namespace analysis
