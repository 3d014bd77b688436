// Sequences whose limit is known.
#include "analysis/extrapolation.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

namespace analysis {
namespace {

constexpr double root2 = std::numbers::sqrt2;

/// value(cell) at cells 0.4, 0.4/r, 0.4/r^2, ... um.
template <class Value>
std::vector<LadderPoint> ladder(int cells, Value value, double ratio = root2, double error = 0) {
  std::vector<LadderPoint> points;
  for (int k = 0; k < cells; ++k) {
    const double cell = 0.4e-6 * std::pow(ratio, -k);
    points.push_back({cell, value(cell * 1e6), error});
  }
  return points;
}

TEST(Extrapolation, CleanOrderIsFound) {
  for (const double order : {0.5, 0.8, 1.0, 1.5, 2.0, 2.5}) {
    const auto e = extrapolate(ladder(
                                   4, [&](double h) { return 0.8 - 0.3 * std::pow(h, order); }, root2),
                               Bounds{});
    ASSERT_TRUE(e.observed_order) << order;
    EXPECT_NEAR(*e.observed_order, order, 1e-9);
    if (order == 0.5 || order == 2.5) continue;  // rounding decides on which side
    EXPECT_EQ(e.method, LadderMethod::observed_order);
    EXPECT_NEAR(e.extrapolated_value, 0.8, 1e-12);
    EXPECT_LE(std::abs(e.value - 0.8), e.error);
    EXPECT_EQ(e.cells, 4);
  }
}

TEST(Extrapolation, FirstOrderHasHalfOfTheWayAsHalfWidth) {
  const auto e = extrapolate(ladder(3, [](double h) { return 2 + h; }));
  const double way = 0.4 / 2;
  EXPECT_NEAR(e.extrapolated_value, 2, 1e-12);
  EXPECT_NEAR(e.extrapolated_error, way / 2, 1e-12);
  EXPECT_NEAR(e.error, 1.5 * way, 1e-12);
  EXPECT_NEAR(e.discretisation_error, e.error, 1e-15);
}

TEST(Extrapolation, UnevenRatiosAndAnyOrderOfPoints) {
  std::vector<LadderPoint> points;
  for (const double h : {0.3, 1.0, 0.45}) points.push_back({h, 5 + 2 * std::pow(h, 1.7), 0});
  const auto e = extrapolate(points);
  EXPECT_NEAR(e.observed_order.value(), 1.7, 1e-9);
  EXPECT_NEAR(e.extrapolated_value, 5, 1e-9);
  EXPECT_DOUBLE_EQ(e.value, 5 + 2 * std::pow(0.3, 1.7));
}

TEST(Extrapolation, TooFastAndTooSlowFallBackOnFirstOrder) {
  for (const double order : {0.2, 4.0}) {
    const auto value = [&](double h) { return 1 + 0.1 * std::pow(h, order); };
    const auto e = extrapolate(ladder(4, value));
    EXPECT_EQ(e.method, LadderMethod::first_order) << order;
    EXPECT_NEAR(e.observed_order.value(), order, 1e-6);
    if (order > 1) {
      EXPECT_LE(std::abs(e.value - 1), e.error);
    }
    EXPECT_GE(e.extrapolated_error, std::abs(e.extrapolated_value - e.value));
  }
  // Differences that grow are no convergence.
  const auto diverging = extrapolate(ladder(3, [](double h) { return std::log(h); }));
  EXPECT_EQ(diverging.method, LadderMethod::first_order);
  EXPECT_NEAR(diverging.observed_order.value(), 0, 1e-9);
}

TEST(Extrapolation, WhatTurnsHasItsSpread) {
  const std::vector<LadderPoint> points = {{4, 1.00, 0}, {2, 1.10, 0}, {1, 1.04, 0}};
  const auto e = extrapolate(points);
  EXPECT_EQ(e.method, LadderMethod::spread);
  EXPECT_FALSE(e.observed_order);
  EXPECT_EQ(e.extrapolated_value, 1.04);
  EXPECT_NEAR(e.error, 1.25 * 0.10, 1e-12);
  EXPECT_EQ(e.error, e.extrapolated_error);
}

TEST(Extrapolation, SaturatedValuesKeepTheirMeasuringError) {
  const auto e = extrapolate(ladder(
                                 4, [](double) { return 1.0; }, root2, 0.03),
                             {.upper = 1});
  EXPECT_EQ(e.method, LadderMethod::spread);
  EXPECT_EQ(e.extrapolated_value, 1);
  EXPECT_EQ(e.discretisation_error, 0);
  EXPECT_NEAR(e.error, 0.03, 1e-15);
}

TEST(Extrapolation, TwoCellsAreFirstOrder) {
  const auto e = extrapolate(ladder(
      2, [](double h) { return 3 - h; }, 2));
  EXPECT_EQ(e.method, LadderMethod::first_order);
  EXPECT_FALSE(e.observed_order);
  EXPECT_NEAR(e.extrapolated_value, 3, 1e-12);
  EXPECT_NEAR(e.extrapolated_error, 0.2, 1e-12);
  EXPECT_NEAR(e.error, 0.4, 1e-12);
}

TEST(Extrapolation, OneCellHasTheCallersEstimate) {
  const auto e = extrapolate(ladder(
                                 1, [](double) { return 7.0; }, root2, 0.3),
                             {}, 0.4);
  EXPECT_EQ(e.method, LadderMethod::one_cell);
  EXPECT_NEAR(e.error, 0.5, 1e-15);
  EXPECT_NEAR(e.discretisation_error, 0.4, 1e-12);
  EXPECT_EQ(e.measuring_error, 0.3);
  EXPECT_EQ(name(e.method), "one cell");
}

TEST(Extrapolation, PartsAddInQuadratureAndTheLargestOfThreeCounts) {
  auto points = ladder(4, [](double h) { return 2 + h; });
  points[0].measuring_error = 9;  // the coarsest of four: not among the three
  points[1].measuring_error = 0.3;
  const auto e = extrapolate(points);
  EXPECT_EQ(e.measuring_error, 0.3);
  const double half = 0.5 * 0.4 / std::pow(root2, 3);
  EXPECT_NEAR(e.extrapolated_error, std::hypot(half, 0.3), 1e-12);
}

TEST(Extrapolation, BoundsEndIntervals) {
  const auto value = [](double h) { return 1.01 - 0.275 * h; };
  const auto e = extrapolate(ladder(3, value, 2), {.upper = 1});
  EXPECT_EQ(e.extrapolated_value, 1);
  EXPECT_NEAR(e.error, 1 - e.value, 1e-12);  // not one and a half of the way
  EXPECT_NEAR(e.extrapolated_error, 0.5 * (1 - e.value), 1e-12);
}

TEST(Extrapolation, IsAffine) {
  for (const auto& value : {+[](double h) { return 0.3 + h; }, +[](double h) { return 0.3 + h * h * h * h; },
                            +[](double h) { return std::sin(20 * h); }}) {
    const auto shares = extrapolate(ladder(4, value, root2, 0.01));
    const auto areas = extrapolate(ladder(
        4, [&](double h) { return 4 * (1 - value(h)); }, root2, 0.04));
    EXPECT_EQ(areas.method, shares.method);
    EXPECT_NEAR(areas.error, 4 * shares.error, 1e-12);
    EXPECT_NEAR(areas.extrapolated_value, 4 * (1 - shares.extrapolated_value), 1e-12);
  }
}

TEST(Extrapolation, ScalesWithPowersOfTwoBitForBit) {
  const auto value = [](double h) { return 0.31 + 0.77 * std::pow(h, 1.3); };
  auto points = ladder(4, value);
  const auto e = extrapolate(points);
  for (auto& p : points) p.cell *= 4, p.value *= 8;
  const auto scaled = extrapolate(points);
  EXPECT_EQ(scaled.extrapolated_value, 8 * e.extrapolated_value);
  EXPECT_EQ(scaled.error, 8 * e.error);
  EXPECT_EQ(scaled.observed_order, e.observed_order);
}

TEST(Extrapolation, RefusesWhatIsNoLadder) {
  EXPECT_THROW(extrapolate({}), std::invalid_argument);
  const std::vector<LadderPoint> twice = {{1, 1, 0}, {1, 2, 0}};
  EXPECT_THROW(extrapolate(twice), std::invalid_argument);
  const std::vector<LadderPoint> zero = {{0, 1, 0}};
  EXPECT_THROW(extrapolate(zero), std::invalid_argument);
}

}  // namespace
}  // namespace analysis
