#include "libmpm/body/region.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
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
double in_units(double x, const Vec2& of) { return x / of.x(); }
double in_units(const Vec2& at, const Vec3& of) { return at.cwiseQuotient(Vec2(of.x(), of.z())).norm(); }
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

template <int axes>
BasicRegion<axes> ellipsoid(const Vec<axes>& center, const Vec<axes>& half_axes) {
  const double least = half_axes.minCoeff();
  return {center - half_axes, center + half_axes,
          [=](const Vec<axes>& x,
              double radius) {  // in units of the half axes the ball is in one of radius/least
            const double distance = (x - center).cwiseQuotient(half_axes).norm();
            return distance < 1 - radius / least   ? Share::all
                   : distance > 1 + radius / least ? Share::none
                                                   : Share::part;
          },
          [=](const LineAt<axes>& at, Intervals& all) {
            const double half = half_axes.y() * half_chord(1, in_units(offset(at, center), half_axes));
            all.push_back({center.y() - half, center.y() + half});
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

BasicRegion<3> cylinder(const Vec3& end, Axis axis, double length, double radius) {
  const int along = static_cast<int>(axis);
  Vec3 low = end - Vec3::Constant(radius), high = end + Vec3::Constant(radius);
  low[along] = end[along], high[along] = end[along] + length;
  return {low, high,
          [=](const Vec3& x, double r) {
            Vec3 across = x - end;
            across[along] = 0;
            const double within = std::min(x[along] - low[along], high[along] - x[along]);
            return share_at(std::min(within, radius - across.norm()), r);
          },
          [=](const Vec2& at, Intervals& all) {
            const Vec2 from = offset(at, end);
            if (axis == Axis::y) {
              if (from.norm() <= radius) all.push_back({low.y(), high.y()});
              return;
            }
            const double way = axis == Axis::x ? from.x() : from.y();
            if (way < 0 || way > length) return;
            const double half = half_chord(radius, axis == Axis::x ? from.y() : from.x());
            all.push_back({end.y() - half, end.y() + half});
          }};
}

template <int axes>
BasicRegion<axes> operator-(BasicRegion<axes> a, BasicRegion<axes> b) {
  return {a.low, a.high,
          [a, b](const Vec<axes>& center, double radius) {
            const Share in = a.share_of_ball(center, radius), out = b.share_of_ball(center, radius);
            if (in == Share::none || out == Share::all) return Share::none;
            return in == Share::all && out == Share::none ? Share::all : Share::part;
          },
          [a, b](const LineAt<axes>& at, Intervals& all) { subtract(cut_of(a, at), cut_of(b, at), all); }};
}

template <int axes>
BasicRegion<axes> operator|(BasicRegion<axes> a, BasicRegion<axes> b) {
  return {a.low.cwiseMin(b.low), a.high.cwiseMax(b.high),
          [a, b](const Vec<axes>& center, double radius) {
            const Share in_a = a.share_of_ball(center, radius), in_b = b.share_of_ball(center, radius);
            if (in_a == Share::all || in_b == Share::all) return Share::all;
            return in_a == Share::none && in_b == Share::none ? Share::none : Share::part;
          },
          [a, b](const LineAt<axes>& at, Intervals& all) {
            Intervals both = cut_of(a, at);
            b.cut(at, both);
            unite(std::move(both), all);
          }};
}

#define MPM_REGIONS_OF(axes)                                                  \
  template BasicRegion<axes> everywhere<axes>();                              \
  template BasicRegion<axes> block(const Vec<axes>&, const Vec<axes>&);       \
  template BasicRegion<axes> ball(const Vec<axes>&, double);                  \
  template BasicRegion<axes> ellipsoid(const Vec<axes>&, const Vec<axes>&);   \
  template BasicRegion<axes> half_space(const Vec<axes>&, const Vec<axes>&);  \
  template BasicRegion<axes> operator-(BasicRegion<axes>, BasicRegion<axes>); \
  template BasicRegion<axes> operator|(BasicRegion<axes>, BasicRegion<axes>);
MPM_REGIONS_OF(2)
MPM_REGIONS_OF(3)
#undef MPM_REGIONS_OF

}  // namespace mpm
