#include "analysis/fit.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <limits>

namespace {

using analysis::Fit;
using analysis::fit_polynomial;
using analysis::FitModel;
using testing::HasSubstr;

using Numbers = std::vector<double>;

void expect_relative(double value, double expected, double tolerance) {
  EXPECT_NEAR(value, expected, tolerance * std::abs(expected));
}

/// NIST Statistical Reference Datasets, Norris (linear, 36 points): data and certified values of
/// https://www.itl.nist.gov/div898/strd/lls/data/Norris.shtml
TEST(Fit, NistNorris) {
  const Numbers x = {0.2, 337.4, 118.2, 884.6, 10.1,  226.5, 666.3, 996.3, 448.6, 777.0, 558.2, 0.4,
                     0.6, 775.5, 666.9, 338.0, 447.5, 11.6,  556.0, 228.1, 995.8, 887.6, 120.2, 0.3,
                     0.3, 556.8, 339.1, 887.2, 999.0, 779.0, 11.1,  118.3, 229.2, 669.1, 448.9, 0.5};
  const Numbers y = {0.1, 338.8, 118.1, 888.0, 9.2,   228.1, 668.5, 998.5, 449.1, 778.9, 559.2, 0.3,
                     0.1, 778.1, 668.8, 339.3, 448.9, 10.8,  557.7, 228.3, 998.0, 888.8, 119.6, 0.3,
                     0.6, 557.6, 339.3, 888.0, 998.5, 778.9, 10.2,  117.6, 228.9, 668.4, 449.2, 0.2};
  const Fit fit = fit_polynomial(FitModel::linear, x, y);
  ASSERT_TRUE(fit.ok()) << fit.failure;
  expect_relative(fit.coefficients[0], -0.262323073774029, 1e-11);
  expect_relative(fit.coefficients[1], 1.00211681802045, 1e-13);
  expect_relative(fit.standard_errors[0], 0.232818234301152, 1e-11);
  expect_relative(fit.standard_errors[1], 0.429796848199937e-3, 1e-11);
  expect_relative(*fit.residual_standard_deviation, 0.884796396144373, 1e-11);
  expect_relative(*fit.r2, 0.999993745883712, 1e-13);
  EXPECT_EQ(fit.degrees_of_freedom, 34);
}

/// The same source, Pontius (quadratic, 40 points, x up to three million):
/// https://www.itl.nist.gov/div898/strd/lls/data/Pontius.shtml
TEST(Fit, NistPontius) {
  Numbers x;
  for (int replicate = 0; replicate < 2; ++replicate)
    for (int i = 1; i <= 20; ++i) x.push_back(150000.0 * i);
  const Numbers y = {.11019,  .21956,  .32949,  .43899,  .54803,  .65694,  .76562,  .87487,
                     .98292,  1.09146, 1.20001, 1.30822, 1.41599, 1.52399, 1.63194, 1.73947,
                     1.84646, 1.95392, 2.06128, 2.16844, .11052,  .22018,  .32939,  .43886,
                     .54798,  .65739,  .76596,  .87474,  .98300,  1.09150, 1.20004, 1.30818,
                     1.41613, 1.52408, 1.63159, 1.73965, 1.84696, 1.95445, 2.06177, 2.16829};
  const Fit fit = fit_polynomial(FitModel::quadratic, x, y);
  ASSERT_TRUE(fit.ok()) << fit.failure;
  expect_relative(fit.coefficients[0], 0.673565789473684e-3, 1e-10);
  expect_relative(fit.coefficients[1], 0.732059160401003e-6, 1e-12);
  expect_relative(fit.coefficients[2], -0.316081871345029e-14, 1e-10);
  expect_relative(fit.standard_errors[0], 0.107938612033077e-3, 1e-10);
  expect_relative(fit.standard_errors[1], 0.157817399981659e-9, 1e-10);
  expect_relative(fit.standard_errors[2], 0.486652849992036e-16, 1e-10);
  expect_relative(*fit.residual_standard_deviation, 0.205177424076185e-3, 1e-10);
  expect_relative(*fit.r2, 0.999999900178537, 1e-13);
}

/// One point at x = 0 and a pair at x = 1: by hand.
TEST(Fit, WeightsAreInverseSquaresOfErrors) {
  // Weighted mean of the pair at x = 1 is (3 + 5)/2 = 4 with variance 2; y(0) = 1 with variance 1.
  const Numbers x = {0, 1, 1}, y = {1, 3, 5}, error = {1, 2, 2};
  const Fit fit = fit_polynomial(FitModel::linear, x, y, error);
  ASSERT_TRUE(fit.ok());
  EXPECT_NEAR(fit.coefficients[0], 1, 1e-14);
  EXPECT_NEAR(fit.coefficients[1], 3, 1e-14);
  // chi^2 / dof = (1/4 + 1/4) / 1 is below one: the errors stand as they are.
  EXPECT_NEAR(*fit.residual_standard_deviation, std::sqrt(0.5), 1e-14);
  EXPECT_NEAR(fit.standard_errors[0], 1, 1e-14);
  EXPECT_NEAR(fit.standard_errors[1], std::sqrt(3), 1e-14);
  EXPECT_NEAR(fit.covariance[1], -1, 1e-14);
  EXPECT_NEAR(fit.covariance[2], -1, 1e-14);
}

TEST(Fit, ScatterBeyondTheErrorsRaisesTheStandardErrors) {
  const Numbers x = {0, 1, 1}, y = {1, 3, 5}, error = {0.1, 0.2, 0.2};  // chi^2 / dof = 50
  const Fit fit = fit_polynomial(FitModel::linear, x, y, error);
  EXPECT_NEAR(fit.standard_errors[1], std::sqrt(50.0) * std::sqrt(0.03), 1e-13);
}

TEST(Fit, BandAtAPointIsItsStandardErrorTimesStudent) {
  const Numbers x = {0, 1, 2, 3, 4}, y = {0.1, 0.9, 2.2, 2.8, 4.1};
  const Fit fit = fit_polynomial(FitModel::linear, x, y);
  // Var(y(x)) = s^2 (1/n + (x - mean)^2 / Sxx); Sxx = 10, dof 3.
  const double s = *fit.residual_standard_deviation;
  EXPECT_NEAR(*fit.band(2), 3.182446 * s * std::sqrt(0.2), 1e-6);
  EXPECT_NEAR(*fit.band(4), 3.182446 * s * std::sqrt(0.2 + 0.4), 1e-6);
}

TEST(Fit, IsTheSameInAnyUnits) {
  const Numbers x = {1.0, 1.5, 2.0, 2.5}, y = {0.92, 0.81, 0.65, 0.5};
  Numbers x_si;
  for (const double v : x) x_si.push_back(v * 0x1p-20);
  const Fit fit = fit_polynomial(FitModel::quadratic, x, y),
            si = fit_polynomial(FitModel::quadratic, x_si, y);
  for (int k = 0; k < 3; ++k) {
    EXPECT_EQ(si.coefficients[k], std::ldexp(fit.coefficients[k], 20 * k));
    EXPECT_EQ(si.standard_errors[k], std::ldexp(fit.standard_errors[k], 20 * k));
  }
  EXPECT_EQ(*si.r2, *fit.r2);
}

TEST(Fit, AsManyPointsAsCoefficientsIsACurveWithoutErrors) {
  const Numbers x = {1, 2, 3}, y = {1, 4, 9};
  const Fit fit = fit_polynomial(FitModel::quadratic, x, y);
  ASSERT_TRUE(fit.ok());
  EXPECT_NEAR(fit.coefficients[2], 1, 1e-13);
  EXPECT_NEAR(fit(4), 16, 1e-12);
  EXPECT_TRUE(fit.standard_errors.empty());
  EXPECT_FALSE(fit.band(2));
  EXPECT_FALSE(fit.residual_standard_deviation);
  EXPECT_FALSE(fit.r2);
  EXPECT_EQ(fit.r2_text(), "not judged (3 points, 3 coefficients)");
}

TEST(Fit, KnownErrorsServeWhereNoPointIsLeftOver) {
  const Numbers x = {0, 1}, y = {0, 1}, error = {3, 4};
  const Fit fit = fit_polynomial(FitModel::linear, x, y, error);
  EXPECT_NEAR(fit.standard_errors[1], 5, 1e-13);
  EXPECT_FALSE(fit.r2);
}

TEST(Fit, ConstantDataHaveNoR2) {
  const Numbers x = {0, 1, 2}, y = {5, 5, 5};
  const Fit fit = fit_polynomial(FitModel::linear, x, y);
  ASSERT_TRUE(fit.ok());
  EXPECT_FALSE(fit.r2);
  EXPECT_EQ(fit.r2_text(), "");
}

TEST(Fit, SaysWhyThereIsNone) {
  const double nan = std::numeric_limits<double>::quiet_NaN();
  const auto problem = [](const Numbers& x, const Numbers& y, const Numbers& e = {}) {
    const Fit fit = fit_polynomial(FitModel::quadratic, x, y, e);
    EXPECT_TRUE(fit.coefficients.empty());
    return fit.failure;
  };
  EXPECT_THAT(problem({}, {}), HasSubstr("needs at least 3 points; there are 0"));
  EXPECT_THAT(problem({1, 2}, {1, 2}), HasSubstr("needs at least 3 points; there are 2"));
  EXPECT_THAT(problem({1, 1, 2, 2}, {1, 2, 3, 4}), HasSubstr("3 different x; there are 2"));
  EXPECT_THAT(problem({7, 7, 7}, {1, 2, 3}), HasSubstr("3 different x; there are 1"));
  EXPECT_THAT(problem({1, 2, 3}, {1, 2}), HasSubstr("unequal lengths"));
  EXPECT_THAT(problem({1, 2, nan}, {1, 2, 3}), HasSubstr("an x is not finite"));
  EXPECT_THAT(problem({1, 2, 3}, {1, 2, nan}), HasSubstr("a y is not finite"));
  EXPECT_THAT(problem({1, 2, 3}, {1, 2, 3}, {1, 0, 1}), HasSubstr("not a positive number"));
}

// A power law and an exponential.

/// NIST StRD, nonlinear regression, DanWood: y = b1 x^b2; certified to 11 digits.
TEST(FitCurve, PowerIsThatOfNist) {
  const Numbers x = {1.309, 1.471, 1.490, 1.565, 1.611, 1.680},
                y = {2.138, 3.421, 3.597, 4.340, 4.882, 5.660};
  const Fit fit = fit_curve(FitModel::power, x, y);
  ASSERT_TRUE(fit.ok()) << fit.failure;
  EXPECT_NEAR(fit.coefficients[0], 7.6886226176E-01, 1e-10);
  EXPECT_NEAR(fit.coefficients[1], 3.8604055871E+00, 1e-9);
  EXPECT_NEAR(fit.standard_errors[0], 1.8281973860E-02, 1e-10);
  EXPECT_NEAR(fit.standard_errors[1], 5.1726610913E-02, 1e-10);
  EXPECT_NEAR(*fit.residual_standard_deviation, 3.2853114039E-02, 1e-11);
  EXPECT_NEAR(fit(1.5), 0.76886226176 * std::pow(1.5, 3.8604055871), 1e-9);
}

/// In X = exp(x) the exponential in x is a power law: the same curve, the same errors.
TEST(FitCurve, ExponentialIsThePowerLawOfItsExponential) {
  const Numbers x = {0.3, 0.8, 1.1, 1.9, 2.4, 3.3}, y = {-2.1, -3.0, -4.2, -7.7, -11.9, -26},
                error = {0.2, 0.2, 0.3, 0.4, 0.5, 2};
  Numbers to_power;
  for (const double v : x) to_power.push_back(std::exp(v));
  for (const auto& weights : {Numbers{}, error}) {
    const Fit exponential = fit_curve(FitModel::exponential, x, y, weights),
              power = fit_curve(FitModel::power, to_power, y, weights);
    ASSERT_TRUE(exponential.ok()) << exponential.failure;
    for (std::size_t k = 0; k < 2; ++k) {
      EXPECT_NEAR(exponential.coefficients[k] / power.coefficients[k], 1, 1e-9);
      EXPECT_NEAR(exponential.standard_errors[k] / power.standard_errors[k], 1, 1e-7);
    }
    EXPECT_NEAR(exponential(2) / power(std::exp(2)), 1, 1e-9);
    EXPECT_NEAR(*exponential.band(2) / *power.band(std::exp(2)), 1, 1e-7);
  }
}

/// The weighted sum of squares does not fall to either side.
TEST(FitCurve, IsTheLeastSumOfSquares) {
  const Numbers x = {1, 2, 3, 5, 8}, y = {10, 7.5, 5.2, 3.3, 1.2}, error = {0.5, 0.2, 0.4, 0.1, 0.3};
  const Fit fit = fit_curve(FitModel::exponential, x, y, error);
  ASSERT_TRUE(fit.ok());
  const auto sum = [&](double c0, double c1) {
    double squares = 0;
    for (std::size_t i = 0; i < x.size(); ++i)
      squares += std::pow((y[i] - c0 * std::exp(c1 * x[i])) / error[i], 2);
    return squares;
  };
  const double c0 = fit.coefficients[0], c1 = fit.coefficients[1], least = sum(c0, c1);
  for (const double step : {-1e-4, 1e-4}) {
    EXPECT_GT(sum(c0 * (1 + step), c1), least);
    EXPECT_GT(sum(c0, c1 * (1 + step)), least);
    EXPECT_GT(sum(c0 * (1 + step), c1 * (1 + step)), least);
  }
  EXPECT_NEAR(*fit.reduced_chi2(), least / 3, 1e-9);
}

TEST(FitCurve, PrefactorIsInTheUnitsOfTheAxes) {
  const Numbers x = {1e-6, 1.5e-6, 2e-6, 2.5e-6}, y = {3e6, 4.4e6, 6.1e6, 7.2e6};
  Numbers in_um, in_mpa;
  for (const double v : x) in_um.push_back(v * 1e6);
  for (const double v : y) in_mpa.push_back(v * 1e-6);
  const Fit si = fit_curve(FitModel::power, x, y), shown = fit_curve(FitModel::power, in_um, in_mpa);
  const auto prefactor = si.prefactor(1e6, 1e-6);
  EXPECT_NEAR(prefactor.value, shown.coefficients[0], 1e-9);
  EXPECT_NEAR(*prefactor.standard_error / shown.standard_errors[0], 1, 1e-6);
}

TEST(FitCurve, SaysWhyThereIsNone) {
  EXPECT_THAT(fit_curve(FitModel::power, Numbers{0, 1, 2}, Numbers{1, 2, 3}).failure,
              HasSubstr("not all above zero"));
  EXPECT_THAT(fit_curve(FitModel::power, Numbers{1, 2, 3}, Numbers{1, -2, 3}).failure,
              HasSubstr("not all of one sign"));
  EXPECT_THAT(fit_curve(FitModel::exponential, Numbers{1}, Numbers{1}).failure,
              HasSubstr("an exponential fit needs at least 2 points; there are 1"));
}

}  // namespace
