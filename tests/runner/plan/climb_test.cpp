// When a ladder goes on: sequences with a known limit, and what fails on the way.
#include "runner/ladder/climb.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "runner/study/ladder.hpp"

namespace mpmstudy {
namespace {

LadderRequest request(double accuracy, int cells = 7) { return {cells, accuracy, "collapsibility", true}; }
RungState rung(int k, double value, double error = 0) {
  return {true, analysis::LadderPoint{finer_cell(0.4, k), value, error}};
}
/// 0.5 - 0.1 h, the half width about 0.5 is half of 0.1 h.
std::vector<RungState> first_order(int cells) {
  std::vector<RungState> rungs;
  for (int k = 0; k < cells; ++k) rungs.push_back(rung(k, 0.5 - 0.1 * finer_cell(0.4, k)));
  return rungs;
}

TEST(Climb, EndsWhereTheIntervalIsInside) {
  // half widths over 0.5 with 4, 5, 6 cells: 1.41, 1, 0.71 %
  EXPECT_EQ(next_step(request(0.0142), first_order(4)).step, NextStep::reached);
  EXPECT_EQ(next_step(request(0.0101), first_order(4)).step, NextStep::climb);
  EXPECT_EQ(next_step(request(0.0101), first_order(5)).step, NextStep::reached);
  EXPECT_EQ(next_step(request(0.0070), first_order(6)).step, NextStep::climb);
  EXPECT_EQ(next_step(request(0.0072), first_order(6)).step, NextStep::reached);
}

TEST(Climb, EndsAtItsLimit) {
  EXPECT_EQ(next_step(request(0.001, 5), first_order(4)).step, NextStep::climb);
  EXPECT_EQ(next_step(request(0.001, 5), first_order(5)).step, NextStep::missed);
}

TEST(Climb, EndsWhereCellsDoNotHelp) {
  std::vector<RungState> rungs;
  for (int k = 0; k < 4; ++k) rungs.push_back(rung(k, 0.5, 0.02));  // a ring-down: 4 %
  EXPECT_EQ(next_step(request(0.01), rungs).step, NextStep::missed);
  EXPECT_EQ(next_step(request(0.05), rungs).step, NextStep::reached);
  rungs[3].point->measuring_error = 0.01;  // it falls
  EXPECT_EQ(next_step(request(0.01), rungs).step, NextStep::climb);
}

TEST(Climb, WaitsForEveryRung) {
  auto rungs = first_order(4);
  rungs[1] = {};
  EXPECT_EQ(next_step(request(0.5), rungs).step, NextStep::wait);
}

TEST(Climb, GoesPastAFailedCoarseCellButNotPastAFailedFinest) {
  auto rungs = first_order(4);
  rungs[0] = {true, {}};
  EXPECT_EQ(next_step(request(0.5), rungs).step, NextStep::climb) << "three cells are too few";
  rungs = first_order(5);
  rungs[0] = {true, {}};
  EXPECT_EQ(next_step(request(0.5), rungs).step, NextStep::reached);
  rungs[4] = {true, {}};
  EXPECT_EQ(next_step(request(0.5), rungs).step, NextStep::missed);
}

TEST(Climb, ASmallCollapseIsMeasuredAgainstATenth) {
  EXPECT_EQ(accuracy_scale("collapsibility", 0.02), 0.1);
  EXPECT_EQ(accuracy_scale("collapsibility", -3), 3);
  EXPECT_EQ(accuracy_scale("stop_radius_m", 1e-6), 1e-6);
  EXPECT_DOUBLE_EQ(wanted_error(request(0.01), 0.02), 0.001);
}

TEST(Climb, CollapseEndsAtOne) {
  EXPECT_EQ(bounds_of("collapsibility").upper, 1);
  EXPECT_TRUE(std::isinf(bounds_of("collapsibility").lower));
  EXPECT_EQ(bounds_of("final_area_m2").lower, 0);
  EXPECT_TRUE(std::isinf(bounds_of("stop_radius_m").lower));
}

}  // namespace
}  // namespace mpmstudy
