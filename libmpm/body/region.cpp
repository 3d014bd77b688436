#include "libmpm/body/region.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <memory>
#include <utility>

namespace mpm {
namespace {

constexpr double infinity = std::numeric_limits<double>::infinity();

double half_chord(double radius, double x) {
  return std::abs(x) < radius ? std::sqrt(radius * radius - x * x) : 0;
}

using Intervals = std::vector<Interval>;

/// What lines of two axes and of three have in common.
double offset(double x, const Vec2& from) { return x - from.x(); }
Vec2 offset(const Vec2& at, const Vec3& from) { return at - Vec2(from.x(), from.z()); }
double length(double x) { return x; }
double length(const Vec2& at) { return at.norm(); }
/// From a point to the one of the line at the same height.
Vec2 point_of(double x, const Vec2& from) { return {x - from.x(), 0}; }
Vec3 point_of(const Vec2& at, const Vec3& from) { return {at.x() - from.x(), 0, at.y() - from.z()}; }
bool between(double x, const Vec2& low, const Vec2& high) { return x >= low.x() && x <= high.x(); }
bool between(const Vec2& at, const Vec3& low, const Vec3& high) {
  return at.x() >= low.x() && at.x() <= high.x() && at.y() >= low.z() && at.y() <= high.z();
}
/// normal . (x - point) of the point of the line at the height of `point`.
double reach(double x, const Vec2& point, const Vec2& normal) { return normal.x() * (x - point.x()); }
double reach(const Vec2& at, const Vec3& point, const Vec3& normal) {
  return normal.x() * (at.x() - point.x()) + normal.z() * (at.y() - point.z());
}

/// The points of each interval of `from` that lie in none of `taken`.
void subtract(const Intervals& from, const Intervals& taken, Intervals& left) {
  const auto add = [&](double low, double high) {
    if (high >= low) left.push_back({low, high});
  };
  for (Interval rest : from) {
    for (const Interval& hole : taken) {
      if (hole.high < rest.low || hole.low > rest.high) continue;
      add(rest.low, hole.low);
      rest.low = hole.high;
    }
    add(rest.low, rest.high);
  }
}

void unite(Intervals all, Intervals& united) {
  std::ranges::sort(all, {}, &Interval::low);
  const auto first = static_cast<std::ptrdiff_t>(united.size());
  for (const Interval& next : all) {
    if (!(next.high > next.low)) continue;
    if (std::ssize(united) > first && next.low <= united.back().high)
      united.back().high = std::max(united.back().high, next.high);
    else
      united.push_back(next);
  }
}

template <int axes>
Intervals cut_of(const BasicRegion<axes>& region, const LineAt<axes>& at) {
  Intervals intervals;
  region.cut(at, intervals);
  return intervals;
}

/// Of a convex body whose surface is at that distance from a ball's centre, positive inside.
Share share_at(double depth, double radius) {
  return depth >= radius ? Share::all : depth <= -radius ? Share::none : Share::part;
}

}  // namespace

template <int axes>
BasicRegion<axes> everywhere() {
  return {Vec<axes>::Constant(-infinity), Vec<axes>::Constant(infinity),
          [](const Vec<axes>&, double) { return Share::all; },
          [](const LineAt<axes>&, Intervals& all) {
            all.push_back({-infinity, infinity});
          }};
}

template <int axes>
BasicRegion<axes> block(const Vec<axes>& low, const Vec<axes>& high) {
  return {low, high,
          [=](const Vec<axes>& center, double radius) {
            const Vec<axes> below = center - low, above = high - center;
            return share_at(std::min(below.minCoeff(), above.minCoeff()), radius);
          },
          [=](const LineAt<axes>& at, Intervals& all) {
            if (between(at, low, high)) all.push_back({low.y(), high.y()});
          }};
}

/// A line that misses the ball has the empty interval at the height of its centre.
template <int axes>
BasicRegion<axes> ball(const Vec<axes>& center, double radius) {
  const Vec<axes> reach = Vec<axes>::Constant(radius);
  return {center - reach, center + reach,
          [=](const Vec<axes>& x, double r) {
            const double distance = (x - center).norm();
            return distance < radius - r ? Share::all : distance > radius + r ? Share::none : Share::part;
          },
          [=](const LineAt<axes>& at, Intervals& all) {
            const double half = half_chord(radius, length(offset(at, center)));
            all.push_back({center.y() - half, center.y() + half});
          }};
}

/// In coordinates u of the ellipsoid, in which it is the unit ball, a vertical line is u = a + y b.
template <int axes>
BasicRegion<axes> ellipsoid(const Vec<axes>& center, const Vec<axes>& half_axes, const Mat<axes>& rotation) {
  const double least = half_axes.minCoeff();
  const Mat<axes> to_unit_ball = half_axes.cwiseInverse().asDiagonal() * rotation.transpose();
  const Vec<axes> reach = (rotation * half_axes.asDiagonal()).rowwise().norm();
  return {center - reach, center + reach,
          [=](const Vec<axes>& x,
              double radius) {  // in units of the half axes the ball is in one of radius/least
            const double distance = (to_unit_ball * (x - center)).norm();
            return distance < 1 - radius / least   ? Share::all
                   : distance > 1 + radius / least ? Share::none
                                                   : Share::part;
          },
          [=](const LineAt<axes>& at, Intervals& all) {
            const Vec<axes> a = to_unit_ball * point_of(at, center), b = to_unit_ball.col(1);
            const double nearest = -a.dot(b) / b.squaredNorm();
            const double half = half_chord(1, (a + nearest * b).norm()) / b.norm();
            all.push_back({center.y() + nearest - half, center.y() + nearest + half});
          }};
}

namespace {

/// From a point to the nearest one of a line between two corners.
double distance_to_edge(const Vec2& x, const Vec2& from, const Vec2& to) {
  const Vec2 edge = to - from;
  const double share = std::clamp((x - from).dot(edge) / edge.squaredNorm(), 0.0, 1.0);
  return (x - from - share * edge).norm();
}

/// Heights at which a vertical line goes through the edges, ascending. An edge has its left corner and not
/// its right one, so that there is an even number of them.
std::vector<double> crossings(const std::vector<Vec2>& corners, double x) {
  std::vector<double> heights;
  for (std::size_t k = 0; k < corners.size(); ++k) {
    const Vec2 &a = corners[k], &b = corners[(k + 1) % corners.size()];
    if ((a.x() <= x) == (b.x() <= x)) continue;
    heights.push_back(a.y() + (b.y() - a.y()) * ((x - a.x()) / (b.x() - a.x())));
  }
  std::ranges::sort(heights);
  return heights;
}

Vec2 in_plane(const Vec2& x) { return x; }
Vec2 in_plane(const Vec3& x) { return x.head<2>(); }
double across(double x) { return x; }
double across(const Vec2& at) { return at.x(); }

}  // namespace

template <int axes>
BasicRegion<axes> polygon(const std::vector<Vec2>& corners) {
  Vec<axes> low = Vec<axes>::Constant(-infinity), high = Vec<axes>::Constant(infinity);
  low.template head<2>() = high.template head<2>() = corners.front();
  for (const Vec2& corner : corners) {
    low.template head<2>() = low.template head<2>().cwiseMin(corner);
    high.template head<2>() = high.template head<2>().cwiseMax(corner);
  }
  return {low, high,
          [=](const Vec<axes>& center, double radius) {
            const Vec2 x = in_plane(center);
            for (std::size_t k = 0; k < corners.size(); ++k)
              if (distance_to_edge(x, corners[k], corners[(k + 1) % corners.size()]) <= radius)
                return Share::part;
            const auto heights = crossings(corners, x.x());
            const auto below = std::ranges::count_if(heights, [&](double y) { return y < x.y(); });
            return below % 2 == 1 ? Share::all : Share::none;
          },
          [=](const LineAt<axes>& at, Intervals& all) {
            const auto heights = crossings(corners, across(at));
            for (std::size_t k = 0; k + 1 < heights.size(); k += 2)
              all.push_back({heights[k], heights[k + 1]});
          }};
}

template <int axes>
BasicRegion<axes> half_space(const Vec<axes>& point, const Vec<axes>& direction) {
  const Vec<axes> normal = direction.normalized();
  Vec<axes> low = Vec<axes>::Constant(-infinity), high = Vec<axes>::Constant(infinity);
  for (int k = 0; k < axes; ++k)
    if (std::abs(normal[k]) == 1) (normal[k] > 0 ? high : low)[k] = point[k];
  return {low, high,
          [=](const Vec<axes>& x, double radius) { return share_at(-normal.dot(x - point), radius); },
          [=](const LineAt<axes>& at, Intervals& all) {
            const double beyond = reach(at, point, normal);
            const double height = point.y() - beyond / normal.y();
            if (normal.y() > 0)
              all.push_back({-infinity, height});
            else if (normal.y() < 0)
              all.push_back({height, infinity});
            else if (beyond <= 0)
              all.push_back({-infinity, infinity});
          }};
}

/// A vertical line through the point a above the end's height is x = a + y e_y; what of it lies between the
/// two end planes and within the radius is one interval each.
BasicRegion<3> cylinder(const Vec3& from, const Vec3& to, double radius) {
  const double length = (to - from).norm();
  const Vec3 along = (to - from) / length;
  const Vec3 reach = radius * (Vec3::Ones() - along.cwiseAbs2()).cwiseMax(0).cwiseSqrt();
  return {from.cwiseMin(to) - reach, from.cwiseMax(to) + reach,
          [=](const Vec3& x, double r) {
            const double way = along.dot(x - from);
            const double outwards = (x - from - way * along).norm();
            return share_at(std::min({way, length - way, radius - outwards}), r);
          },
          [=](const Vec2& at, Intervals& all) {
            const Vec3 a = point_of(at, from), up = Vec3::Unit(1);
            const double start = along.dot(a), rise = along.y();
            Interval cut{-infinity, infinity};
            if (rise != 0) {
              const double one = -start / rise, other = (length - start) / rise;
              cut = {std::min(one, other), std::max(one, other)};
            } else if (start < 0 || start > length) {
              return;
            }
            const Vec3 outwards = a - start * along, slope = up - rise * along;
            const double steepness = slope.squaredNorm();
            if (steepness > 0) {
              const double nearest = -outwards.dot(slope) / steepness;
              const double half =
                  half_chord(radius, (outwards + nearest * slope).norm()) / std::sqrt(steepness);
              cut = {std::max(cut.low, nearest - half), std::min(cut.high, nearest + half)};
            } else if (outwards.norm() > radius) {
              return;
            }
            if (cut.high >= cut.low) all.push_back({from.y() + cut.low, from.y() + cut.high});
          }};
}

/// Regions made of two share them: a copy of one would copy both parts twice, and so on for their parts.
template <int axes>
BasicRegion<axes> operator-(BasicRegion<axes> first, BasicRegion<axes> second) {
  const Vec<axes> low = first.low, high = first.high;
  const auto a = std::make_shared<const BasicRegion<axes>>(std::move(first));
  const auto b = std::make_shared<const BasicRegion<axes>>(std::move(second));
  return {low, high,
          [a, b](const Vec<axes>& center, double radius) {
            const Share in = a->share_of_ball(center, radius);
            if (in == Share::none) return Share::none;
            const Share out = b->share_of_ball(center, radius);
            if (out == Share::all) return Share::none;
            return in == Share::all && out == Share::none ? Share::all : Share::part;
          },
          [a, b](const LineAt<axes>& at, Intervals& all) { subtract(cut_of(*a, at), cut_of(*b, at), all); }};
}

template <int axes>
BasicRegion<axes> operator|(BasicRegion<axes> first, BasicRegion<axes> second) {
  const Vec<axes> low = first.low.cwiseMin(second.low), high = first.high.cwiseMax(second.high);
  const auto a = std::make_shared<const BasicRegion<axes>>(std::move(first));
  const auto b = std::make_shared<const BasicRegion<axes>>(std::move(second));
  return {low, high,
          [a, b](const Vec<axes>& center, double radius) {
            const Share in_a = a->share_of_ball(center, radius);
            if (in_a == Share::all) return Share::all;
            const Share in_b = b->share_of_ball(center, radius);
            if (in_b == Share::all) return Share::all;
            return in_a == Share::none && in_b == Share::none ? Share::none : Share::part;
          },
          [a, b](const LineAt<axes>& at, Intervals& all) {
            Intervals both = cut_of(*a, at);
            b->cut(at, both);
            unite(std::move(both), all);
          }};
}

template <int axes>
BasicRegion<axes> operator&(BasicRegion<axes> a, BasicRegion<axes> b) {
  BasicRegion<axes> both = a - (everywhere<axes>() - b);
  both.low = a.low.cwiseMax(b.low), both.high = a.high.cwiseMin(b.high);
  return both;
}

#define MPM_REGIONS_OF(axes)                                                                  \
  template BasicRegion<axes> everywhere<axes>();                                              \
  template BasicRegion<axes> block(const Vec<axes>&, const Vec<axes>&);                       \
  template BasicRegion<axes> ball(const Vec<axes>&, double);                                  \
  template BasicRegion<axes> ellipsoid(const Vec<axes>&, const Vec<axes>&, const Mat<axes>&); \
  template BasicRegion<axes> polygon<axes>(const std::vector<Vec2>&);                         \
  template BasicRegion<axes> operator&(BasicRegion<axes>, BasicRegion<axes>);                 \
  template BasicRegion<axes> half_space(const Vec<axes>&, const Vec<axes>&);                  \
  template BasicRegion<axes> operator-(BasicRegion<axes>, BasicRegion<axes>);                 \
  template BasicRegion<axes> operator|(BasicRegion<axes>, BasicRegion<axes>);
MPM_REGIONS_OF(2)
MPM_REGIONS_OF(3)
#undef MPM_REGIONS_OF

}  // namespace mpm
