#include "runner/finish/surface.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "analysis/sobol_indices.hpp"
#include "runner/study/quasi_random.hpp"

namespace mpmstudy {
namespace {

using std::numbers::pi;

double at_pi(double share) { return pi * (2 * share - 1); }

/// [Ishigami, Homma 1990], a = 7, b = 0.1, over [-pi, pi]^3.
double ishigami(const Eigen::VectorXd& x) {
  return std::sin(x(0)) + 7 * std::pow(std::sin(x(1)), 2) + 0.1 * std::pow(x(2), 4) * std::sin(x(0));
}
/// From its variance a^2 / 8 + b pi^4 / 5 + b^2 pi^8 / 18 + 1 / 2 and the parts of it.
const double variance = 49.0 / 8 + 0.1 * std::pow(pi, 4) / 5 + 0.01 * std::pow(pi, 8) / 18 + 0.5;
const double alone = 0.5 * std::pow(1 + 0.1 * std::pow(pi, 4) / 5, 2) / variance,
             second = 49.0 / 8 / variance, together = 0.01 * std::pow(pi, 8) * 8 / 225 / variance;
const std::vector<double> first_indices = {alone, second, 0},
                          total_indices = {alone + together, second, together};

TEST(SobolIndices, AreThoseOfTheIshigamiFunction) {
  const auto shares = sobol_points(8192, 6, 1);
  Eigen::MatrixXd a(8192, 3), b(8192, 3);
  for (Eigen::Index i = 0; i < 8192; ++i)
    for (Eigen::Index k = 0; k < 3; ++k) {
      const auto& point = shares[static_cast<std::size_t>(i)];
      a(i, k) = at_pi(point[static_cast<std::size_t>(k)]);
      b(i, k) = at_pi(point[static_cast<std::size_t>(k) + 3]);
    }
  const auto indices = analysis::sobol_indices(ishigami, a, b);
  for (std::size_t k = 0; k < 3; ++k) {
    EXPECT_NEAR(indices.first[k], first_indices[k], 0.01) << k;
    EXPECT_NEAR(indices.total[k], total_indices[k], 0.01) << k;
  }
  EXPECT_NEAR(indices.mean, 3.5, 0.01);
  EXPECT_NEAR(indices.deviation, std::sqrt(variance), 0.02);
}

/// By a surface through a few hundred runs, within its intervals.
TEST(Sensitivity, HoldsTheIndicesOfTheIshigamiFunction) {
  constexpr std::size_t runs = 200;
  const auto shares = sobol_points(runs, 3, 2);
  Eigen::MatrixXd points(runs, 3);
  std::vector<double> values;
  for (std::size_t i = 0; i < runs; ++i) {
    for (std::size_t k = 0; k < 3; ++k)
      points(static_cast<Eigen::Index>(i), static_cast<Eigen::Index>(k)) = at_pi(shares[i][k]);
    values.push_back(ishigami(points.row(static_cast<Eigen::Index>(i)).transpose()));
  }
  const analysis::GaussianProcess process(points, values);
  ASSERT_TRUE(process.ok());
  const Sensitivity s = sensitivity_of(process, {at_pi, at_pi, at_pi});
  const auto holds = [](const Estimate& e, double truth) {
    EXPECT_LE(e.low, truth + 1e-3);
    EXPECT_GE(e.high, truth - 1e-3);
    EXPECT_LT(e.high - e.low, 0.3);
    EXPECT_LE(e.low, e.value);
    EXPECT_GE(e.high, e.value);
  };
  for (std::size_t k = 0; k < 3; ++k) {
    SCOPED_TRACE(k);
    holds(s.first[k], first_indices[k]);
    holds(s.total[k], total_indices[k]);
  }
  EXPECT_NEAR(s.mean.value, 3.5, 0.2);
  // What is left of the function where all but one of its inputs are drawn: sin x (1 + 0.1 pi^4 / 5) + 3.5,
  // 7 sin^2 x, 3.5.
  for (std::size_t k = 0; k < 3; ++k) {
    ASSERT_EQ(s.effects[k].inputs.size(), 9u);
    for (std::size_t i = 0; i < 9; ++i) {
      const double x = s.effects[k].inputs[i], sine = std::sin(x);
      const double truth = k == 0   ? sine * (1 + 0.1 * std::pow(pi, 4) / 5) + 3.5
                           : k == 1 ? 7 * sine * sine
                                    : 3.5;
      EXPECT_NEAR(s.effects[k].results[i].value, truth, 0.7) << k << " at " << x;
      EXPECT_LE(s.effects[k].results[i].low, s.effects[k].results[i].value);
      EXPECT_GE(s.effects[k].results[i].high, s.effects[k].results[i].value);
    }
  }
}

TEST(RankCorrelation, OfOrderedAndOfTiedValues) {
  EXPECT_DOUBLE_EQ(analysis::rank_correlation({1, 2, 30}, {5, 6, 7}), 1);
  EXPECT_DOUBLE_EQ(analysis::rank_correlation({1, 2, 30}, {7, 6, 5}), -1);
  EXPECT_DOUBLE_EQ(analysis::rank_correlation({1, 2, 3}, {4, 4, 4}), 0);
  EXPECT_NEAR(analysis::rank_correlation({1, 2, 3, 4}, {1, 1, 2, 2}), 4 / std::sqrt(20), 1e-12);
}

}  // namespace
}  // namespace mpmstudy
