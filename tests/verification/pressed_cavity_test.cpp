// A spherical cavity in a solid under pressure. Finer cells and the other pressures:
// pressed_cavity_slow_test.cpp.
#include <gtest/gtest.h>

#include "libmpm/verification/problems/problems.hpp"
#include "tests/verification/expect_numbers.hpp"

namespace {

class PressedCavity : public testing::TestWithParam<double> {};

TEST_P(PressedCavity, StopsOrClosesWhenItShould) {
  expect_all_hold(mpm::verification::pressed_cavity_numbers(GetParam(), {.cells = 1.25}));
}

INSTANTIATE_TEST_SUITE_P(SharesOfTheClosingPressure, PressedCavity, testing::Values(0.5, 1.05));

}  // namespace
