#pragma once
#include <gtest/gtest.h>

#include "runner/bench/exact/exact_bench.hpp"

/// One number within its tolerance.
inline void expect_holds(const mpmstudy::ExactNumber& n) {
  EXPECT_TRUE(n.holds()) << n.quantity << ": exact " << n.exact << ", ours " << n.ours << ", error "
                         << n.error() << ", tolerance " << n.tolerance;
}
inline void expect_all_hold(const mpmstudy::ExactNumbers& numbers) {
  EXPECT_FALSE(numbers.empty());
  for (const mpmstudy::ExactNumber& n : numbers) expect_holds(n);
}
