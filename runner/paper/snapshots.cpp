#include "runner/paper/snapshots.hpp"

#include <algorithm>
#include <cmath>
#include <functional>
#include <numeric>

#include "analysis/empty_regions.hpp"
#include "runner/finish/fields.hpp"

namespace mpmstudy {
namespace {

/// Of what lies within a radius of a point of the right half.
double rotation_about(const mpm::Snapshot& s, double x, double y, double radius) {
  const auto near = [&](std::size_t p) { return std::hypot(s.x[p] - x, s.y[p] - y) < radius; };
  double mass = 0, center_x = 0, center_y = 0, u = 0, v = 0;
  for (std::size_t p = 0; p < s.x.size(); ++p) {
    if (!near(p)) continue;
    mass += s.mass[p];
    center_x += s.mass[p] * s.x[p];
    center_y += s.mass[p] * s.y[p];
    u += s.mass[p] * s.velocity_x[p];
    v += s.mass[p] * s.velocity_y[p];
  }
  if (!(mass > 0)) return 0;
  double momentum = 0, inertia = 0;
  for (std::size_t p = 0; p < s.x.size(); ++p) {
    if (!near(p)) continue;
    const double dx = s.x[p] - center_x / mass, dy = s.y[p] - center_y / mass;
    momentum += s.mass[p] * (dx * (s.velocity_y[p] - v / mass) - dy * (s.velocity_x[p] - u / mass));
    inertia += s.mass[p] * (dx * dx + dy * dy);
  }
  return inertia > 0 ? momentum / inertia : 0;
}

HotSpot hot_spot_of(const mpm::Snapshot& s) {
  constexpr double share = 0.001;
  std::vector<std::size_t> order(s.x.size());
  std::iota(order.begin(), order.end(), std::size_t{0});
  std::ranges::stable_sort(order, std::greater<>(), [&](std::size_t p) { return s.plastic_work[p]; });
  const double total = std::accumulate(s.mass.begin(), s.mass.end(), 0.0);
  HotSpot spot{s.time, 0, 0, 0};
  double mass = 0;
  for (const std::size_t p : order) {
    mass += s.mass[p];
    spot.x += s.mass[p] * std::abs(s.x[p]);
    spot.y += s.mass[p] * s.y[p];
    if (mass >= share * total) break;
  }
  spot.x /= mass;
  spot.y /= mass;
  spot.rotation = rotation_about(s, spot.x, spot.y, spot.x / 2);
  return spot;
}

Cavities cavities_of(const mpm::Snapshot& s, double cell) {
  constexpr int pixels_per_cell = 2;
  const analysis::ParticleSquares particles = particles_of(s, "density");
  const bool mirrored = std::ranges::min(s.x) >= 0;
  const analysis::Window window = analysis::window_of({&particles}, mirrored);
  const auto pixels = [&](double length) {
    return std::max(1, static_cast<int>(std::lround(length / cell * pixels_per_cell)));
  };
  const auto areas = analysis::closed_empty_regions(
      analysis::rasterise(particles, mirrored, window, pixels(window.width()), pixels(window.height())),
      window);
  const auto end = std::ranges::find_if(areas, [&](double area) { return area < cell * cell; });
  return {s.time, end - areas.begin(), end == areas.begin() ? 0 : areas.front(),
          std::accumulate(areas.begin(), end, 0.0)};
}

}  // namespace

std::vector<HotSpot> hot_spots_of(const Evidence& evidence, const std::string& study) {
  std::vector<HotSpot> spots;
  evidence.each_snapshot(study, [&](const mpm::Snapshot& s) { spots.push_back(hot_spot_of(s)); });
  return spots;
}

std::vector<Cavities> cavities_of(const Evidence& evidence, const std::string& study) {
  std::vector<Cavities> cavities;
  if (const auto job = evidence.first_done(study, {"cell_size"})) {
    const double cell = number_of(job->parameters[0]).value();
    evidence.each_snapshot(study, [&](const mpm::Snapshot& s) { cavities.push_back(cavities_of(s, cell)); });
  }
  return cavities;
}

}  // namespace mpmstudy
