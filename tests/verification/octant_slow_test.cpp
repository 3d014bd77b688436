// The imploding sphere in three dimensions on its own cells, and the manufactured solution of three axes down
// to half a percent.
#include <gtest/gtest.h>

#include "libmpm/verification/problems/problems.hpp"
#include "tests/verification/expect_numbers.hpp"

namespace {

class FineOctant : public testing::TestWithParam<double> {};

TEST_P(FineOctant, StopsWhereItShould) {
  expect_all_hold(mpm::verification::imploding_octant_numbers(GetParam(), {}));
}

INSTANTIATE_TEST_SUITE_P(Speeds, FineOctant, testing::Values(234.7, 277.3, 306.9));

TEST(FineConvergence, CubeWaves) { expect_all_hold(mpm::verification::cube_waves_numbers({})); }

}  // namespace
