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

}  // namespace
