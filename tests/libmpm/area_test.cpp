// The two measures of a cavity's area.
#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "libmpm/measure/contour.hpp"
#include "libmpm/measure/void_area.hpp"
#include "libmpm/scene/build.hpp"
#include "tests/libmpm/scenes.hpp"

namespace {

double circle(double r) { return std::numbers::pi * r * r; }

// 30 cells across: both measures return pi R^2 to 0.2 %, wherever the centre lies in its cell.
TEST(CavityArea, AtRestIsThatOfTheCircle) {
  for (const double radius : {1.5e-6, 1.47e-6, 1.53e-6})
    for (const double height : {1.9e-6, 1.93e-6, 1.95e-6})
      for (const int ppc : {1, 4, 9})
        for (const auto symmetry : {mpm::Symmetry::half, mpm::Symmetry::full}) {
          mpm::Scene s = scenes::cavity(0.1e-6);
          s.cavity_radius = radius;
          s.cavity_center_height = height;
          s.numerics.particles_per_cell = ppc;
          s.numerics.symmetry = symmetry;
          const mpm::State state = mpm::build_state(s);
          const bool full = symmetry == mpm::Symmetry::full;
          mpm::VoidArea measure(mpm::Vec2(0, height), radius, full, ppc);
          EXPECT_NEAR(measure.update(state) / circle(radius), 1, 2e-3)
              << radius << ' ' << height << ' ' << ppc;
          EXPECT_FALSE(measure.joined_outside());
          EXPECT_FALSE(measure.touches_wall());
          const mpm::Contour contour(mpm::Vec2(0, height), radius, 0.1e-6, !full);
          EXPECT_NEAR(contour.area() / circle(radius), 1, 1e-12);
          EXPECT_NEAR(contour.lower_upper_ratio(), 1, 1e-12);
          EXPECT_NEAR(contour.width() / contour.height(), 1, 1e-3);
          EXPECT_NEAR(contour.centroid().y(), height, 1e-12 * height);
        }
}

TEST(CavityArea, AGrooveIsJoinedToTheOutside) {
  mpm::Scene s = scenes::cavity(0.1e-6);
  s.cavity_center_height = 3.5e-6;  // tangent to the free surface
  s.numerics.cell_size = 0.1e-6;
  mpm::VoidArea measure(mpm::Vec2(0, 3.5e-6), 1.5e-6, false, 4);
  measure.update(mpm::build_state(s));
  EXPECT_TRUE(measure.joined_outside());
}

TEST(CavityArea, ATangentCavityTouchesTheWall) {
  mpm::Scene s = scenes::cavity(0.1e-6);
  s.cavity_center_height = 1.5e-6;
  mpm::VoidArea measure(mpm::Vec2(0, 1.5e-6), 1.5e-6, false, 4);
  measure.update(mpm::build_state(s));
  EXPECT_TRUE(measure.touches_wall());
  EXPECT_FALSE(measure.joined_outside());
}

// In a uniform flow the contour moves with it and keeps its area.
TEST(Contour, MovesWithTheGrid) {
  mpm::Grid grid(mpm::Vec2(0, 0), mpm::Vec2(1, 1), 20);
  grid.grow_to_row(30);
  for (mpm::Node& n : grid.nodes()) n.mass = 1, n.velocity = mpm::Vec2(0, 2);
  mpm::Contour contour(mpm::Vec2(0, 10), 5, 1, true);
  const double area = contour.area();
  contour.advance(grid, 0.5);
  EXPECT_NEAR(contour.centroid().y(), 11, 1e-12);
  EXPECT_NEAR(contour.area() / area, 1, 1e-12);
}

// The void and the contour see the same collapse.
TEST(CavityArea, BothMeasuresAgreeDuringTheCollapse) {
  mpm::Scene s = scenes::cavity(0.1e-6);
  s.end_time = 2.5e-9;
  const mpm::RunResult r = mpm::run(s);
  ASSERT_EQ(r.status, mpm::RunStatus::done);
  EXPECT_LT(r.area_history.back().area, 0.6 * circle(1.5e-6));
  for (const mpm::AreaSample& a : r.area_history)
    EXPECT_NEAR(a.void_area, a.area, 0.003 * circle(1.5e-6)) << a.time;
}

// A jet that meets the far side makes the contour cross itself: from then on the void's area counts.
TEST(CavityArea, ACrossedContourIsNotReported) {
  mpm::Scene s = scenes::cavity(0.2e-6);
  s.impact_speed = 1120;
  s.end_time = 1.4e-9;
  const mpm::RunResult r = mpm::run(s);
  ASSERT_EQ(r.status, mpm::RunStatus::done);
  EXPECT_GT(scenes::metric(r, "contour_crossed_time_s"), 0.5e-9);
  EXPECT_TRUE(std::isnan(scenes::metric(r, "lower_upper_area_ratio")));
  double sum = 0, count = 0;
  for (const mpm::AreaSample& a : r.area_history)
    if (a.time >= 0.75 * s.end_time) sum += a.void_area, ++count;
  EXPECT_LT(scenes::metric(r, "contour_crossed_time_s"), 0.75 * s.end_time);
  EXPECT_NEAR(*r.final_area / (sum / count), 1, 1e-12);

  const mpm::RunResult open = mpm::run(scenes::cavity(0.2e-6));
  EXPECT_TRUE(std::isnan(scenes::metric(open, "contour_crossed_time_s")));
  EXPECT_GT(scenes::metric(open, "lower_upper_area_ratio"), 0);
}

}  // namespace
