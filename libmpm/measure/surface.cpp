#include "libmpm/measure/surface.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "libmpm/measure/markers.hpp"

namespace mpm {
namespace {

/// a . (b x c)
double triple(const Vec3& a, const Vec3& b, const Vec3& c) {
  return a.x() * (b.y() * c.z() - b.z() * c.y()) + a.y() * (b.z() * c.x() - b.x() * c.z()) +
         a.z() * (b.x() * c.y() - b.y() * c.x());
}

}  // namespace

Surface::Surface(const Vec3& center, double radius, double cell_size, bool quarter)
    : quarter_(quarter),
      mesh_(sphere_mesh(quarter ? SpherePart::quarter : SpherePart::whole,
                        std::max(8, static_cast<int>(std::ceil(std::numbers::pi * radius / cell_size))))) {
  markers_ = mesh_.points;
  const double outer = radius * std::cbrt(4 * std::numbers::pi / 3 / volume());
  for (Vec3& x : markers_) x = center + outer * x;
}

void Surface::advance(const BasicGrid<3>& grid, double dt) {
  move_markers<3>(markers_, grid, dt);
  if (!quarter_) return;
  // on a mirror, to the last bit: the nodes on its two sides cancel to rounding
  for (const int p : mesh_.meridians[0]) markers_[static_cast<std::size_t>(p)].z() = 0;
  for (const int p : mesh_.meridians[1]) markers_[static_cast<std::size_t>(p)].x() = 0;
}

RowRange Surface::rows(const BasicGrid<3>& grid) const { return rows_of<3>(markers_, grid); }

Contour Surface::meridian(std::size_t which) const {
  std::vector<Vec2> points;
  for (const int p : mesh_.meridians[which])
    points.emplace_back(which == 0 ? at(p).x() : at(p).z(), at(p).y());
  return Contour(std::move(points), quarter_);
}

bool Surface::crosses_itself() const {
  if (quarter_ && std::ranges::any_of(markers_, [](const Vec3& x) { return x.x() < 0 || x.z() < 0; }))
    return true;
  return meridian(0).crosses_itself() || meridian(1).crosses_itself();
}

Vec3 Surface::downstream_pole() const {
  const std::vector<int>& around = mesh_.meridians[0];
  return at(quarter_ ? around.back() : around[around.size() / 2]);
}

/// Pyramids from a point on both mirrors, which see nothing of the faces that the mirrors close.
double Surface::volume() const {
  const Vec3 from(0, upstream_pole().y(), 0);
  double sum = 0;
  for (const SphereMesh::Triangle& t : mesh_.triangles)
    sum += triple(at(t[0]) - from, at(t[1]) - from, at(t[2]) - from);
  return (quarter_ ? 4 : 1) * sum / 6;
}

}  // namespace mpm
