// The imploding sphere in axisymmetry against the closed form and the one-dimensional code.
#include <gtest/gtest.h>

#include "libmpm/verification/problems/problems.hpp"
#include "tests/verification/expect_numbers.hpp"

namespace {

class SphericalShell : public testing::TestWithParam<double> {};

TEST_P(SphericalShell, StopsWhereItShould) {
  const auto numbers = mpm::verification::imploding_sphere_numbers(GetParam(), {});
  for (const auto& number : numbers) expect_holds(number);
}

INSTANTIATE_TEST_SUITE_P(Speeds, SphericalShell, testing::Values(234.7, 277.3, 306.9));

// An octant of it in three dimensions, on ten cells across the wall: 1 % of the radius, 2 % of the time, 1 %
// of roundness. Finer ones: octant_slow_test.cpp.
TEST(ImplodingOctant, StopsWhereItShould) {
  const auto numbers = mpm::verification::imploding_octant_numbers(277.3, {.cells = 1.6});
  expect_all_hold(numbers);
}

// A cavity at 200 m/s that has closed to a third.
TEST(SphericalCavity, InThreeDimensionsIsThatOfAxialSymmetry) {
  expect_all_hold(mpm::verification::spherical_cavity_numbers({.cells = 1.25}));
}

}  // namespace
