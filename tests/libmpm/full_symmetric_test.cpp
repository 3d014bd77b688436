// The tensors of three axes, and objectivity of the materials that are written over them.
#include <gtest/gtest.h>

#include <Eigen/Geometry>
#include <Eigen/LU>
#include <cmath>
#include <limits>
#include <random>

#include "libmpm/core/tensor.hpp"
#include "libmpm/material/list.hpp"

namespace {

using mpm::Mat3;
using mpm::Vec3;
using Deviator = mpm::FullDeviator<double>;
using Gradient = mpm::FullGradient<double>;
using Strain = mpm::Strain<double, mpm::space::ThreeD>;

Gradient gradient(const Mat3& m) {
  return {m(0, 0), m(0, 1), m(0, 2), m(1, 0), m(1, 1), m(1, 2), m(2, 0), m(2, 1), m(2, 2)};
}
Mat3 matrix(const Deviator& s) {
  Mat3 m;
  m << s.xx, s.xy, s.xz, s.xy, s.yy, s.yz, s.xz, s.yz, -(s.xx + s.yy);
  return m;
}
Mat3 matrix(const mpm::FullIncrement<double>& e) {
  Mat3 m;
  m << e.xx, e.xy, e.xz, e.xy, e.yy, e.yz, e.xz, e.yz, e.zz;
  return m;
}
Mat3 matrix(const mpm::FullRotation<double>& r) {
  Mat3 m;
  m << r.xx, r.xy, r.xz, r.yx, r.yy, r.yz, r.zx, r.zy, r.zz;
  return m;
}
Mat3 turn(double angle, const Vec3& axis) { return Eigen::AngleAxisd(angle, axis.normalized()).matrix(); }

const Deviator some{30e6, -12e6, 7e6, -19e6, 25e6}, other{-3e6, 8e6, 21e6, 4e6, -15e6};
const mpm::FullIncrement<double> increment{1e-3, -2e-3, 4e-3, 3e-3, 5e-3, -6e-3};

TEST(FullSymmetric, FunctionsAreThoseOfMatrices) {
  const Mat3 s = matrix(some), o = matrix(other), e = matrix(increment);
  EXPECT_NEAR(second_invariant(some) / (0.5 * s.squaredNorm()), 1, 1e-15);
  EXPECT_NEAR(contract(some, other) / s.cwiseProduct(o).sum(), 1, 1e-14);
  EXPECT_NEAR(contract(some, increment) / s.cwiseProduct(e).sum(), 1, 1e-14);
  EXPECT_NEAR(trace(increment), e.trace(), 1e-18);
  const Mat3 without_trace = e - e.trace() / 3 * Mat3::Identity();
  EXPECT_LT((matrix(deviator(increment)) - without_trace).norm(), 1e-17);
  EXPECT_LT((matrix(sum(some, 3.0, other)) - (s + 3 * o)).norm(), 1e-7);
  EXPECT_LT((matrix(some - other) - (s - o)).norm(), 1e-7);
  EXPECT_LT((matrix(scaled(0.5, some)) - 0.5 * s).norm(), 1e-7);
}

TEST(FullSymmetric, GrowthAndMidpointAreThoseOfMatrices) {
  Mat3 l;
  l << 0.02, -0.1, 0.07, 0.3, -0.05, 0.11, -0.2, 0.06, 0.09;
  const Mat3 one = Mat3::Identity();
  EXPECT_NEAR(growth_of(gradient(l)), (one + l).determinant() - 1, 1e-15);
  EXPECT_NEAR(growth_of(gradient(1e-12 * l)) / 6e-14, 1, 1e-6);  // the digits of small strains
  const Mat3 middle = l * (one + 0.5 * l).inverse();
  const Gradient m = midpoint(gradient(l));
  EXPECT_LT((matrix(symmetric_part(m)) - 0.5 * (middle + middle.transpose())).norm(), 1e-15);
  const Mat3 half_spin = 0.25 * (middle - middle.transpose());
  EXPECT_LT((matrix(rotation_of_spin(m)) - (one - half_spin).inverse() * (one + half_spin)).norm(), 1e-15);
}

using Elastic = mpm::Solid<double, mpm::MieGrueneisenEos, mpm::Elastic>;

/// Angle and axis at will: dt L = R - 1 strains nothing, and turns the deviator by R.
TEST(StrainOver, ARigidRotationInSpaceStrainsNothing) {
  const mpm::Material aluminium = mpm::named_material("aluminium");
  const Elastic solid(mpm::MaterialModel{aluminium, {}});
  const Mat3 r = turn(0.4, {0.6, -0.5, 0.7});
  double dilation = 0.1;
  const Strain e =
      mpm::strain_over<double, mpm::space::ThreeD>(dilation, gradient(r - Mat3::Identity()), solid);
  EXPECT_NEAR(dilation, 0.1, 1e-15);
  EXPECT_NEAR(e.compression, 1 / 1.1 - 1, 1e-15);
  EXPECT_LT(matrix(e.rate).norm(), 1e-15);
  EXPECT_LT((matrix(e.rotation) - r).norm(), 1e-15);
  EXPECT_NEAR(e.divisor, 1, 1e-15);
  EXPECT_LT((matrix(rotated(e.rotation, some)) - r * matrix(some) * r.transpose()).norm(), 1e-7);
}

/// A material point that is driven through random strains, seen by an observer who is turned by `frame`.
struct Driven {
  Mat3 stress;
  double pressure, plastic_strain, plastic_work, energy;
};
Driven drive(const mpm::MaterialModel& material, const Mat3& frame) {
  Driven end{};
  mpm::with_model<double>(material, [&](const auto& model, std::size_t) {
    double dilation = 0, energy = 0, pressure = 0, viscous = 0, own[7] = {};
    Deviator s{};
    std::mt19937 generator(11);
    for (int k = 0; k < 200; ++k) {
      Mat3 l;
      for (int i = 0; i < 3; ++i)
        for (int j = 0; j < 3; ++j)
          l(i, j) = 2e-3 * (generator() / 2147483648.0 - 1) + (i == 0 && j == 1) * 1e-3;
      const auto e = mpm::strain_over<double, mpm::space::ThreeD>(
          dilation, gradient(frame * l * frame.transpose()), model);
      const mpm::Point<double, Deviator> point{dilation, energy, s, pressure, viscous, own};
      model.shear(point, e, 1e9);
      model.bulk(point, e, 1e9);
      energy += contract(s, e.rate) / material.material.reference_density;
    }
    end = {frame.transpose() * matrix(s) * frame, pressure, own[0], own[1], energy};
  });
  return end;
}

TEST(Materials, AreObjectiveInSpace) {
  for (const double fraction : {0.0, 0.5})
    for (const double yield : {120e6, std::numeric_limits<double>::infinity()}) {
      mpm::Material m = mpm::named_material("aluminium");
      m.kinematic_fraction = fraction, m.yield_stress = yield;
      const mpm::MaterialModel material{m, {0.1, 1.5, 1e-6}};
      const Driven here = drive(material, Mat3::Identity());
      const Driven there = drive(material, turn(1.1, {0.3, 0.8, -0.4}));
      ASSERT_GT(here.stress.norm(), 1e7);
      EXPECT_EQ(here.plastic_strain > 1e-2, std::isfinite(yield));
      EXPECT_LT((there.stress - here.stress).norm(), 1e-10 * here.stress.norm());
      EXPECT_NEAR(there.pressure / here.pressure, 1, 1e-10);
      EXPECT_NEAR(there.energy / here.energy, 1, 1e-10);
      if (!std::isfinite(yield)) continue;
      EXPECT_NEAR(there.plastic_strain / here.plastic_strain, 1, 1e-10);
      EXPECT_NEAR(there.plastic_work / here.plastic_work, 1, 1e-10);
    }
}

}  // namespace
