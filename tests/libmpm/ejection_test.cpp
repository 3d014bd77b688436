// What comes off the body, and what a jet does.
#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "libmpm/measure/connected.hpp"
#include "libmpm/measure/ejection.hpp"
#include "libmpm/verification/exact/hugoniot.hpp"
#include "tests/libmpm/scenes.hpp"

namespace {

/// Parts by all pairs, numbered in the order of the points.
template <int axes>
std::vector<int> parts_by_pairs(const std::vector<mpm::Vec<axes>>& x, double link) {
  std::vector<int> part(x.size(), -1);
  int count = 0;
  for (std::size_t p = 0; p < x.size(); ++p) {
    if (part[p] >= 0) continue;
    std::vector<std::size_t> front{p};
    part[p] = count;
    while (!front.empty()) {
      const std::size_t a = front.back();
      front.pop_back();
      for (std::size_t b = 0; b < x.size(); ++b)
        if (part[b] < 0 && (x[a] - x[b]).squaredNorm() < link * link) {
          part[b] = count;
          front.push_back(b);
        }
    }
    ++count;
  }
  return part;
}

TEST(ConnectedParts, AreThoseOfAllPairs) {
  unsigned seed = 1;
  const auto random = [&seed] {
    seed = seed * 1664525U + 1013904223U;
    return static_cast<double>(seed >> 8) / (1 << 24);
  };
  for (const double link : {0.01, 0.03, 0.05, 0.08}) {
    std::vector<mpm::Vec2> x;
    for (int k = 0; k < 600; ++k) x.emplace_back(random() - 0.5, random() + 7);
    const mpm::ConnectedParts found = mpm::connected_parts<2>(x, link);
    EXPECT_EQ(found.part, parts_by_pairs<2>(x, link)) << link;
    EXPECT_EQ(found.count, 1 + *std::max_element(found.part.begin(), found.part.end()));
  }
  for (const double link : {0.05, 0.1, 0.15}) {
    std::vector<mpm::Vec3> x;
    for (int k = 0; k < 600; ++k) x.emplace_back(random() - 0.5, random() + 7, 2 * random());
    EXPECT_EQ(mpm::connected_parts<3>(x, link).part, parts_by_pairs<3>(x, link)) << link;
  }
  EXPECT_EQ(mpm::connected_parts<2>({}, 1).count, 0);
}

// The threshold of ejection: a planar free surface rises at u against the wall, to 3 %.
TEST(Ejection, PlanarFreeSurfaceDoubles) {
  const mpm::verification::exact::MieGruneisenFluid aluminium{2700, 5350, 1.34, 1.96, 880, 300};
  for (const double u : {200.0, 700.0, 1120.0, 1500.0}) {
    const auto release = mpm::verification::exact::isentropic_release(
        aluminium, mpm::verification::exact::hugoniot(aluminium, u));
    EXPECT_NEAR(release.surface_speed / (2 * u), 1, 0.03) << u;
  }
}

/// A square block of 4 um with a hole of 2 um in it, of particles 0.1 um apart, and a bit of 0.4 um with its
/// centre at this height, which rises at this speed, its lowest quarter at another one; watched for 2 ns.
std::string verdict_on_bit(double height, double speed, double lowest_speed, double watched = 2e-9) {
  mpm::Scene s = scenes::cavity(0.2e-6);
  s.impact_speed = 500;
  s.cavity_radius = 1e-6;
  s.block_height = 4e-6;
  s.cavity_center_height = 2e-6;  // a wall of 1 um, whose hundredth is 0.02 um^2
  s.measures.detached_for = 1e-9;
  s.measures.decides = mpm::Decides::ejection;
  mpm::State state{
      {}, mpm::Grid(mpm::Vec2(0, 0), mpm::Vec2(0.2e-6, 0.2e-6), 25), {}, 0, 0, mpm::Floor::impact_wall};
  const auto fill = [&](double x0, double x1, double y0, double y1, double v) {
    for (double x = x0 + 0.05e-6; x < x1; x += 0.1e-6)
      for (double y = y0 + 0.05e-6; y < y1; y += 0.1e-6)
        state.particles.add({x, y}, {0, v}, 2700 * 1e-14, 1e-14, {0.05e-6, 0.05e-6});
  };
  fill(0, 1e-6, 0, 1e-6, 0);
  fill(1e-6, 2e-6, 0, 4e-6, 0);
  fill(0, 1e-6, 3e-6, 4e-6, 0);
  fill(0, 0.2e-6, height - 0.2e-6, height - 0.1e-6, lowest_speed);
  fill(0, 0.2e-6, height - 0.1e-6, height + 0.2e-6, speed);
  mpm::Ejection ejection(s, state);
  mpm::Observer nobody;
  for (int k = 0; k * 0.1e-9 <= watched; ++k) {
    state.time = k * 0.1e-9;
    ejection.sample(state, nobody);
  }
  mpm::RunResult result;
  ejection.finish(state, result);
  return result.outcome;
}

TEST(Ejection, AsksForSpeedAndForBeingOutside) {
  EXPECT_EQ(verdict_on_bit(5e-6, 600, 600), "ejected");
  EXPECT_EQ(verdict_on_bit(5e-6, 400, 400),
            "undecided");  // slower than the planar free surface, and no arrest yet
  EXPECT_EQ(verdict_on_bit(2e-6, 600, 600), "undecided");     // in the hole
  EXPECT_EQ(verdict_on_bit(4.15e-6, 600, 600), "undecided");  // on the body
}

// Particles of a part that has come off jitter about its speed: what is fast among them will not be ejected.
TEST(Ejection, WhatHasComeOffHasTheSpeedOfItsPart) {
  EXPECT_EQ(verdict_on_bit(5e-6, 600, 0, 6e-9), "arrested");   // 450 m/s
  EXPECT_EQ(verdict_on_bit(5e-6, 600, 300, 6e-9), "ejected");  // 525 m/s
}

mpm::Scene thin_wall(double speed) {
  mpm::Scene s = scenes::cavity(0.2e-6);
  s.impact_speed = speed;
  s.block_height = 7e-6;
  s.cavity_center_height = 4.5e-6;  // a wall of 1 um
  s.end_time = 12e-9;
  s.measures.detached_for = 1e-9;
  s.measures.decides = mpm::Decides::ejection;
  s.measures.stop = mpm::Stop::decided;
  return s;
}

TEST(Ejection, FastImpactsEjectAndSlowOnesDoNot) {
  const mpm::RunResult slow = mpm::run(thin_wall(200)), fast = mpm::run(thin_wall(1000));
  ASSERT_EQ(slow.status, mpm::RunStatus::done) << slow.reason;
  ASSERT_EQ(fast.status, mpm::RunStatus::done) << fast.reason;
  EXPECT_EQ(slow.outcome, "arrested");
  EXPECT_EQ(scenes::metric(slow, "ejected_mass_kg_m"), 0);
  EXPECT_LT(scenes::metric(slow, "decision_margin"), 0);
  EXPECT_EQ(fast.outcome, "ejected");
  const double wall = 2 * 1.5e-6 * 1e-6 * 2700;
  EXPECT_GT(scenes::metric(fast, "ejected_mass_kg_m"), 0.01 * wall);
  EXPECT_LT(scenes::metric(fast, "ejected_mass_kg_m"), 2 * wall);
  EXPECT_GT(scenes::metric(fast, "ejecta_speed_m_s"), 1000);
  EXPECT_GT(scenes::metric(fast, "decision_margin"), 0);
  EXPECT_LT(scenes::metric(fast, "decision_time_s"), 12e-9);
}

TEST(Ejection, RunsThatStopWhenDecidedSayWhatWholeRunsSay) {
  for (const double speed : {200.0, 1000.0}) {
    mpm::Scene s = thin_wall(speed);
    const mpm::RunResult early = mpm::run(s);
    s.measures.stop = mpm::Stop::end_time;
    const mpm::RunResult whole = mpm::run(s);
    EXPECT_LT(early.steps, whole.steps);
    EXPECT_EQ(early.outcome, whole.outcome) << speed;
    EXPECT_EQ(scenes::metric(early, "decision_time_s"), scenes::metric(whole, "decision_time_s"));
  }
}

// A spherical cavity says the same in axial symmetry and in three dimensions, of a quarter and of the whole.
TEST(Ejection, OfASphereIsTheSameInThreeDimensions) {
  const auto run = [](double speed, mpm::Space space, mpm::Symmetry symmetry, double cell) {
    mpm::Scene s = thin_wall(speed);
    s.space = space;
    s.numerics = mpm::default_numerics(s.kind, space);
    s.numerics.cell_size = cell;
    s.numerics.symmetry = symmetry;
    s.block_width = 5e-6;
    s.block_height = 5e-6;
    s.cavity_center_height = 2.5e-6;
    return mpm::run(s);
  };
  using enum mpm::Space;
  using enum mpm::Symmetry;
  const mpm::RunResult slow = run(200, three_d, half, 0.36e-6), flat = run(1000, axisymmetric, half, 0.25e-6),
                       fast = run(1000, three_d, half, 0.25e-6);
  ASSERT_EQ(slow.status, mpm::RunStatus::done) << slow.reason;
  ASSERT_EQ(fast.status, mpm::RunStatus::done) << fast.reason;
  EXPECT_EQ(slow.outcome, "arrested");
  EXPECT_EQ(flat.outcome, "ejected");
  EXPECT_EQ(fast.outcome, "ejected");
  EXPECT_NEAR(scenes::metric(fast, "decision_time_s") / scenes::metric(flat, "decision_time_s"), 1, 0.1);
  const double wall = std::numbers::pi * 1.5e-6 * 1.5e-6 * 1e-6 * 2700;
  EXPECT_GT(scenes::metric(fast, "ejected_mass_kg"), 0.01 * wall);
  const mpm::RunResult quarter = run(1000, three_d, half, 0.36e-6), whole = run(1000, three_d, full, 0.36e-6);
  for (const char* name : {"ejected_mass_kg", "ejecta_speed_m_s", "decision_time_s"})
    EXPECT_NEAR(scenes::metric(whole, name) / scenes::metric(quarter, name), 1, 1e-6) << name;
}

TEST(Jet, StrikesTheFarWallUnderAStrongShockOnly) {
  mpm::Scene s = thin_wall(1000);
  s.measures.decides = mpm::Decides::collapse;
  s.measures.stop = mpm::Stop::end_time;
  s.end_time = 3e-9;
  const mpm::RunResult strong = mpm::run(s);
  const double impact = scenes::metric(strong, "jet_impact_time_s");
  // The shock (faster than c0) has to come to the cavity's 3 um, and the far wall then is 3 um away.
  EXPECT_GT(impact, 3e-6 / (5350 + 1.34 * 1000));
  EXPECT_LT(impact, 3e-9);
  // Faster than the free surface that a planar shock leaves.
  EXPECT_GT(scenes::metric(strong, "jet_speed_m_s"), 2 * 1000);
  EXPECT_TRUE(std::isfinite(scenes::metric(strong, "jet_lead_m")));

  const mpm::RunResult weak = mpm::run(scenes::cavity(0.2e-6));
  EXPECT_TRUE(std::isnan(scenes::metric(weak, "jet_impact_time_s")));
}

// A mirror image of the same block instead of the wall would do the same; a plain block does, until what
// comes back from the cavity has been at the contact.
TEST(TwoBodyImpact, IsTheImpactOnTheWallAtFirst) {
  mpm::Scene s = scenes::cavity(0.1e-6);
  s.block_height = 8e-6;
  s.cavity_center_height = 4e-6;
  s.end_time = 1.1e-9;
  const mpm::RunResult wall = mpm::run(s);
  s.kind = mpm::SceneKind::two_body_impact;
  const mpm::RunResult bodies = mpm::run(s);
  ASSERT_EQ(bodies.status, mpm::RunStatus::done) << bodies.reason;
  EXPECT_GT(bodies.particles, 2 * wall.particles);
  EXPECT_LT(bodies.energy_error, 1e-11);
  EXPECT_LT(scenes::metric(bodies, "momentum_error"), 1e-12);
  EXPECT_NEAR(*bodies.initial_area, *wall.initial_area, 1e-12 * *wall.initial_area);
  EXPECT_NEAR(*bodies.collapsibility, *wall.collapsibility, 0.01);
  EXPECT_GT(*wall.collapsibility, 0.02);
}

TEST(TwoBodyImpact, EstimateCountsBothBodies) {
  mpm::Scene s = scenes::cavity(0.1e-6);
  s.kind = mpm::SceneKind::two_body_impact;
  s.end_time = 0.1e-9;
  const auto particles = static_cast<double>(mpm::run(s).particles);
  EXPECT_NEAR(static_cast<double>(mpm::estimate(s).particles) / particles, 1, 0.02);
}

}  // namespace
