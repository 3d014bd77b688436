// Spall by a stated tension cutoff: a flyer of 1 um at 400 m/s hits a target of 2 um, and where the two
// release waves meet the material is held to its spall strength. The free surface of the target against the
// one-dimensional Lagrangian code, which has the same cutoff and shares no code with the solver.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <memory>
#include <utility>
#include <vector>

#include "libmpm/mpm.hpp"
#include "libmpm/scene/build.hpp"
#include "libmpm/verification/exact/lagrangian_1d.hpp"
#include "tests/libmpm/scenes.hpp"

namespace {

constexpr double flyer = 1e-6, whole = 3e-6, speed = 400, end = 1.1e-9;
constexpr int samples = 110;

/// Speed of the free surface at equal times [m/s], and the energy that is lost.
struct History {
  std::vector<double> surface;
  double energy_error = 0;

  double peak() const { return *std::max_element(surface.begin(), surface.end()); }
};

/// Mean velocity of some particles at the samples after the first, which is at time 0.
class SurfaceSpeed : public mpm::Measurement {
 public:
  SurfaceSpeed(std::vector<std::size_t> particles, std::vector<double>& speeds)
      : particles_(std::move(particles)), speeds_(speeds) {}
  void sample(const mpm::State& s, mpm::Observer&) override {
    if (s.step == 0) return;
    double sum = 0;
    for (const std::size_t p : particles_) sum += s.particles.velocity[p].y();
    speeds_.push_back(sum / static_cast<double>(particles_.size()));
  }
  void finish(const mpm::State&, mpm::RunResult&) const override {}
  void carry(mpm::Archive& a) override { a.numbers("speeds", speeds_); }

 private:
  std::vector<std::size_t> particles_;
  std::vector<double>& speeds_;
};

/// Far above the wall, which feels nothing.
History solve(double cell, mpm::Tension tension, double spall_strength) {
  mpm::Scene scene = scenes::planar(speed, whole, cell, end);
  scene.measures.area_every = end / samples;
  scene.material.tension = tension;
  scene.material.spall_strength = spall_strength;
  mpm::State s = mpm::build_state(scene);
  double top = 0;
  for (std::size_t p = 0; p < s.particles.size(); ++p) {
    mpm::Vec2& x = s.particles.position[p];
    s.particles.velocity[p] = mpm::Vec2(0, x.y() < flyer ? speed : 0);
    x.y() += 1e-6;
    top = std::max(top, x.y());
  }
  std::vector<std::size_t> surface;
  for (std::size_t p = 0; p < s.particles.size(); ++p)
    if (s.particles.position[p].y() > top - cell / 100) surface.push_back(p);
  History h;
  mpm::Simulation simulation(scene, std::move(s));
  simulation.add(std::make_unique<SurfaceSpeed>(std::move(surface), h.surface));
  h.energy_error = simulation.run().energy_error;
  return h;
}

History reference(double spall_strength) {
  constexpr int cells = 600;
  std::vector<double> x, v;
  for (int j = 0; j <= cells; ++j) {
    x.push_back(whole * j / cells);
    v.push_back(3 * j < cells ? speed : 3 * j > cells ? 0 : speed / 2);
  }
  mpm::verification::exact::Lagrangian1d::Options options;
  options.spall_strength = spall_strength;
  mpm::verification::exact::Lagrangian1d code(scenes::exact_solid(mpm::named_material("aluminium")),
                                              mpm::verification::exact::Lagrangian1d::Geometry::planar, x, v,
                                              options);
  const double before = code.energy();
  History h;
  for (int k = 1; k <= samples; ++k) {
    while (code.time() < end * k / samples) code.advance(end * k / samples - code.time());
    h.surface.push_back(code.velocities().back());
  }
  h.energy_error = std::abs(code.energy() / before - 1);
  return h;
}

/// Mean distance of two histories over their peak.
double distance(const History& a, const History& b) {
  double sum = 0;
  for (int k = 0; k < samples; ++k) sum += std::abs(a.surface[k] - b.surface[k]);
  return sum / samples / b.peak();
}

double pull_back(const History& h) {
  const auto peak = std::max_element(h.surface.begin(), h.surface.end());
  return *peak - *std::min_element(peak, h.surface.end());
}

class SpallOf : public testing::TestWithParam<double> {};
INSTANTIATE_TEST_SUITE_P(Strengths, SpallOf, testing::Values(1e9, 2e9));

TEST_P(SpallOf, ConvergesWithTheCell) {
  const History exact = reference(GetParam());
  double last = 1;
  for (const double cell : {0.1e-6, 0.05e-6, 0.025e-6}) {
    const History h = solve(cell, mpm::Tension::cutoff, GetParam());
    const double error = distance(h, exact);
    EXPECT_LT(error, 0.7 * last) << cell;
    EXPECT_LT(h.energy_error, 1e-12);
    if (cell == 0.025e-6) {
      EXPECT_LT(error, 0.045);
      EXPECT_NEAR(pull_back(h) / pull_back(exact), 1, 0.05);
    }
    last = error;
  }
}

// Without a cutoff the tension holds: the surface comes back almost to rest, as in one dimension.
TEST(Spall, WithoutACutoffTheReleaseIsHeld) {
  const History exact = reference(std::numeric_limits<double>::infinity());
  const History h = solve(0.025e-6, mpm::Tension::polynomial, 0);
  EXPECT_NEAR(h.peak() / exact.peak(), 1, 0.003);
  EXPECT_NEAR(pull_back(h) / pull_back(exact), 1, 0.005);
  EXPECT_LT(distance(h, exact), 0.045);
}

}  // namespace
