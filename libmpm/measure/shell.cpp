#include "libmpm/measure/shell.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "libmpm/measure/markers.hpp"
#include "libmpm/scene/build.hpp"

namespace mpm {
namespace {

constexpr ResultRow rows[] = {
    {.name = "stop_radius_m",
     .unit = "m",
     .meaning = "inner radius at which the shell stopped",
     .always = false},
    {.name = "stop_time_s", .unit = "s", .symbol = "t", .meaning = "when it did", .always = false},
    {.name = "roundness",
     .unit = "1",
     .meaning = "(largest - smallest) / mean inner radius then: 0 is round",
     .lower = 0,
     .always = false},
};

constexpr double share_after_stop = 1.3;

/// The lowest point of the parabola through three points: abscissa and ordinate.
Vec2 lowest(const double* t, const double* y) {
  const double left = (y[1] - y[0]) / (t[1] - t[0]), right = (y[2] - y[1]) / (t[2] - t[1]);
  const double curvature = (right - left) / (t[2] - t[0]);  // half the second derivative
  const double slope = left + curvature * (t[1] - t[0]);    // at the middle point
  if (!(curvature > 0)) return {t[1], y[1]};
  const double shift = -0.5 * slope / curvature;
  return {t[1] + shift, y[1] + 0.5 * slope * shift};
}

}  // namespace

std::span<const ResultRow> Shell::results() { return rows; }

Shell::Shell(const Scene& s, const State&)
    : center_(lattice_of(s).center), times_{0}, radii_{s.inner_radius} {
  // Four markers per cell, none on a mirror; those of a quarter are among those of the ring.
  const bool quarter = s.numerics.symmetry == Symmetry::half;
  const double right_angle = std::numbers::pi / 2;
  const int steps =
      std::max(16, static_cast<int>(std::ceil(4 * right_angle * s.inner_radius / s.numerics.cell_size)));
  for (int k = 0; k < (quarter ? steps : 4 * steps); ++k) {
    const double angle = (k + 0.5) * right_angle / steps;
    markers_.push_back(center_ + s.inner_radius * Vec2(std::cos(angle), std::sin(angle)));
  }
}

void Shell::after_step(const State& s, const StepReport&, double dt) {
  move_markers(markers_, s.grid, dt);
  double sum = 0, least = 0, most = 0;
  for (const Vec2& x : markers_) {
    const double r = (x - center_).norm();
    least = sum == 0 ? r : std::min(least, r);
    most = std::max(most, r);
    sum += r;
  }
  times_.push_back(s.time);
  radii_.push_back(sum / static_cast<double>(markers_.size()));
  if (radii_.back() > radii_[stop_]) return;
  stop_ = radii_.size() - 1;
  roundness_ = (most - least) / radii_.back();
}

RowRange Shell::rows_read(const Grid& grid) const { return rows_of(markers_, grid); }

bool Shell::decided() const { return stop_ > 0 && times_.back() >= share_after_stop * times_[stop_]; }

void Shell::finish(const State&, RunResult& result) const {
  const bool stopped = stop_ > 0 && stop_ + 1 < radii_.size();
  result.outcome = stopped ? "arrested" : "undecided";
  if (!stopped) return;
  const Vec2 stop = lowest(&times_[stop_ - 1], &radii_[stop_ - 1]);
  result.metrics.push_back(metric(row_of(rows, "stop_radius_m"), stop.y()));
  result.metrics.push_back(metric(row_of(rows, "stop_time_s"), stop.x()));
  result.metrics.push_back(metric(row_of(rows, "roundness"), roundness_));
}

void Shell::carry(Archive& a) {
  a.numbers("markers", markers_), a.numbers("times", times_), a.numbers("radii", radii_);
  a.integer("stop", stop_), a.number("roundness", roundness_);
}

}  // namespace mpm
