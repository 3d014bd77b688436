#include "analysis/units.hpp"

#include <gtest/gtest.h>

namespace {

using namespace analysis;

TEST(Units, PicksTheUnitInWhichNumbersAreShort) {
  EXPECT_EQ(display_unit("s", 16e-9).text, "ns");
  EXPECT_EQ(display_unit("m", 2.5e-6).text, "µm");
  EXPECT_EQ(display_unit("m^2", 7e-12).text, "µm²");
  EXPECT_EQ(display_unit("Pa", 400e6).text, "MPa");
  EXPECT_EQ(display_unit("Pa", -3e9).text, "GPa");
  EXPECT_EQ(display_unit("m^2", 1e-14).text, "µm²");  // the smallest there is
  EXPECT_EQ(display_unit("1", 0.8).text, "");
  EXPECT_EQ(display_unit("furlong", 3).text, "furlong");
  EXPECT_DOUBLE_EQ(display_unit("m^2", 7e-12).factor, 1e12);
  EXPECT_DOUBLE_EQ(display_unit("furlong", 3).factor, 1);
}

TEST(Units, Labels) {
  const Quantity radius = named_quantity("cavity_radius");
  EXPECT_EQ(axis_label(radius, display_unit("m", 1e-6)), "Cavity radius R (µm)");
  EXPECT_EQ(axis_label(named_quantity("collapsibility"), display_unit("1", 1)), "Collapsibility Φ");
  EXPECT_EQ(value_label(radius, 1.5e-6), "R = 1.5 µm");
  EXPECT_EQ(value_label(named_quantity("yield_stress"), 108.5714e6), "Y = 108.6 MPa");
  EXPECT_EQ(value_label(named_quantity("particles_per_cell"), 4), "Particles per cell = 4");
  EXPECT_EQ(axis_label(named_quantity("rod_length", "m"), display_unit("m", 0.1)), "Rod length (mm)");
}

}  // namespace
