// Strong shocks of an ideal gas: Noh's inflow and Sedov's explosion, on coarse cells.
#include <gtest/gtest.h>

#include "libmpm/verification/problems/problems.hpp"
#include "tests/verification/expect_numbers.hpp"

namespace {

using mpm::Space;

TEST(Noh, CylinderIsStoppedByItsShock) {
  expect_all_hold(mpm::verification::noh_numbers(Space::plane_strain, {}));
}
TEST(Noh, SphereIsStoppedByItsShock) {
  expect_all_hold(mpm::verification::noh_numbers(Space::axisymmetric, {}));
}
TEST(Sedov, CylinderRunsAsFarAsItsEnergySays) {
  expect_all_hold(mpm::verification::sedov_numbers(Space::plane_strain, {}));
}
TEST(Sedov, SphereRunsAsFarAsItsEnergySays) {
  expect_all_hold(mpm::verification::sedov_numbers(Space::axisymmetric, {}));
}

}  // namespace
