// The whole free-surface history of a planar impact against the one-dimensional reference.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "tests/libmpm/exact/csv.hpp"
#include "tests/libmpm/scenes.hpp"

namespace {

/// Speed of the free surface against the moving body, at the times of the snapshots.
struct TopSpeed : mpm::Observer {
  explicit TopSpeed(double u) : impact_speed(u) {}
  void on_snapshot(const mpm::Snapshot& s) override {
    if (speeds.empty()) top = std::max_element(s.y.begin(), s.y.end()) - s.y.begin();
    speeds.push_back(s.velocity_y[static_cast<std::size_t>(top)] + impact_speed);
  }
  double impact_speed;
  std::ptrdiff_t top = 0;
  std::vector<double> speeds;
};

/// Root mean square difference over the history, and over what follows 2.2 ns (all waves are out by then);
/// both over the largest speed.
struct Difference {
  double whole, late;
};

Difference difference(double impact_speed, const std::string& column, double cell) {
  const auto rows = read_reference("freesurface_history_1d.csv");
  mpm::Scene s = scenes::planar(impact_speed, 10e-6, cell, 2.6e-9);
  for (const CsvRow& row : rows)
    s.measures.snapshots.push_back(std::min(number(row, "t_ns") * 1e-9, s.end_time));
  TopSpeed top(impact_speed);
  EXPECT_EQ(mpm::run(s, top).status, mpm::RunStatus::done);
  EXPECT_EQ(top.speeds.size(), rows.size());
  double whole = 0, late = 0, late_count = 0, largest = 0;
  for (std::size_t k = 0; k < std::min(rows.size(), top.speeds.size()); ++k) {
    const double exact = number(rows[k], column), d = top.speeds[k] - exact;
    largest = std::max(largest, exact);
    whole += d * d;
    if (number(rows[k], "t_ns") > 2.2) late += d * d, ++late_count;
  }
  return {std::sqrt(whole / static_cast<double>(rows.size())) / largest,
          std::sqrt(late / late_count) / largest};
}

// What differs is the width of the fronts, a few cells: the rms over the history falls with its root. The
// speed behind them is that of the reference.
TEST(FreeSurfaceHistory, At200) {
  const Difference coarse = difference(200, "vfs_200_m_s", 0.1e-6),
                   fine = difference(200, "vfs_200_m_s", 0.05e-6);
  EXPECT_LT(coarse.whole, 0.10);
  EXPECT_LT(coarse.late, 0.005);
  EXPECT_LT(fine.whole, 0.8 * coarse.whole);
  EXPECT_LT(fine.late, 0.0015);
}

TEST(FreeSurfaceHistory, At1120) {
  const Difference coarse = difference(1120, "vfs_1120_m_s", 0.1e-6),
                   fine = difference(1120, "vfs_1120_m_s", 0.05e-6);
  EXPECT_LT(coarse.whole, 0.08);
  EXPECT_LT(coarse.late, 0.001);
  EXPECT_LT(fine.whole, 0.75 * coarse.whole);
  EXPECT_LT(fine.late, 0.0005);
}

}  // namespace
