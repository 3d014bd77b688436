#include "libmpm/verification/problems/surface_history.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <string>

#include "libmpm/verification/exact/lagrangian_1d.hpp"
#include "libmpm/verification/problems/problems.hpp"
#include "libmpm/verification/problems/scenes.hpp"
#include "libmpm/verification/problems/with_options.hpp"

namespace mpm::verification {
namespace {

constexpr double height = 10e-6, end = 2.6e-9, interval = 5e-12, waves_are_out = 2.2e-9;

/// Speed of the highest particle against the moving body, at the times of the snapshots.
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

}  // namespace

std::vector<double> history_times() {
  std::vector<double> times;
  for (int k = 0; k < std::lround(end / interval); ++k) times.push_back(k * interval);
  times.push_back(end);
  return times;
}

std::vector<double> surface_history(double impact_speed, const ExactOptions& options) {
  mpm::Scene scene =
      with_options(scenes::planar(impact_speed, height, 0.05e-6 * options.cells, end), options);
  scene.measures.snapshots = history_times();
  TopSpeed top(impact_speed);
  mpm::run(scene, top);
  return top.speeds;
}

std::vector<double> reference_history(double impact_speed, int cells) {
  const auto solid = scenes::exact_solid(mpm::named_material("aluminium"));
  std::vector<double> speeds;
  for (const auto& s : exact::impact_history(solid, impact_speed, height, cells, history_times()))
    speeds.push_back(s.surface_speed);
  return speeds;
}

HistoryDistance history_distance(const std::vector<double>& ours, const std::vector<double>& exact) {
  constexpr double nan = std::numeric_limits<double>::quiet_NaN();
  const std::vector<double> times = history_times();
  if (ours.size() != times.size() || exact.size() != times.size()) return {nan, nan};
  double whole = 0, late = 0, count = 0, largest = 0;
  for (std::size_t k = 0; k < times.size(); ++k) {
    const double square = (ours[k] - exact[k]) * (ours[k] - exact[k]);
    largest = std::max(largest, exact[k]);
    whole += square;
    if (times[k] > waves_are_out) late += square, ++count;
  }
  return {std::sqrt(whole / static_cast<double>(times.size())) / largest, std::sqrt(late / count) / largest};
}

ExactNumbers surface_history_numbers(const ExactOptions& options) {
  constexpr int reference_cells = 1000;
  ExactNumbers numbers;
  for (const int speed : {20, 50, 100, 200, 500, 1120, 1500}) {
    const auto ours = surface_history(speed, options), exact = reference_history(speed, reference_cells);
    const std::string at = " at " + std::to_string(speed) + " m/s";
    numbers.push_back(
        {"rms difference" + at, "1", 0, history_distance(ours, exact).whole, 0.08, Judged::absolute});
    const double last = ours.size() == exact.size() ? ours.back() : std::numeric_limits<double>::quiet_NaN();
    numbers.push_back({"free-surface speed after 2.6 ns" + at, "m/s", exact.back(), last, 0.003});
  }
  return numbers;
}

}  // namespace mpm::verification
