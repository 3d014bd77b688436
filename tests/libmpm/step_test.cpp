// One step of random states, and what a step must keep: mass, momentum, energy.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>

#include "libmpm/material/eos/mie_grueneisen.hpp"
#include "libmpm/measure/energy.hpp"
#include "libmpm/scene/build.hpp"
#include "libmpm/shape/bspline2.hpp"
#include "libmpm/shape/bspline3.hpp"
#include "libmpm/shape/cpdi.hpp"
#include "libmpm/shape/gimp.hpp"
#include "libmpm/step/apic.hpp"
#include "libmpm/step/flip_pic.hpp"
#include "libmpm/step/step.hpp"
#include "tests/libmpm/random_state.hpp"
#include "tests/libmpm/scenes.hpp"

namespace {

template <class Shape>
void start_domains(mpm::Particles& particles) {
  if constexpr (requires { Shape::start(particles); }) Shape::start(particles);
}

template <class Shape>
class StepTest : public testing::Test {};
using Shapes = testing::Types<mpm::Gimp, mpm::Cpdi, mpm::BSpline2, mpm::BSpline3>;
TYPED_TEST_SUITE(StepTest, Shapes);

TYPED_TEST(StepTest, P2gKeepsMassAndMomentumAndItsForcesAddUpToZero) {
  mpm::State s = random_state(scenes::cavity(0.2e-6), 1e-6);
  start_domains<TypeParam>(s.particles);
  s.grid.grow_to_row(60);
  mpm::p2g<TypeParam>(s.particles, s.grid);
  double mass = 0, particle_mass = 0, force_scale = 0;
  mpm::Vec2 momentum = mpm::Vec2::Zero(), force = mpm::Vec2::Zero();
  for (const mpm::Node& n : s.grid.nodes()) {
    mass += n.mass;
    momentum += n.velocity;
    force += n.acceleration;
    force_scale += n.acceleration.norm();
  }
  for (const double m : s.particles.mass) particle_mass += m;
  EXPECT_NEAR(mass / particle_mass, 1, 1e-13);
  EXPECT_LT((momentum - mpm::momentum_of(s.particles)).norm(), 1e-13 * particle_mass * 1000);
  EXPECT_LT(force.norm(), 1e-13 * force_scale);
}

/// Change of the total energy in one step, over the kinetic energy, and the heat of the transfer.
struct EnergyChange {
  double change, transfer_heat;
};
template <class Shape, class Transfer>
EnergyChange energy_change(mpm::State s, const mpm::MaterialModel& material, const Transfer& transfer) {
  const mpm::Energy before = mpm::energy_of(s.particles);
  const mpm::StepReport r = mpm::reference_step<Shape>(s, material, 5e-12, transfer);
  return {(mpm::energy_of(s.particles).total() - before.total()) / before.kinetic, r.transfer_heat};
}

TYPED_TEST(StepTest, KeepsEnergyToRoundingWhateverTheState) {
  const mpm::Scene scene = scenes::cavity(0.2e-6);
  const mpm::MaterialModel material = mpm::build_material(scene);
  for (const double lift : {0.0, 0.13e-6, 1e-6}) {
    SCOPED_TRACE(lift);
    const mpm::State s = random_state(scene, lift);
    const EnergyChange flip = energy_change<TypeParam>(s, material, mpm::Flip{});
    EXPECT_NEAR(flip.change, 0, 1e-13);
    EXPECT_GT(flip.transfer_heat, 0);  // random velocities are more than a grid can carry
    EXPECT_NEAR(energy_change<TypeParam>(s, material, mpm::Apic{}).change, 0, 1e-13);
    double last = 0;
    for (const double share : {0.05, 0.5, 1.0}) {
      const EnergyChange blend = energy_change<TypeParam>(s, material, mpm::FlipPic{share});
      EXPECT_NEAR(blend.change, 0, 1e-13) << share;
      EXPECT_GT(blend.transfer_heat, lift == 1e-6 ? last : 0);  // the more PIC, the more heat
      last = blend.transfer_heat;
    }
  }
}

// Torn-off material: see MieGrueneisen::validity.
TYPED_TEST(StepTest, WhatHasExpandedTenfoldKeepsItsVolumeAndLosesItsPressure) {
  const mpm::Scene scene = scenes::cavity(0.2e-6);
  const mpm::MaterialModel material = mpm::build_material(scene);
  const mpm::MieGrueneisen eos(material.material);
  const mpm::MieGrueneisen::Volume tenfold(mpm::MieGrueneisen::most_dilation);
  mpm::State s{{}, mpm::Grid({-2e-6, 0}, {0.2e-6, 0.2e-6}, 20), {}, 0, 0, mpm::Floor::impact_wall};
  mpm::Particles& ps = s.particles;
  const mpm::Vec2 middle(0, 2e-6);
  for (int j = -8; j < 8; ++j)
    for (int i = -8; i < 8; ++i)
      ps.add(middle + 0.1e-6 * mpm::Vec2(i + 0.5, j + 0.5), {}, 2.7e-11, 1e-14, {0.05e-6, 0.05e-6});
  s.velocity_gradient.assign(ps.size(), mpm::Mat2::Zero());
  start_domains<TypeParam>(ps);
  const auto move = [&](double rate) {
    for (std::size_t p = 0; p < ps.size(); ++p) ps.velocity[p] = rate * (ps.position[p] - middle);
  };
  const mpm::MieGrueneisen::Line line = eos.line(tenfold);
  for (std::size_t p = 0; p < ps.size(); ++p) {
    ps.dilation[p] = tenfold.dilation * (1 - 1e-6);
    ps.pressure[p] = 1e9;
    ps.energy[p] = (1e9 - line.cold) / line.thermal;
  }
  move(1e9);
  const mpm::Energy before = mpm::energy_of(ps);
  mpm::StepReport report;
  const std::size_t inner = 8 * 16 + 8;
  const double first = ps.pressure[inner];
  for (int k = 0; k < 20; ++k) report = mpm::reference_step<TypeParam>(s, material, 5e-13);
  // dP/dt = -gamma0 P rho0/rho theta, with theta from 2e9 1/s on
  EXPECT_NEAR(std::log(ps.pressure[inner] / first), -eos.gamma0 * 10 * 2e9 * 20 * 5e-13, 0.02);
  const auto at_the_end = [&] {
    return std::count(ps.dilation.begin(), ps.dilation.end(), mpm::MieGrueneisen::most_dilation);
  };
  EXPECT_EQ(report.largest_dilation, mpm::MieGrueneisen::most_dilation);
  EXPECT_GT(at_the_end(), 200);
  EXPECT_NEAR(report.overstrained_mass, 2.7e-11 * static_cast<double>(at_the_end()), 1e-20);
  EXPECT_NEAR((mpm::energy_of(ps).total() - before.total()) / before.total(), 0, 1e-13);
  move(-1e9);  // what is pressed together again leaves the end of the range at once
  mpm::reference_step<TypeParam>(s, material, 5e-13);
  EXPECT_LT(at_the_end(), 30);
}

// The heat of the transfer is not negative for any particle, with any share of PIC.
TYPED_TEST(StepTest, HeatOfTheTransferIsNeverNegative) {
  const mpm::Scene scene = scenes::cavity(0.2e-6);
  const mpm::MaterialModel material = mpm::build_material(scene);
  for (const double share : {0.0, 0.05, 0.5, 1.0}) {
    mpm::State s = random_state(scene, 1e-6);
    for (std::size_t p = 0; p < s.particles.size(); ++p)  // no forces, so no work; all heat is the transfer's
      s.particles.pressure[p] = 0, s.particles.deviator[p] = {};
    const std::vector<double> before = s.particles.energy;
    mpm::reference_step<TypeParam>(s, material, 5e-12, mpm::FlipPic{share});
    for (std::size_t p = 0; p < before.size(); ++p) EXPECT_GE(s.particles.energy[p], before[p]);
  }
  mpm::State s = random_state(scene, 1e-6);
  for (std::size_t p = 0; p < s.particles.size(); ++p)
    s.particles.pressure[p] = 0, s.particles.deviator[p] = {};
  const std::vector<double> before = s.particles.energy;
  mpm::reference_step<TypeParam>(s, material, 5e-12, mpm::Apic{});
  for (std::size_t p = 0; p < before.size(); ++p) EXPECT_GE(s.particles.energy[p], before[p]);
}

// With all of PIC a particle takes the velocity of the grid.
TEST(FlipPic, OfOneIsPic) {
  mpm::Node n;
  n.velocity = mpm::Vec2(3, 4), n.acceleration = mpm::Vec2(2, 1);
  mpm::Particles ps;
  ps.add({0, 0}, {7, -1}, 1, 1, {1, 1});
  mpm::FlipPic::Sums sums(ps, 0, 0.5);
  sums.add(n, 1, {0, 0});
  const double heat = mpm::FlipPic{1}.give(sums, ps, 0, 0.5);
  EXPECT_NEAR((ps.velocity[0] - n.velocity).norm(), 0, 1e-15);
  EXPECT_NEAR(heat, 0.5 * (mpm::Vec2(7, -1) - mpm::Vec2(2, 3.5)).squaredNorm(), 1e-13);
}

// What one velocity and one gradient can hold comes through unchanged: a linear field of velocity stays one,
// and costs nothing.
TYPED_TEST(StepTest, ApicCarriesALinearFieldWithoutLoss) {
  const mpm::Scene scene = scenes::cavity(0.2e-6);
  mpm::State s = mpm::build_state(scene);
  start_domains<TypeParam>(s.particles);
  mpm::Apic::start(s.particles);
  mpm::Mat2 gradient;
  gradient << 0, 0, 3e8, -2e8;  // no motion through the sides, which are mirrors
  mpm::Particles& ps = s.particles;
  std::vector<std::size_t> inner;  // away from the sides
  const double middle = 0.25 * scene.block_width;
  for (std::size_t p = 0; p < ps.size(); ++p) {
    ps.position[p].y() += 2e-6;  // away from the wall
    ps.velocity[p] = mpm::Vec2(0, 100) + gradient * ps.position[p];
    ps.affine[p] = gradient;
    if (std::abs(ps.position[p].x() - middle) < 1e-6) inner.push_back(p);
  }
  const std::vector<mpm::Vec2> velocity = ps.velocity;
  mpm::reference_step<TypeParam>(s, mpm::build_material(scene), 1e-14, mpm::Apic{});
  ASSERT_GT(inner.size(), 100u);
  for (const std::size_t p : inner) {
    EXPECT_LT((ps.velocity[p] - velocity[p]).norm(), 1e-10 * velocity[p].norm());
    EXPECT_LT((ps.affine[p] - gradient).norm(), 1e-8 * gradient.norm());
  }
}

// FLIP gains and loses angular momentum by quadrature, APIC does not: a square that turns freely.
TEST(Apic, KeepsAngularMomentum) {
  constexpr double cell = 0.2e-6, share = cell / 2;
  const mpm::Vec2 center(0, 3e-6);
  const mpm::MaterialModel material = mpm::build_material(scenes::cavity(cell));
  const auto lost = [&](const auto& transfer) {
    mpm::State s{{}, mpm::Grid({-2e-6, 0}, {cell, cell}, 20), {}, 0, 0, mpm::Floor::impact_wall};
    mpm::Particles& ps = s.particles;
    for (int j = -8; j < 8; ++j)
      for (int i = -8; i < 8; ++i) {
        const mpm::Vec2 r = share * mpm::Vec2(i + 0.5, j + 0.5);
        const double volume = share * share;
        ps.add(center + r, 1e8 * mpm::Vec2(-r.y(), r.x()), material.material.reference_density * volume,
               volume, {share / 2, share / 2});
      }
    s.velocity_gradient.assign(ps.size(), mpm::Mat2::Zero());
    const auto angular = [&] {
      double sum = 0;
      for (std::size_t p = 0; p < ps.size(); ++p) {
        const mpm::Vec2 x = ps.position[p] - center, &v = ps.velocity[p];
        sum += ps.mass[p] * (x.x() * v.y() - x.y() * v.x());
        if (ps.affine.empty()) continue;
        const mpm::Mat2& c = ps.affine[p];  // second moment of the quadratic B-spline: h^2/4
        sum += ps.mass[p] * 0.25 * cell * cell * (c(1, 0) - c(0, 1));
      }
      return sum;
    };
    const double before = angular();
    for (int k = 0; k < 200; ++k) mpm::reference_step<mpm::BSpline2>(s, material, 5e-12, transfer);
    return std::abs(angular() / before - 1);
  };
  EXPECT_LT(lost(mpm::Apic{}), 1e-12);
  EXPECT_GT(lost(mpm::Flip{}), 1e-6);
}

TYPED_TEST(StepTest, WithoutStressNothingIsLost) {
  const mpm::Scene scene = scenes::cavity(0.2e-6);
  mpm::State s = random_state(scene, 1e-6);
  for (std::size_t p = 0; p < s.particles.size(); ++p)
    s.particles.pressure[p] = 0, s.particles.deviator[p] = {};
  const double before = mpm::energy_of(s.particles).total();
  const mpm::StepReport r = mpm::reference_step<TypeParam>(s, mpm::build_material(scene), 1e-12);
  EXPECT_EQ(r.transfer_heat, 0);
  EXPECT_EQ(mpm::energy_of(s.particles).total(), before);
}

// The sides are mirrors, which push along x; along y a block that does not touch the wall is free.
TYPED_TEST(StepTest, FreeBlockKeepsItsMomentum) {
  const mpm::Scene scene = scenes::cavity(0.2e-6);
  mpm::State s = random_state(scene, 2e-6);
  const mpm::Vec2 before = mpm::momentum_of(s.particles);
  const mpm::MaterialModel material = mpm::build_material(scene);
  double scale = 0;
  for (std::size_t p = 0; p < s.particles.size(); ++p)
    scale += s.particles.mass[p] * s.particles.velocity[p].norm();
  const double energy = mpm::energy_of(s.particles).total();
  for (int k = 0; k < 5; ++k) mpm::reference_step<TypeParam>(s, material, 2e-12);
  EXPECT_NEAR((mpm::momentum_of(s.particles).y() - before.y()) / scale, 0, 1e-14);
  for (int k = 0; k < 5; ++k) mpm::reference_step<TypeParam>(s, material, 2e-12, mpm::Apic{});
  EXPECT_NEAR((mpm::momentum_of(s.particles).y() - before.y()) / scale, 0, 1e-14);
  EXPECT_NEAR(mpm::energy_of(s.particles).total() / energy, 1, 1e-13);  // that of the affine motion with it
}

// A body that flies away from the wall feels nothing of it; one that flies into it is stopped.
TYPED_TEST(StepTest, ImpactWallPushesAndDoesNotPull) {
  const mpm::Scene scene = scenes::planar(100, 2e-6, 0.1e-6, 1e-9);
  const mpm::MaterialModel material = mpm::build_material(scene);
  for (const double speed : {100.0, -100.0}) {
    mpm::State s = mpm::build_state(scene);
    for (auto& v : s.particles.velocity) v.y() = speed;
    mpm::Vec2 impulse = mpm::Vec2::Zero();
    for (int k = 0; k < 20; ++k) impulse += mpm::reference_step<TypeParam>(s, material, 2e-12).wall_impulse;
    if (speed > 0) {
      EXPECT_NEAR(impulse.y(), 0, 1e-20);  // kg/s, against some 1e-6 of a wall that pulls
      for (const double p : s.particles.pressure) EXPECT_NEAR(p, 0, 1e-3);
    } else {
      EXPECT_GT(impulse.y(), 0);
      EXPECT_GT(s.particles.pressure[0], 1e9);
    }
  }
}

// A shocked block leaves the wall once the release wave from its free surface is back: from then on there is
// no impulse, and what stood next to the wall flies with the rest instead of keeping the speed of its
// approach.
TYPED_TEST(StepTest, ShockedBlockLeavesTheWall) {
  const mpm::Scene scene = scenes::planar(200, 5e-6, 0.1e-6, 1e-9);
  const mpm::MaterialModel material = mpm::build_material(scene);
  mpm::State s = mpm::build_state(scene);
  double mass = 0, pull = 0, late = 0;
  for (const double m : s.particles.mass) mass += m;
  for (int k = 0; k < 600; ++k) {
    const double impulse = mpm::reference_step<TypeParam>(s, material, 4e-12).wall_impulse.y();
    pull = std::min(pull, impulse);
    if (s.time > 2e-9) late = std::max(late, std::abs(impulse));
  }
  EXPECT_GT(pull, -1e-14 * mass * 200);
  EXPECT_LT(late, 1e-14 * mass * 200);
  EXPECT_NEAR(mpm::momentum_of(s.particles).y() / mass, 166, 3);  // m/s; the rest shakes
  EXPECT_GT(s.particles.velocity[0].y(), 150);
}

// One particle that is not a number, or outside, is a breakdown at once; no node beyond the grid is touched.
TYPED_TEST(StepTest, ReportsWhatIsNotANumberAndWhatIsOutside) {
  const mpm::Scene scene = scenes::cavity(0.2e-6);
  const mpm::MaterialModel material = mpm::build_material(scene);
  const auto signal_after = [&](auto spoil) {
    mpm::State s = random_state(scene, 1e-6);
    spoil(s.particles);
    return mpm::reference_step<TypeParam>(s, material, 1e-12).largest_signal;
  };
  const double nan = std::numeric_limits<double>::quiet_NaN();
  EXPECT_TRUE(std::isfinite(signal_after([](mpm::Particles&) {})));
  EXPECT_TRUE(std::isnan(signal_after([&](mpm::Particles& p) { p.energy[7] = nan; })));
  EXPECT_TRUE(std::isnan(signal_after([&](mpm::Particles& p) { p.position[7].x() = nan; })));
  EXPECT_TRUE(std::isnan(signal_after([](mpm::Particles& p) { p.position[7].x() = 6e-6; })));
  EXPECT_TRUE(std::isnan(signal_after([](mpm::Particles& p) { p.position[7].y() = -1e-6; })));
}

// A rigid rotation, step by step, must not stress the material (objectivity), and a uniform flow must be seen
// exactly.
TEST(StressUpdate, RotationIsFreeOfStress) {
  const mpm::Scene scene = scenes::cavity(0.2e-6);
  mpm::State s = mpm::build_state(scene);
  mpm::StepReport report;
  const double dt = 1e-12, spin = 1e9;
  for (int k = 0; k < 1000; ++k) {
    // The velocity gradient over a step of a body that turns: (R - 1)/dt with R exact.
    mpm::Mat2 l;
    l << (std::cos(spin * dt) - 1) / dt, -std::sin(spin * dt) / dt, std::sin(spin * dt) / dt,
        (std::cos(spin * dt) - 1) / dt;
    s.velocity_gradient.assign(s.particles.size(), l);
    mpm::update_stress(s, mpm::build_material(scene), dt, report);
  }
  EXPECT_NEAR(s.particles.dilation[0], 0, 1e-12);
  EXPECT_LT(mpm::von_mises(s.particles.deviator[0]), 1);  // Pa, against 120 MPa
}

}  // namespace
