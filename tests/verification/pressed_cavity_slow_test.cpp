// A spherical cavity in a solid under pressure, on its own cells.
#include <gtest/gtest.h>

#include "libmpm/verification/problems/problems.hpp"
#include "tests/verification/expect_numbers.hpp"

namespace {

class FinePressedCavity : public testing::TestWithParam<double> {};

TEST_P(FinePressedCavity, StopsOrClosesWhenItShould) {
  expect_all_hold(mpm::verification::pressed_cavity_numbers(GetParam(), {}));
}

INSTANTIATE_TEST_SUITE_P(SharesOfTheClosingPressure, FinePressedCavity, testing::Values(0.8, 0.95, 1.5));

}  // namespace
