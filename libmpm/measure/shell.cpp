#include "libmpm/measure/shell.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "libmpm/measure/markers.hpp"
#include "libmpm/measure/sphere_mesh.hpp"
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

template <int axes>
std::span<const ResultRow> BasicShell<axes>::results() {
  return rows;
}

template <int axes>
BasicShell<axes>::BasicShell(const Scene& s, const State&)
    : center_(lattice_of<axes>(s).center), times_{0}, radii_{s.inner_radius} {
  const bool part = s.numerics.symmetry == Symmetry::half;
  const double right_angle = std::numbers::pi / 2;
  const auto steps = [&](double per_cell) {
    return std::max(
        16, static_cast<int>(std::ceil(per_cell * right_angle * s.inner_radius / s.numerics.cell_size)));
  };
  if constexpr (axes == 2) {
    // Four markers per cell, none on a mirror; those of a quarter are among those of the ring.
    const int count = steps(4);
    for (int k = 0; k < (part ? count : 4 * count); ++k) {
      const double angle = (k + 0.5) * right_angle / count;
      markers_.push_back(center_ + s.inner_radius * Vec2(std::cos(angle), std::sin(angle)));
    }
  } else {
    // two per cell: their mean is one over thousands
    const SphereMesh mesh = sphere_mesh(part ? SpherePart::octant : SpherePart::whole, steps(2));
    for (const Vec3& x : mesh.points) markers_.push_back(center_ + s.inner_radius * x);
    shares_ = mesh.shares();
  }
}

template <int axes>
void BasicShell<axes>::after_step(const State& s, const StepReport&, double dt) {
  move_markers<axes>(markers_, s.grid, dt);
  double sum = 0, count = 0, least = 0, most = 0;
  for (std::size_t k = 0; k < markers_.size(); ++k) {
    const double r = (markers_[k] - center_).norm();
    least = sum == 0 ? r : std::min(least, r);
    most = std::max(most, r);
    sum += share_of(k) * r;
    count += share_of(k);
  }
  times_.push_back(s.time);
  radii_.push_back(sum / count);
  if (radii_.back() > radii_[stop_]) return;
  stop_ = radii_.size() - 1;
  roundness_ = (most - least) / radii_.back();
}

template <int axes>
RowRange BasicShell<axes>::rows_read(const BasicGrid<axes>& grid) const {
  return rows_of<axes>(markers_, grid);
}

template <int axes>
bool BasicShell<axes>::decided() const {
  return stop_ > 0 && times_.back() >= share_after_stop * times_[stop_];
}

template <int axes>
void BasicShell<axes>::finish(const State&, RunResult& result) const {
  const bool stopped = stop_ > 0 && stop_ + 1 < radii_.size();
  result.outcome = stopped ? "arrested" : "undecided";
  if (!stopped) return;
  const Vec2 stop = lowest(&times_[stop_ - 1], &radii_[stop_ - 1]);
  result.metrics.push_back(metric(row_of(rows, "stop_radius_m"), stop.y()));
  result.metrics.push_back(metric(row_of(rows, "stop_time_s"), stop.x()));
  result.metrics.push_back(metric(row_of(rows, "roundness"), roundness_));
}

template <int axes>
void BasicShell<axes>::carry(Archive& a) {
  a.numbers("markers", markers_), a.numbers("times", times_), a.numbers("radii", radii_);
  a.integer("stop", stop_), a.number("roundness", roundness_);
}

template class BasicShell<2>;
template class BasicShell<3>;

}  // namespace mpm
