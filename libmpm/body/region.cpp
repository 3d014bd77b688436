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

/// The points of each interval of `from` that lie in none of `taken`.
void subtract(const Intervals& from, const Intervals& taken, Intervals& left) {
  for (Interval rest : from) {
    for (const Interval& hole : taken) {
      if (hole.high < rest.low || hole.low > rest.high) continue;
      left.push_back({rest.low, hole.low});
      rest.low = hole.high;
    }
    left.push_back(rest);
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

Intervals cut_of(const Region& region, double x) {
  Intervals intervals;
  region.cut(x, intervals);
  return intervals;
}

}  // namespace

Region everywhere() {
  return {Vec2::Constant(-infinity), Vec2::Constant(infinity), [](const Vec2&, double) { return Share::all; },
          [](double, Intervals& all) {
            all.push_back({-infinity, infinity});
          }};
}

Region block(Vec2 low, Vec2 high) {
  return {low, high,
          [=](const Vec2& center, double radius) {
            const Vec2 below = center - low, above = high - center;
            const double least = std::min(below.minCoeff(), above.minCoeff());
            return least >= radius ? Share::all : least <= -radius ? Share::none : Share::part;
          },
          [=](double x, Intervals& all) {
            if (x >= low.x() && x <= high.x()) all.push_back({low.y(), high.y()});
          }};
}

/// A line that misses the disc has the empty interval at the height of its centre.
Region disc(Vec2 center, double radius) {
  const Vec2 reach = Vec2::Constant(radius);
  return {center - reach, center + reach,
          [=](const Vec2& x, double r) {
            const double distance = (x - center).norm();
            return distance < radius - r ? Share::all : distance > radius + r ? Share::none : Share::part;
          },
          [=](double x, Intervals& all) {
            const double half = half_chord(radius, x - center.x());
            all.push_back({center.y() - half, center.y() + half});
          }};
}

Region ellipse(Vec2 center, Vec2 half_axes) {
  const double least = half_axes.minCoeff();
  return {
      center - half_axes, center + half_axes,
      [=](const Vec2& x, double radius) {  // in units of the half axes the circle is in one of radius/least
        const double distance = (x - center).cwiseQuotient(half_axes).norm();
        return distance < 1 - radius / least   ? Share::all
               : distance > 1 + radius / least ? Share::none
                                               : Share::part;
      },
      [=](double x, Intervals& all) {
        const double half = half_axes.y() * half_chord(1, (x - center.x()) / half_axes.x());
        all.push_back({center.y() - half, center.y() + half});
      }};
}

Region operator-(Region a, Region b) {
  return {a.low, a.high,
          [a, b](const Vec2& center, double radius) {
            const Share in = a.share_of_circle(center, radius), out = b.share_of_circle(center, radius);
            if (in == Share::none || out == Share::all) return Share::none;
            return in == Share::all && out == Share::none ? Share::all : Share::part;
          },
          [a, b](double x, Intervals& all) { subtract(cut_of(a, x), cut_of(b, x), all); }};
}

Region operator|(Region a, Region b) {
  return {a.low.cwiseMin(b.low), a.high.cwiseMax(b.high),
          [a, b](const Vec2& center, double radius) {
            const Share in_a = a.share_of_circle(center, radius), in_b = b.share_of_circle(center, radius);
            if (in_a == Share::all || in_b == Share::all) return Share::all;
            return in_a == Share::none && in_b == Share::none ? Share::none : Share::part;
          },
          [a, b](double x, Intervals& all) {
            Intervals both = cut_of(a, x);
            b.cut(x, both);
            unite(std::move(both), all);
          }};
}

}  // namespace mpm
