#include "runner/study/units.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "runner/study/quantity_text.hpp"

namespace mpmstudy {
namespace {

using testing::HasSubstr;

double si(const Units& units, const char* number, const char* unit, const char* to) {
  const auto conversion = units.conversion(unit, to);
  if (const auto* wrong = std::get_if<std::string>(&conversion)) throw std::runtime_error(*wrong);
  return std::get<Conversion>(conversion)(number).value();
}

TEST(Units, PowersOfTenAreExact) {
  const Units units;
  EXPECT_EQ(si(units, "10", "um", "m"), 1e-5);
  EXPECT_EQ(si(units, "0.01", "mm", "m"), 1e-5);
  EXPECT_EQ(si(units, "1e-5", "m", "m"), 1e-5);
  EXPECT_EQ(si(units, "10", "\u00b5m", "m"), 1e-5);
  EXPECT_EQ(si(units, "1.62", "ns", "s"), 1.62e-9);
  EXPECT_EQ(si(units, "384", "MPa", "Pa"), 384e6);
  EXPECT_EQ(si(units, "69", "GPa", "Pa"), 69e9);
  EXPECT_EQ(si(units, "1.12", "km/s", "m/s"), 1120);
  EXPECT_EQ(si(units, "5.35", "mm/us", "m/s"), 5350);
  EXPECT_EQ(si(units, "2700", "kg/m3", "kg/m3"), 2700);
  EXPECT_EQ(si(units, "2.7", "g/cm3", "kg/m3"), 2700);
  EXPECT_EQ(si(units, "880", "J/kg/K", "J/kg/K"), 880);
  EXPECT_EQ(si(units, "0.88", "kJ kg-1 K-1", "J/kg/K"), 880);
  EXPECT_EQ(si(units, "30", "%", "1"), 0.3);
}

TEST(Units, OthersAreConverted) {
  const Units units;
  EXPECT_EQ(si(units, "2", "min", "s"), 120);
  EXPECT_DOUBLE_EQ(si(units, "26.85", "degC", "K"), 300);
  EXPECT_DOUBLE_EQ(si(units, "1", "inch", "m"), 0.0254);
}

TEST(Units, WrongOnesAreNamed) {
  const Units units;
  const auto wrong = [&](const char* unit, const char* to) {
    const auto conversion = units.conversion(unit, to);
    const auto* text = std::get_if<std::string>(&conversion);
    return text ? *text : "";
  };
  EXPECT_THAT(wrong("kg", "m/s"), HasSubstr("'kg' is not a unit of this quantity"));
  EXPECT_THAT(wrong("Mpa", "Pa"), HasSubstr("'Mpa' is not a unit"));
  EXPECT_THAT(wrong("5um", "m"), HasSubstr("not a unit"));
  EXPECT_THAT(wrong("000 um", "m"), HasSubstr("not a unit"));
  EXPECT_THAT(wrong("Hz", "s"), HasSubstr("not a unit of this"));        // no reciprocals
  EXPECT_THAT(wrong("lg(re m)", "m"), HasSubstr("not a unit of this"));  // no logarithms
  EXPECT_THAT(wrong("s @ 10", "s"), HasSubstr("not a unit"));
  EXPECT_THAT(wrong("m", "1"), HasSubstr("not a pure number"));
}

/// Where a number ends and its unit begins is decided once, also for units that begin with an e.
TEST(Quantities, AWidthIsOfNoUnitWithAZeroPointOfItsOwn) {
  const Units units;
  const auto width = [&](const char* text, const char* unit) {
    const Value value{Place{}, std::string(text)};
    return read_quantity(value, {unit, mpm::Range::positive, true}, units);
  };
  EXPECT_EQ(std::get<double>(width("20 K", "K")), 20);
  EXPECT_EQ(std::get<double>(width("2e1 K", "K")), 20);
  EXPECT_EQ(std::get<double>(width("2 EK", "K")), 2e18);
  EXPECT_EQ(std::get<double>(width("2EPa", "Pa")), 2e18);
  EXPECT_EQ(std::get<double>(width("2 min", "s")), 120);
  for (const char* text : {"20 degC", "2e1 degC", "20degF"})
    EXPECT_THAT(std::get<Refusal>(width(text, "K")).wrong, HasSubstr("zero point")) << text;
  const Value place{Place{}, std::string("20 degC")};
  EXPECT_DOUBLE_EQ(std::get<double>(read_quantity(place, {"K", mpm::Range::positive}, units)), 293.15);
}

TEST(Units, SaysNothingOnItsOwn) {
  testing::internal::CaptureStderr();
  testing::internal::CaptureStdout();
  const Units units;
  units.conversion("no such unit (", "m");
  units.conversion("kg", "m");
  EXPECT_EQ(testing::internal::GetCapturedStderr(), "");
  EXPECT_EQ(testing::internal::GetCapturedStdout(), "");
}

}  // namespace
}  // namespace mpmstudy
