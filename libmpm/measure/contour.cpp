#include "libmpm/measure/contour.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <span>

#include "libmpm/measure/markers.hpp"

namespace mpm {
namespace {

using std::numbers::pi;

/// Twice the signed area of a closed polygon, and its first moments times six.
struct Moments {
  double area2 = 0;
  Vec2 moment6 = Vec2::Zero();
};
Moments moments(std::span<const Vec2> polygon) {
  Moments m;
  for (std::size_t k = 0; k < polygon.size(); ++k) {
    const Vec2 &a = polygon[k], &b = polygon[(k + 1) % polygon.size()];
    const double cross = a.x() * b.y() - b.x() * a.y();
    m.area2 += cross;
    m.moment6 += cross * (a + b);
  }
  return m;
}

}  // namespace

Contour::Contour(Vec2 center, double radius, double cell_size, bool half) : half_(half) {
  // An even number of steps per half turn, so that markers lie on the axis and at the height of the centre.
  const int steps = 2 * std::max(8, static_cast<int>(std::ceil(2 * pi * radius / cell_size)));
  const double turn = pi / steps;
  const double outer = radius * std::sqrt(turn / std::sin(turn));  // polygon of 2 steps corners, area pi R^2
  const int count = half ? steps + 1 : 2 * steps;
  for (int k = 0; k < count; ++k) {
    const double angle = k * turn - pi / 2;
    Vec2 x = center + outer * Vec2(std::cos(angle), std::sin(angle));
    if (k == 0 || k == steps) x.x() = center.x();  // on the mirror, to the last bit
    markers_.push_back(x);
  }
}

void Contour::advance(const Grid& grid, double dt) { move_markers<2>(markers_, grid, dt); }

RowRange Contour::rows(const Grid& grid) const { return rows_of<2>(markers_, grid); }

std::vector<Vec2> Contour::closed() const {
  std::vector<Vec2> all = markers_;
  if (half_)
    for (std::size_t k = markers_.size() - 2; k > 0; --k) all.emplace_back(-markers_[k].x(), markers_[k].y());
  return all;
}

namespace {

/// > 0 if c lies to the left of the line from a to b.
double side(const Vec2& a, const Vec2& b, const Vec2& c) {
  return (b.x() - a.x()) * (c.y() - a.y()) - (b.y() - a.y()) * (c.x() - a.x());
}

bool cross(const Vec2& a, const Vec2& b, const Vec2& c, const Vec2& d) {
  if (std::max(a.x(), b.x()) < std::min(c.x(), d.x()) || std::max(c.x(), d.x()) < std::min(a.x(), b.x()) ||
      std::max(a.y(), b.y()) < std::min(c.y(), d.y()) || std::max(c.y(), d.y()) < std::min(a.y(), b.y()))
    return false;
  return side(a, b, c) * side(a, b, d) < 0 && side(c, d, a) * side(c, d, b) < 0;
}

}  // namespace

bool Contour::crosses_itself() const {
  const std::size_t count = markers_.size();
  const std::size_t pieces = half_ ? count - 1 : count;
  for (std::size_t i = 0; i < pieces; ++i) {
    if (half_ && markers_[i].x() < 0) return true;  // through its own image
    for (std::size_t k = i + 2; k < pieces; ++k)
      if (cross(markers_[i], markers_[i + 1], markers_[k], markers_[(k + 1) % count])) return true;
  }
  return false;
}

Vec2 Contour::downstream_pole() const { return half_ ? markers_.back() : markers_[markers_.size() / 2]; }

double Contour::area() const { return 0.5 * moments(closed()).area2; }

/// Cones between neighbouring markers: pi (x^2 + x x' + x'^2) (y' - y) / 3.
double Contour::volume() const {
  double sum = 0;
  for (std::size_t k = 0; k + 1 < markers_.size(); ++k) {
    const Vec2 &a = markers_[k], &b = markers_[k + 1];
    sum += (a.x() * a.x() + a.x() * b.x() + b.x() * b.x()) * (b.y() - a.y());
  }
  return pi / 3 * sum;
}

double Contour::width() const {
  const auto all = closed();
  const auto [low, high] =
      std::minmax_element(all.begin(), all.end(), [](const Vec2& a, const Vec2& b) { return a.x() < b.x(); });
  return high->x() - low->x();
}

double Contour::height() const {
  const auto [low, high] = std::minmax_element(markers_.begin(), markers_.end(),
                                               [](const Vec2& a, const Vec2& b) { return a.y() < b.y(); });
  return high->y() - low->y();
}

Vec2 Contour::centroid() const {
  const Moments m = moments(closed());
  return m.moment6 / (3 * m.area2);
}

double Contour::lower_upper_ratio() const {
  const auto all = closed();  // starts at the lowest marker; quarters have equal numbers of steps
  const std::size_t quarter = all.size() / 4;
  std::vector<Vec2> lower(all.begin() + 3 * quarter, all.end());
  lower.insert(lower.end(), all.begin(), all.begin() + quarter + 1);
  const std::vector<Vec2> upper(all.begin() + quarter, all.begin() + 3 * quarter + 1);
  return moments(lower).area2 / moments(upper).area2;
}

}  // namespace mpm
