#include "analysis/student_t.hpp"

#include <gtest/gtest.h>

namespace {

using analysis::student_t_two_sided;

/// Quantiles as every table of Student's distribution prints them (two-sided 95 and 99 %).
TEST(StudentT, TabulatedQuantiles) {
  EXPECT_NEAR(student_t_two_sided(0.95, 1), 12.706205, 1e-6);
  EXPECT_NEAR(student_t_two_sided(0.95, 2), 4.302653, 1e-6);
  EXPECT_NEAR(student_t_two_sided(0.95, 3), 3.182446, 1e-6);
  EXPECT_NEAR(student_t_two_sided(0.95, 4), 2.776445, 1e-6);
  EXPECT_NEAR(student_t_two_sided(0.95, 5), 2.570582, 1e-6);
  EXPECT_NEAR(student_t_two_sided(0.95, 30), 2.042272, 1e-6);
  EXPECT_NEAR(student_t_two_sided(0.99, 10), 3.169273, 1e-6);
  EXPECT_NEAR(student_t_two_sided(0.95, 0), 1.959964, 1e-6);
}

}  // namespace
