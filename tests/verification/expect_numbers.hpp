#pragma once
#include <gtest/gtest.h>

#include "libmpm/verification/problems/exact_bench.hpp"

/// One number within its tolerance.
inline void expect_holds(const mpm::verification::ExactNumber& n) {
  EXPECT_TRUE(n.holds()) << n.quantity << ": exact " << n.exact << ", ours " << n.ours << ", error "
                         << n.error() << ", tolerance " << n.tolerance;
}
inline void expect_all_hold(const mpm::verification::ExactNumbers& numbers) {
  EXPECT_FALSE(numbers.empty());
  for (const mpm::verification::ExactNumber& n : numbers) expect_holds(n);
}
