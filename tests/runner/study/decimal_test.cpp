#include "runner/study/decimal.hpp"

#include <gtest/gtest.h>

#include <cmath>

namespace mpmstudy {
namespace {

TEST(ScaledDecimal, IsTheNearestDouble) {
  EXPECT_EQ(scaled_decimal("10", -6), 10e-6);
  EXPECT_EQ(scaled_decimal("0.01", -3), 1e-5);
  EXPECT_EQ(scaled_decimal("1e-5", 0), 1e-5);
  EXPECT_EQ(scaled_decimal("1E+1", -6), 1e-5);
  EXPECT_EQ(scaled_decimal("-0.3", 6), -0.3e6);
  EXPECT_NE(2.9 * 1e-6, 2.9e-6);  // why a product will not do
  EXPECT_EQ(scaled_decimal("2.9", -6), 2.9e-6);
}

TEST(ScaledDecimal, RefusesWhatIsNoNumberOrOutOfRange) {
  for (const char* text : {"", "x", "1x", "1e", "1e5.5", "nan", "inf", "1e99999999999", "1e400", "1e-400"})
    EXPECT_FALSE(scaled_decimal(text, 0)) << text;
  EXPECT_FALSE(scaled_decimal("1e300", 9));
}

TEST(Round, KeepsTwelveDigits) {
  EXPECT_EQ(round_to_12_digits(0.1 + 0.2), 0.3);
  EXPECT_EQ(round_to_12_digits(108.57142857142857), 108.571428571);
  EXPECT_EQ(round_to_12_digits(0), 0);
}

TEST(WithoutRounding, GivesWhatWasWrittenAndKeepsWhatWasNot) {
  EXPECT_EQ(without_rounding(6e-6 - 1e-6 - 1e-6), 4e-6);
  EXPECT_EQ(without_rounding(1.2999999999999998e-06), 1.3e-6);
  EXPECT_EQ(without_rounding(std::nextafter(1e-6, 1)), 1e-6);
  for (const double value : {0.0, 1.0 / 3, 1.23456789012345e-6, 1e-7 / std::sqrt(2.0), HUGE_VAL, -2.5})
    EXPECT_EQ(without_rounding(value), value);
}

TEST(ShortestText, ReadsBack) {
  for (const double value : {0.1, 1e-5, 340.0 / 7, 6.02e23})
    EXPECT_EQ(std::stod(shortest_text(value)), value);
}

}  // namespace
}  // namespace mpmstudy
