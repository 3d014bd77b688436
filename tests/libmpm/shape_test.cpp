// Every shape function: partition of unity, linear reproduction, slopes that are derivatives.
#include <gtest/gtest.h>

#include "libmpm/shape/bspline2.hpp"
#include "libmpm/shape/bspline3.hpp"
#include "libmpm/shape/cpdi.hpp"
#include "libmpm/shape/gimp.hpp"
#include "libmpm/shape/linear.hpp"

namespace {

template <class Shape>
class ShapeTest : public testing::Test {};
using Shapes = testing::Types<mpm::Linear, mpm::Gimp, mpm::BSpline2, mpm::BSpline3>;
TYPED_TEST_SUITE(ShapeTest, Shapes);

constexpr double halves[] = {0.05, 0.25, 0.4, 0.5};

TYPED_TEST(ShapeTest, ReproducesConstantsAndLinearFunctions) {
  for (const double half : halves)
    for (double xi = -0.4; xi < 3; xi += 0.0371) {
      const auto w = TypeParam::evaluate(xi, half);
      double sum = 0, slope = 0, position = 0, gradient = 0;
      for (int k = 0; k < w.nodes; ++k) {
        EXPECT_GE(w.value[k], 0);
        sum += w.value[k];
        slope += w.slope[k];
        position += w.value[k] * (w.first + k);
        gradient += w.slope[k] * (w.first + k);
      }
      EXPECT_NEAR(sum, 1, 1e-15);
      EXPECT_NEAR(slope, 0, 1e-14);
      EXPECT_NEAR(position, xi, 2e-15);
      EXPECT_NEAR(gradient, 1, 1e-14);
    }
}

TYPED_TEST(ShapeTest, SlopesAreDerivatives) {
  constexpr double d = 1e-6;
  for (const double half : halves)
    for (double xi = 0.0113; xi < 2; xi += 0.0371) {
      const auto w = TypeParam::evaluate(xi, half);
      const auto low = TypeParam::evaluate(xi - d, half), high = TypeParam::evaluate(xi + d, half);
      if (low.first != high.first) continue;
      for (int k = 0; k < w.nodes; ++k)
        EXPECT_NEAR(w.slope[k], (high.value[k] - low.value[k]) / (2 * d), 2e-5);
    }
}

TEST(Gimp, OfOneCellIsTheQuadraticBSpline) {
  for (double xi = 0; xi < 2; xi += 0.0371) {
    const mpm::Weights a = mpm::Gimp::evaluate(xi, 0.5), b = mpm::BSpline2::evaluate(xi, 0);
    ASSERT_EQ(a.first, b.first);
    for (int k = 0; k < 3; ++k) EXPECT_NEAR(a.value[k], b.value[k], 1e-15);
  }
}

TEST(Gimp, DomainFollowsTheDiagonalStretch) {
  const mpm::Grid grid({0, 0}, {1, 1}, 8);
  mpm::Particles ps;
  ps.add({2.2, 3.4}, {0, 0}, 1, 1, {0.25, 0.25});
  mpm::Gimp::follow(grid, ps, 0, (mpm::Mat2() << 0.1, 0.2, 0.3, -0.2).finished());
  EXPECT_EQ(ps.half_size[0], mpm::Vec2(0.25 * 1.1, 0.25 * 0.8));
}

/// A particle whose parallelogram is sheared and turned.
mpm::Particles sheared_particle(const mpm::Vec2& x) {
  mpm::Particles ps;
  ps.add(x, {0, 0}, 1, 1, {0.3, 0.2});
  mpm::Cpdi::start(ps);
  const mpm::Grid grid({0, 0}, {1, 1}, 8);
  mpm::Cpdi::follow(grid, ps, 0, (mpm::Mat2() << 0.1, 0.7, 0.4, 0.2).finished());
  return ps;
}

TEST(Cpdi, ReproducesLinearFunctionsAndTheirGradientWithAnyDomain) {
  mpm::Grid grid({0, 0}, {1, 1}, 8);
  grid.grow_to_row(12);
  for (double x = 0.1; x < 4; x += 0.237) {
    const mpm::Particles ps = sheared_particle({x, 0.7 * x + 0.2});
    double sum = 0;
    mpm::Vec2 position = mpm::Vec2::Zero();
    mpm::Mat2 gradient = mpm::Mat2::Zero();
    mpm::Cpdi::stencil(grid, ps, 0).for_each(grid, [&](mpm::Node& n, double w, const mpm::Vec2& g) {
      const auto k = static_cast<int>(&n - grid.nodes().data());
      const mpm::Vec2 at(k % grid.stride() - mpm::Grid::ghosts, k / grid.stride() - mpm::Grid::ghosts);
      sum += w;
      position += w * at;
      gradient += at * g.transpose();
    });
    EXPECT_NEAR(sum, 1, 1e-15);
    EXPECT_NEAR((position - ps.position[0]).norm(), 0, 4e-15);
    EXPECT_NEAR((gradient - mpm::Mat2::Identity()).norm(), 0, 1e-13);
  }
}

TEST(Cpdi, DomainFollowsTheWholeDeformationUpToItsGuard) {
  const mpm::Particles ps = sheared_particle({2, 2});
  EXPECT_NEAR((ps.domain[0] - (mpm::Mat2() << 0.33, 0.14, 0.12, 0.24).finished()).norm(), 0, 1e-15);
  mpm::Particles torn = ps;
  torn.dilation[0] = -0.84;  // the volume is 0.16
  mpm::Cpdi::follow(mpm::Grid({0, 0}, {1, 1}, 8), torn, 0, 2 * mpm::Mat2::Identity());
  EXPECT_NEAR((torn.domain[0] - 0.2 * mpm::Mat2::Identity()).norm(), 0, 1e-15);
}

TEST(Gimp, TreatsADomainWiderThanACellAsOneCell) {
  const mpm::Weights a = mpm::Gimp::evaluate(1.3, 0.8), b = mpm::Gimp::evaluate(1.3, 0.5);
  EXPECT_EQ(a.value, b.value);
}

}  // namespace
