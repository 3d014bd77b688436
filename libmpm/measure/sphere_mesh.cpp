#include "libmpm/measure/sphere_mesh.hpp"

#include <Eigen/Geometry>

#include <cmath>
#include <map>
#include <numbers>

namespace mpm {
namespace {

/// A point of the octahedron |i| + |j| + |k| = steps.
using Corner = std::array<int, 3>;

class Builder {
 public:
  explicit Builder(int steps) : steps_(steps) {}

  int number(const Corner& c) {
    const auto [at, is_new] = numbers_.try_emplace(c, static_cast<int>(mesh.points.size()));
    if (is_new) mesh.points.push_back(on_sphere(c));
    return at->second;
  }
  /// The octant with these signs.
  void add(int x, int y, int z) {
    const auto corner = [&](int i, int j) { return number({x * i, y * j, z * (steps_ - i - j)}); };
    const bool odd = x * y * z < 0;
    const auto triangle = [&](int a, int b, int c) {
      mesh.triangles.push_back(odd ? SphereMesh::Triangle{a, c, b} : SphereMesh::Triangle{a, b, c});
    };
    for (int i = 0; i < steps_; ++i)
      for (int j = 0; i + j < steps_; ++j) {
        triangle(corner(i, j), corner(i + 1, j), corner(i, j + 1));
        if (i + j + 2 <= steps_) triangle(corner(i + 1, j), corner(i + 1, j + 1), corner(i, j + 1));
      }
  }
  /// Through the lowest point, across = 0 or 2, and the highest one; and back if it is whole.
  std::vector<int> meridian(int across, bool whole) {
    std::vector<int> points;
    const auto add = [&](int out, int up) {
      Corner c{0, up, 0};
      c[static_cast<std::size_t>(across)] = out;
      points.push_back(number(c));
    };
    for (int k = 0; k < 2 * steps_; ++k) add(k <= steps_ ? k : 2 * steps_ - k, k - steps_);
    if (!whole) add(0, steps_);
    for (int k = 0; whole && k < 2 * steps_; ++k) add(-(k <= steps_ ? k : 2 * steps_ - k), steps_ - k);
    return points;
  }

  SphereMesh mesh;

 private:
  Vec3 on_sphere(const Corner& c) const {
    Vec3 x;
    for (int k = 0; k < 3; ++k)
      x[k] = std::sin(std::numbers::pi / 2 * c[static_cast<std::size_t>(k)] / steps_);
    return x.normalized();
  }

  int steps_;
  std::map<Corner, int> numbers_;
};

}  // namespace

std::vector<double> SphereMesh::shares() const {
  std::vector<double> all(points.size(), 0.0);
  for (const Triangle& t : triangles) {
    const auto at = [&](std::size_t k) -> const Vec3& { return points[static_cast<std::size_t>(t[k])]; };
    const double area = 0.5 * (at(1) - at(0)).cross(at(2) - at(0)).norm();
    for (const int p : t) all[static_cast<std::size_t>(p)] += area / 3;
  }
  return all;
}

SphereMesh sphere_mesh(SpherePart part, int steps) {
  Builder builder(steps);
  for (const int x : {1, -1})
    for (const int y : {1, -1})
      for (const int z : {1, -1}) {
        const bool modelled =
            part == SpherePart::whole || (x > 0 && z > 0 && (part == SpherePart::quarter || y > 0));
        if (modelled) builder.add(x, y, z);
      }
  if (part != SpherePart::octant)
    for (const int k : {0, 1})
      builder.mesh.meridians[static_cast<std::size_t>(k)] =
          builder.meridian(2 * k, part == SpherePart::whole);
  return builder.mesh;
}

}  // namespace mpm
