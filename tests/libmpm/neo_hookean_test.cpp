// The neo-Hookean material against its closed form, in each space.
#include "libmpm/material/neo_hookean.hpp"

#include <gtest/gtest.h>

#include <Eigen/Geometry>
#include <random>

#include "libmpm/core/tensor.hpp"
#include "libmpm/material/list.hpp"

namespace {

using mpm::Mat3;

mpm::Material rubber() {
  mpm::Material m;
  m.law = mpm::MaterialLaw::neo_hookean;
  m.reference_density = 1100;
  m.youngs_modulus = 5e6;
  m.poissons_ratio = 0.4;
  m.pressure_limit = 1e12;
  return m;
}
const double lambda = 5e6 * 0.4 / (1.4 * 0.2), mu = 5e6 / 2.8;

/// With digits for strains that are small against 1.
using Long3 = Eigen::Matrix<long double, 3, 3>;

/// J sigma = lambda ln J 1 + mu (F F^T - 1)
Mat3 exact_stress(const Long3& f) {
  const long double j = f.determinant();
  const Long3 stress =
      (lambda * std::log(j) * Long3::Identity() + mu * (f * f.transpose() - Long3::Identity())) / j;
  return stress.cast<double>();
}

mpm::Gradient<double> in_plane(const Mat3& l) { return {l(0, 0), l(0, 1), l(1, 0), l(1, 1)}; }

/// Drives a point by random displacements that leave the space in itself, and compares.
template <class Space>
void expect_exact(double size, double tolerance) {
  const mpm::NeoHookean<double> model(mpm::MaterialModel{rubber(), {0, 0, 1}});
  constexpr bool full = Space::axes == 3;
  typename Space::template Deviator<double> s{};
  double dilation = 0, pressure = 0, viscous = 0, own[mpm::numbers_in(model.state, Space::axes)] = {};
  const double energy = 0;
  Long3 f = Long3::Identity();
  std::mt19937 generator(5);
  const auto random = [&] { return size * (generator() / 2147483648.0 - 1); };
  for (int k = 0; k < 50; ++k) {
    Mat3 l = Mat3::Zero();
    for (int i = 0; i < Space::axes; ++i)
      for (int j = 0; j < Space::axes; ++j) l(i, j) = random();
    if (Space::has_hoop) l(2, 2) = random();
    f = (Long3::Identity() + l.cast<long double>()) * f;
    const auto strain = [&] {
      if constexpr (full)
        return mpm::strain_over<double, Space>(
            dilation,
            mpm::FullGradient<double>{l(0, 0), l(0, 1), l(0, 2), l(1, 0), l(1, 1), l(1, 2), l(2, 0), l(2, 1),
                                      l(2, 2)},
            model);
      else
        return mpm::strain_over<double, Space>(dilation, in_plane(l), model, l(2, 2));
    }();
    const mpm::Point<double, typename Space::template Deviator<double>> point{dilation, energy,  s,
                                                                              pressure, viscous, own};
    model.shear(point, strain, 1);
    model.bulk(point, strain, 1);
  }
  Mat3 ours = Mat3::Zero();
  ours(0, 0) = s.xx, ours(1, 1) = s.yy, ours(2, 2) = -(s.xx + s.yy), ours(0, 1) = ours(1, 0) = s.xy;
  if constexpr (full) ours(0, 2) = ours(2, 0) = s.xz, ours(1, 2) = ours(2, 1) = s.yz;
  ours -= pressure * Mat3::Identity();
  const Mat3 exact = exact_stress(f);
  EXPECT_LT((ours - exact).norm(), tolerance * exact.norm());
  EXPECT_EQ(viscous, 0);
}

TEST(NeoHookean, FollowsItsClosedForm) {
  for (const double size : {0.1, 1e-3}) {
    expect_exact<mpm::space::PlaneStrain>(size, 1e-12);
    expect_exact<mpm::space::Axisymmetric>(size, 1e-12);
    expect_exact<mpm::space::ThreeD>(size, 1e-12);
  }
  expect_exact<mpm::space::ThreeD>(1e-9, 1e-9);  // small strains keep their digits
}

/// A turn leaves the stress as it is in the body, whatever its angle.
TEST(NeoHookean, IsObjective) {
  const mpm::NeoHookean<double> model(mpm::MaterialModel{rubber(), {0, 0, 1}});
  const mpm::FullSymmetric<double> b{0.3, -0.2, 0.1, 0.05, -0.1, 0.2};
  Mat3 before;
  before << b.xx, b.xy, b.xz, b.xy, b.yy, b.yz, b.xz, b.yz, b.zz;
  const Mat3 r = Eigen::AngleAxisd(0.9, mpm::Vec3(0.3, -0.5, 0.8).normalized()).toRotationMatrix();
  const Mat3 l = r - Mat3::Identity();
  const auto after = mpm::carried(mpm::FullGradient<double>{l(0, 0), l(0, 1), l(0, 2), l(1, 0), l(1, 1),
                                                            l(1, 2), l(2, 0), l(2, 1), l(2, 2)},
                                  b);
  const Mat3 turned = r * before * r.transpose();
  EXPECT_NEAR(after.xx, turned(0, 0), 1e-15);
  EXPECT_NEAR(after.zz, turned(2, 2), 1e-15);
  EXPECT_NEAR(after.yz, turned(1, 2), 1e-15);
  EXPECT_NEAR(after.xy, turned(0, 1), 1e-15);
}

TEST(NeoHookean, SaysItsSoundSpeedAndItsColumn) {
  EXPECT_NEAR(mpm::sound_speed_at_rest(rubber()), std::sqrt((lambda + 2 * mu) / 1100), 1e-9);
  const auto columns = mpm::state_columns(rubber());
  ASSERT_EQ(columns.size(), 1u);
  EXPECT_EQ(columns[0].name, "left_cauchy_green_less_one");
  EXPECT_EQ(mpm::numbers_in(columns, 2), 4);
  EXPECT_EQ(mpm::numbers_in(columns, 3), 6);
}

}  // namespace
