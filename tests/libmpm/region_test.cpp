// Regions of two and of three axes, and how particles fill them.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <numbers>
#include <random>
#include <string>
#include <vector>

#include "libmpm/body/fill.hpp"
#include "libmpm/core/errors.hpp"

namespace {

using mpm::Axis;
using mpm::Vec2;
using mpm::Vec3;
using std::numbers::pi;
using Region3 = mpm::BasicRegion<3>;

mpm::LineAt<2> line_of(const Vec2& x) { return x.x(); }
mpm::LineAt<3> line_of(const Vec3& x) { return {x.x(), x.z()}; }

/// A region, and whether a point lies in it.
template <int axes>
struct Case {
  std::string name;
  mpm::BasicRegion<axes> region;
  std::function<bool(const mpm::Vec<axes>&)> holds;
};

template <int axes>
std::vector<Case<axes>> cases() {
  using Vec = mpm::Vec<axes>;
  Vec low = Vec::Constant(-0.7), high = Vec::Constant(0.4), half = Vec::Constant(0.3);
  high[0] = 0.6, half[1] = 0.8, half[axes - 1] = 0.5;
  Vec normal = Vec::Constant(1);
  normal[0] = -2;
  Vec flat = Vec::Zero();
  flat[0] = 3;
  const Vec center = Vec::Constant(0.1), point = Vec::Constant(0.05);
  mpm::Mat<axes> turn = mpm::Mat<axes>::Identity();
  turn.template topLeftCorner<2, 2>() << std::cos(0.6), -std::sin(0.6), std::sin(0.6), std::cos(0.6);
  const auto in_block = [=](const Vec& x) {
    return ((x - low).minCoeff() >= 0) && ((high - x).minCoeff() >= 0);
  };
  const auto in_ball = [=](double r) { return [=](const Vec& x) { return (x - center).norm() <= r; }; };
  const auto ball = [=](double r) { return mpm::ball<axes>(center, r); };
  return {
      {"block", mpm::block<axes>(low, high), in_block},
      {"ball", ball(0.8), in_ball(0.8)},
      {"ellipsoid", mpm::ellipsoid<axes>(center, half),
       [=](const Vec& x) { return (x - center).cwiseQuotient(half).norm() <= 1; }},
      {"turned ellipsoid", mpm::ellipsoid<axes>(center, half, turn),
       [=](const Vec& x) { return (turn.transpose() * (x - center)).cwiseQuotient(half).norm() <= 1; }},
      {"polygon", mpm::polygon<axes>({{-0.5, -0.6}, {0.7, -0.4}, {0.1, 0}, {0.6, 0.8}, {-0.5, 0.5}}),
       [=](const Vec& x) {
         const auto left_of = [&](Vec2 a, Vec2 b) {
           return (b - a).x() * (x[1] - a.y()) - (b - a).y() * (x[0] - a.x()) >= 0;
         };
         return left_of({-0.5, -0.6}, {0.7, -0.4}) && left_of({0.6, 0.8}, {-0.5, 0.5}) && x[0] >= -0.5 &&
                (left_of({0.7, -0.4}, {0.1, 0}) || left_of({0.1, 0}, {0.6, 0.8}));
       }},
      {"intersection", mpm::block<axes>(low, high) & ball(0.5),
       [=](const Vec& x) { return in_block(x) && in_ball(0.5)(x); }},
      {"half-space", mpm::half_space<axes>(point, normal),
       [=](const Vec& x) { return normal.dot(x - point) <= 0; }},
      {"half-space above", mpm::half_space<axes>(point, -normal),
       [=](const Vec& x) { return normal.dot(x - point) >= 0; }},
      {"upright half-space", mpm::half_space<axes>(point, flat),
       [=](const Vec& x) { return x[0] <= point[0]; }},
      {"shell", ball(0.8) - ball(0.5), [=](const Vec& x) { return in_ball(0.8)(x) && !in_ball(0.5)(x); }},
      {"union", mpm::block<axes>(low, high) | ball(0.5),
       [=](const Vec& x) { return in_block(x) || in_ball(0.5)(x); }},
      // what is taken away has intervals that end before they begin, where the smaller ball is in the larger
      {"nested", mpm::block<axes>(low, high) - (ball(0.3) - ball(0.5)), in_block},
  };
}

/// Points that lie in one of the intervals of their own line are those of the region; and what is said of a
/// ball holds for its points.
template <int axes>
void check(const Case<axes>& c) {
  SCOPED_TRACE(c.name);
  std::mt19937 generator(3);
  const auto random = [&] { return generator() / 2147483648.0 - 1; };
  const auto random_point = [&] {
    mpm::Vec<axes> x;
    for (int k = 0; k < axes; ++k) x[k] = random();
    return x;
  };
  int inside = 0, decided = 0;
  for (int n = 0; n < 3000; ++n) {
    const mpm::Vec<axes> x = random_point();
    std::vector<mpm::Interval> intervals;
    c.region.cut(line_of(x), intervals);
    const auto within = std::ranges::count_if(
        intervals, [&](const mpm::Interval& i) { return i.low <= x.y() && x.y() <= i.high; });
    EXPECT_EQ(within, c.holds(x) ? 1 : 0) << x.transpose();
    for (std::size_t k = 1; k < intervals.size(); ++k) EXPECT_LE(intervals[k - 1].high, intervals[k].low);
    inside += c.holds(x);
    if (c.holds(x)) {
      EXPECT_GE((x - c.region.low).minCoeff(), 0);
      EXPECT_GE((c.region.high - x).minCoeff(), 0);
    }
    const double radius = 0.15 * (random() + 1);
    const mpm::Share share = c.region.share_of_ball(x, radius);
    decided += share != mpm::Share::part;
    for (int k = 0; k < 10; ++k) {
      const mpm::Vec<axes> y = x + radius * (1 - 1e-12) * random_point().normalized();
      if (share != mpm::Share::part) {
        EXPECT_EQ(c.holds(y), share == mpm::Share::all) << y.transpose();
      }
    }
  }
  EXPECT_GT(inside, 50);
  EXPECT_GT(decided, 500);
}

TEST(Region, LinesAndBallsSayWhatLiesInIt) {
  for (const auto& c : cases<2>()) check(c);
  for (const auto& c : cases<3>()) check(c);
  const Vec3 end(-0.4, 0.1, -0.3);
  for (const Axis axis : {Axis::x, Axis::y, Axis::z})
    check<3>({"cylinder", mpm::cylinder(end, axis, 0.9, 0.6), [=](const Vec3& x) {
                const int along = static_cast<int>(axis);
                Vec3 across = x - end;
                const double way = across[along];
                across[along] = 0;
                return way >= 0 && way <= 0.9 && across.norm() <= 0.6;
              }});
  const Vec3 to(0.3, 0.6, 0.5), along = (to - end).normalized();
  check<3>({"slanted cylinder", mpm::cylinder(end, to, 0.4), [=](const Vec3& x) {
              const double way = along.dot(x - end);
              return way >= 0 && way <= (to - end).norm() && (x - end - way * along).norm() <= 0.4;
            }});
}

/// What a region comes to on a grid of 32 cells of edge 1 a side, with the origin in the middle.
struct Filled {
  double volume = 0;
  Vec3 centroid = Vec3::Zero();
};
Filled filled(const Region3& region, int per_edge, Vec3 place = Vec3::Zero()) {
  constexpr int cells = 32;
  constexpr double density = 2700;
  mpm::BasicState<3> s = mpm::empty_state(Vec3::Constant(-cells / 2), Vec3::Ones(), cells, cells);
  mpm::fill_rows<3>(s, {region, [](const Vec3& x) { return Vec3(x.y(), 0, 7); }, place}, density, per_edge, 0,
                    cells);
  Filled f;
  const auto& ps = s.particles;
  for (std::size_t p = 0; p < ps.size(); ++p) {
    EXPECT_EQ(ps.mass[p], density * ps.initial_volume[p]);
    EXPECT_NEAR(8 * ps.half_size[p].prod() / ps.initial_volume[p], 1, 1e-14);
    EXPECT_NEAR(ps.velocity[p].x(), ps.position[p].y() - place.y(), 1e-13);
    f.volume += ps.initial_volume[p];
    f.centroid += ps.initial_volume[p] * ps.position[p];
  }
  EXPECT_EQ(s.velocity_gradient.size(), ps.size());
  f.centroid /= f.volume;
  return f;
}

// Thirty cells across, off the lattice.
TEST(Fill, BodiesOfThreeAxesHaveTheirVolume) {
  const Vec3 off(0.21, -0.37, 0.13);
  const double r = 15, sphere = 4 * pi / 3 * r * r * r, rod = pi * 9 * 9 * 30;
  const Region3 ball = mpm::ball<3>(Vec3::Zero(), r),
                box = mpm::block<3>(Vec3(-7.3, -15, -9), Vec3(8.1, 4.2, 15));
  struct Expected {
    std::string name;
    Region3 region;
    double volume;
  };
  const std::vector<Expected> all = {
      {"ball", ball, sphere},
      {"shell", ball - mpm::ball<3>(Vec3::Zero(), 9), sphere * (1 - 0.216)},
      {"box", box, 15.4 * 19.2 * 24},
      {"rod along x", mpm::cylinder({-15, 0, 0}, Axis::x, 30, 9), rod},
      {"rod along y", mpm::cylinder({0, -15, 0}, Axis::y, 30, 9), rod},
      {"rod along z", mpm::cylinder({0, 0, -15}, Axis::z, 30, 9), rod},
      {"tube", mpm::cylinder({0, -15, 0}, Axis::y, 30, 9) - mpm::cylinder({0, -15, 0}, Axis::y, 30, 6),
       rod * 5 / 9},
      {"half a ball", ball - mpm::half_space<3>(Vec3::Zero(), Vec3(1, -2, 2)), sphere / 2},
      {"two balls", mpm::ball<3>(Vec3(-8, 0, 0), 6) | mpm::ball<3>(Vec3(8, 0, 0), 7),
       4 * pi / 3 * (216 + 343)},
      {"ellipsoid", mpm::ellipsoid<3>(Vec3::Zero(), Vec3(15, 8, 11)), 4 * pi / 3 * 15 * 8 * 11},
  };
  for (const Expected& e : all)
    for (const int per_edge : {1, 2}) {
      SCOPED_TRACE(e.name);
      EXPECT_NEAR(filled(e.region, per_edge, off).volume / e.volume, 1, 0.002);
    }
  // centroids of the rim are those of what is left of it
  const Filled f = filled(ball, 2, off);
  EXPECT_LT((f.centroid - off).norm(), 1e-4);
  EXPECT_NEAR(filled(mpm::block<3>(Vec3(-8, -16, -4), Vec3(8, 4, 16)), 2).volume, 16 * 20 * 20, 1e-9);
}

TEST(Fill, RefusesTwoBodiesInOnePlace) {
  mpm::Scene scene;
  scene.material.reference_density = 1;
  scene.numerics.particles_per_cell = 8;
  mpm::BasicState<3> s = mpm::empty_state(Vec3::Zero(), Vec3::Ones(), 8, 8);
  const auto at_rest = [](const Vec3&) { return Vec3(0, 0, 0); };
  mpm::fill<3>(s, {mpm::block<3>(Vec3::Zero(), Vec3(4, 4, 8)), at_rest}, scene);
  EXPECT_EQ(s.particles.size(), 8u * 128);
  mpm::fill<3>(s, {mpm::block<3>(Vec3(4, 0, 0), Vec3(8, 4, 8)), at_rest}, scene);
  EXPECT_THAT(
      [&] {
        mpm::fill<3>(s, {mpm::ball<3>(Vec3(4, 4, 4), 2), at_rest}, scene);
      },
      testing::ThrowsMessage<mpm::InputError>(
          testing::MatchesRegex("two bodies overlap at x = .* um, y = .* um, z = .* um: .*")));
  EXPECT_THROW(mpm::fill<3>(s, {mpm::everywhere<3>(), at_rest}, scene), mpm::InputError);
  EXPECT_THROW(mpm::fill<3>(s, {mpm::ball<3>(Vec3(20, 4, 4), 2), at_rest}, scene), mpm::InputError);
}

}  // namespace
