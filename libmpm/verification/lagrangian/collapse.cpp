#include "libmpm/verification/lagrangian/collapse.hpp"

#include <algorithm>
#include <cmath>
#include <stdexcept>

#include "libmpm/scene/effect.hpp"

namespace mpm::verification::lagrangian {
namespace {

constexpr double nan = std::numeric_limits<double>::quiet_NaN();
constexpr int samples = 100;
constexpr double window = 0.75;  ///< share of the run after which it counts as its end (measure/cavity.hpp)

std::vector<Vec2> rim_of(const Lagrangian2d& code) {
  std::vector<Vec2> rim;
  for (const int node : code.mesh().rim) rim.push_back(code.positions()[static_cast<std::size_t>(node)]);
  return rim;
}

double cross(const Vec2& a, const Vec2& b) { return a.x() * b.y() - b.x() * a.y(); }

/// Of the rim and its image in the mirror x = 0.
double area_of(const std::vector<Vec2>& rim) {
  double sum = 0;
  for (std::size_t k = 0; k + 1 < rim.size(); ++k) sum += cross(rim[k], rim[k + 1]);
  return sum;
}

/// Whether faces of the cavity have met: the rim passes the mirror, or crosses itself.
bool faces_met(const std::vector<Vec2>& rim) {
  const auto side = [](const Vec2& a, const Vec2& b, const Vec2& c) -> double { return cross(b - a, c - a); };
  for (std::size_t i = 0; i + 1 < rim.size(); ++i) {
    if (rim[i].x() < 0) return true;
    for (std::size_t k = i + 2; k + 1 < rim.size(); ++k)
      if (side(rim[i], rim[i + 1], rim[k]) * side(rim[i], rim[i + 1], rim[k + 1]) < 0 &&
          side(rim[k], rim[k + 1], rim[i]) * side(rim[k], rim[k + 1], rim[i + 1]) < 0)
        return true;
  }
  return false;
}

}  // namespace

double Collapse::area_at(double t) const {
  const auto after = std::ranges::lower_bound(time, t);
  if (after == time.end() || t < 0) return nan;
  const auto k = static_cast<std::size_t>(after - time.begin());
  if (k == 0) return area[0];
  return area[k - 1] + (area[k] - area[k - 1]) * (t - time[k - 1]) / (time[k] - time[k - 1]);
}

Collapse collapse(const mpm::Scene& scene, int cells, int times, const Lagrangian2d::Options& options) {
  if (scene.space != Space::plane_strain)
    throw std::invalid_argument("lagrangian::collapse: takes plane strain alone");
  if (!(scene.cavity_radius > 0) || !condition_of("wall_gap")->holds(scene))
    throw std::invalid_argument("lagrangian::collapse: takes blocks with a cavity that fall onto a wall");
  QuadMesh mesh = cavity_mesh(
      {scene.block_width / 2, scene.block_height, scene.cavity_radius, scene.cavity_center_height}, cells,
      times);
  std::vector<Vec2> velocities(mesh.nodes.size(), Vec2(0, -scene.impact_speed));
  Lagrangian2d code(scene.material, std::move(mesh), std::move(velocities), options);

  Collapse c;
  c.cells = cells * times;
  const double energy = code.energy(), initial = area_of(rim_of(code));
  c.time = {0}, c.area = {initial};
  double sum = 0, duration = 0;
  for (int k = 1; k <= samples && c.stopped.empty(); ++k) {
    const double next = scene.end_time * k / samples;
    while (code.time() < next && c.stopped.empty()) {
      const double before = code.time();
      if (!code.advance(next - before)) c.stopped = "a cell of the mesh has turned over";
      if (before < window * scene.end_time) continue;
      sum += area_of(rim_of(code)) * (code.time() - before);
      duration += code.time() - before;
    }
    c.energy_error = std::max(c.energy_error, std::abs(code.energy() / energy - 1));
    const std::vector<Vec2> rim = rim_of(code);
    if (c.stopped.empty() && faces_met(rim)) c.stopped = "faces of the cavity have met";
    if (!c.stopped.empty()) break;
    c.time.push_back(next), c.area.push_back(area_of(rim));
  }
  if (!c.stopped.empty()) c.stop_time = code.time();
  c.collapsibility = c.stopped.empty() ? 1 - sum / duration / initial : nan;
  return c;
}

Limit limit_of(double coarse, double middle, double fine) {
  const double ratio = (middle - coarse) / (fine - middle);
  if (!(ratio > 1)) return {nan, ratio > 0 ? std::log2(ratio) : nan};
  return {fine + (fine - middle) / (ratio - 1), std::log2(ratio)};
}

CollapseLadder collapse_ladder(const mpm::Scene& scene, int coarsest_cells,
                               const Lagrangian2d::Options& options) {
  CollapseLadder l;
  for (const int times : {1, 2, 4}) l.meshes.push_back(collapse(scene, coarsest_cells, times, options));
  l.collapsibility =
      limit_of(l.meshes[0].collapsibility, l.meshes[1].collapsibility, l.meshes[2].collapsibility);
  return l;
}

}  // namespace mpm::verification::lagrangian
