// The one-dimensional reference code against the reference histories, which another program of its kind made.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "libmpm/verification/exact/lagrangian_1d.hpp"
#include "libmpm/verification/exact/pressed_cavity.hpp"
#include "tests/verification/exact/csv.hpp"

namespace {

using namespace mpm::verification::exact;

constexpr ElasticPlasticSolid aluminium{{2700, 5350, 1.34, 1.96, 880, 300}, 25.93985e9, 120e6, 470.302e6};

class Lagrangian : public testing::TestWithParam<int> {};

// 2000 cells against the table's 3000: the fronts are a little wider.
TEST_P(Lagrangian, ReproducesTheHistory) {
  const auto rows = read_reference("freesurface_history_1d.csv");
  const std::string speed = std::to_string(GetParam());
  std::vector<double> times;
  for (const CsvRow& row : rows) times.push_back(number(row, "t_ns") * 1e-9);
  const auto samples = impact_history(aluminium, GetParam(), 10e-6, 2000, times);
  double surface = 0, wall = 0, fastest = 0, hardest = 0;
  for (std::size_t k = 0; k < rows.size(); ++k) {
    const double v = number(rows[k], "vfs_" + speed + "_m_s"),
                 s = number(rows[k], "sigwall_" + speed + "_GPa");
    surface += std::pow(samples[k].surface_speed - v, 2);
    wall += std::pow(samples[k].wall_stress * 1e-9 - s, 2);
    fastest = std::max(fastest, v);
    hardest = std::max(hardest, s);
  }
  const auto count = static_cast<double>(rows.size());
  EXPECT_LT(std::sqrt(surface / count) / fastest, 0.005);
  EXPECT_LT(std::sqrt(wall / count) / hardest, 0.005);
  EXPECT_NEAR(samples.back().surface_speed / number(rows.back(), "vfs_" + speed + "_m_s"), 1, 1e-4);
}
INSTANTIATE_TEST_SUITE_P(Speeds, Lagrangian, testing::Values(20, 200, 1120),
                         [](const auto& info) { return "u" + std::to_string(info.param); });

TEST(LagrangianCode, KeepsEnergyAndScales) {
  for (const auto geometry : {Lagrangian1d::Geometry::planar, Lagrangian1d::Geometry::cylindrical}) {
    std::vector<double> x, v;
    for (int j = 0; j <= 100; ++j) x.push_back(1e-6 * (1 + 0.01 * j)), v.push_back(-2e-4 / x.back());
    Lagrangian1d small(aluminium, geometry, x, v, {});
    for (double& one : x) one *= 1024;
    Lagrangian1d large(aluminium, geometry, x, v, {});
    const double before = small.energy();
    for (int k = 0; k < 2000; ++k) small.advance(1), large.advance(1);
    EXPECT_NEAR(small.energy() / before, 1, 2e-3);
    EXPECT_EQ(large.time(), 1024 * small.time());
    EXPECT_EQ(large.positions()[0], 1024 * small.positions()[0]);
    EXPECT_EQ(large.normal_stress(50), small.normal_stress(50));
  }
}

// The less it is compressed, the nearer a cavity under pressure comes to the incompressible one.
TEST(LagrangianCode, ClosesACavityInAStiffSolidLikeAnIncompressibleOne) {
  ElasticPlasticSolid solid = aluminium;
  solid.hardening = 0;
  const PressedCavity cavity{1e-6, solid.fluid.density, solid.yield_stress, solid.shear_modulus};
  solid.fluid.sound_speed *= 8;
  const double pressure = 0.8 * closing_pressure(cavity);
  const CavityStop stop = pressed_cavity_stop(cavity, pressure);
  const CavityHistory history = compressible_cavity(solid, cavity.radius, pressure, 1.1 * stop.time, 40);
  EXPECT_NEAR(history.least() / stop.radius, 1, 0.01);
  const double middle = 0.5 * (cavity.radius + stop.radius);
  EXPECT_NEAR(history.time_at(middle) / pressed_cavity_time(cavity, pressure, middle), 1, 0.02);
}

TEST(LagrangianCode, RefusesImpossibleInput) {
  using enum Lagrangian1d::Geometry;
  EXPECT_THROW(Lagrangian1d(aluminium, planar, {1, 1}, {0, 0}, {}), std::invalid_argument);
  EXPECT_THROW(Lagrangian1d(aluminium, cylindrical, {-1, 1}, {0, 0}, {}), std::invalid_argument);
  EXPECT_THROW(Lagrangian1d(aluminium, planar, {0, 1}, {0}, {}), std::invalid_argument);
}

}  // namespace
