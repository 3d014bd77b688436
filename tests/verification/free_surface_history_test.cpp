// The whole free-surface history of a planar impact against the one-dimensional reference.
#include <gtest/gtest.h>

#include "libmpm/verification/problems/problems.hpp"
#include "libmpm/verification/problems/surface_history.hpp"
#include "tests/verification/exact/csv.hpp"
#include "tests/verification/expect_numbers.hpp"

namespace {

using mpm::verification::history_distance;
using mpm::verification::HistoryDistance;

std::vector<double> reference(int speed) {
  const auto rows = read_reference("freesurface_history_1d.csv");
  const std::vector<double> times = mpm::verification::history_times();
  EXPECT_EQ(rows.size(), times.size());
  std::vector<double> speeds;
  for (std::size_t k = 0; k < rows.size(); ++k) {
    EXPECT_NEAR(number(rows[k], "t_ns") * 1e-9, times.at(k), 1e-15);
    speeds.push_back(number(rows[k], "vfs_" + std::to_string(speed) + "_m_s"));
  }
  return speeds;
}

HistoryDistance distance(int speed, double cells) {
  return history_distance(mpm::verification::surface_history(speed, {.cells = cells}), reference(speed));
}

// What differs is the width of the fronts, a few cells: the rms over the history falls with its root. The
// speed behind them is that of the reference.
TEST(FreeSurfaceHistory, At200) {
  const HistoryDistance coarse = distance(200, 2), fine = distance(200, 1);
  EXPECT_LT(coarse.whole, 0.10);
  EXPECT_LT(coarse.late, 0.005);
  EXPECT_LT(fine.whole, 0.8 * coarse.whole);
  EXPECT_LT(fine.late, 0.0015);
}

// All seven speeds of the table, and the one-dimensional code in its stead.
TEST(FreeSurfaceHistory, HoldsTheLadder) { expect_all_hold(mpm::verification::surface_history_numbers({})); }

class History : public testing::TestWithParam<int> {};
TEST_P(History, IsThatOfTheTable) {
  const std::vector<double> exact = reference(GetParam()),
                            ours = mpm::verification::surface_history(GetParam(), {});
  EXPECT_LT(history_distance(ours, exact).whole, 0.08);
  EXPECT_NEAR(ours.back() / exact.back(), 1, 0.003);
}
INSTANTIATE_TEST_SUITE_P(Speeds, History, testing::Values(20, 50, 100, 200, 500, 1120, 1500),
                         [](const auto& info) { return "u" + std::to_string(info.param); });

TEST(FreeSurfaceHistory, At1120) {
  const HistoryDistance coarse = distance(1120, 2), fine = distance(1120, 1);
  EXPECT_LT(coarse.whole, 0.08);
  EXPECT_LT(coarse.late, 0.001);
  EXPECT_LT(fine.whole, 0.75 * coarse.whole);
  EXPECT_LT(fine.late, 0.0005);
}

}  // namespace
