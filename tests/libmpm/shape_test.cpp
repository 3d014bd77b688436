// Every shape function: partition of unity, linear reproduction, slopes that are derivatives.
#include <gtest/gtest.h>

#include "libmpm/shape/bspline2.hpp"
#include "libmpm/shape/gimp.hpp"

namespace {

template <class Shape>
class ShapeTest : public testing::Test {};
using Shapes = testing::Types<mpm::Gimp, mpm::BSpline2>;
TYPED_TEST_SUITE(ShapeTest, Shapes);

constexpr double halves[] = {0.05, 0.25, 0.4, 0.5};

TYPED_TEST(ShapeTest, ReproducesConstantsAndLinearFunctions) {
  for (const double half : halves)
    for (double xi = -0.4; xi < 3; xi += 0.0371) {
      const mpm::Weights w = TypeParam::evaluate(xi, half);
      double sum = 0, slope = 0, position = 0, gradient = 0;
      for (int k = 0; k < 3; ++k) {
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
      const mpm::Weights w = TypeParam::evaluate(xi, half);
      const mpm::Weights low = TypeParam::evaluate(xi - d, half), high = TypeParam::evaluate(xi + d, half);
      if (low.first != high.first) continue;
      for (int k = 0; k < 3; ++k) EXPECT_NEAR(w.slope[k], (high.value[k] - low.value[k]) / (2 * d), 2e-5);
    }
}

TEST(Gimp, OfOneCellIsTheQuadraticBSpline) {
  for (double xi = 0; xi < 2; xi += 0.0371) {
    const mpm::Weights a = mpm::Gimp::evaluate(xi, 0.5), b = mpm::BSpline2::evaluate(xi, 0);
    ASSERT_EQ(a.first, b.first);
    for (int k = 0; k < 3; ++k) EXPECT_NEAR(a.value[k], b.value[k], 1e-15);
  }
}

TEST(Gimp, TreatsADomainWiderThanACellAsOneCell) {
  const mpm::Weights a = mpm::Gimp::evaluate(1.3, 0.8), b = mpm::Gimp::evaluate(1.3, 0.5);
  EXPECT_EQ(a.value, b.value);
}

}  // namespace
