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
  const QuantityLabel radius = quantity_label("cavity_radius", "m", "R");
  EXPECT_EQ(axis_label(radius, display_unit("m", 1e-6)), "Cavity radius R (µm)");
  EXPECT_EQ(axis_label(quantity_label("collapsibility", "1", "Φ"), display_unit("1", 1)), "Collapsibility Φ");
  EXPECT_EQ(value_label(radius, 1.5e-6), "R = 1.5 µm");
  EXPECT_EQ(value_label(quantity_label("yield_stress", "Pa", "Y"), 108.5714e6), "Y = 108.6 MPa");
  EXPECT_EQ(value_label(quantity_label("particles_per_cell"), 4), "Particles per cell = 4");
  EXPECT_EQ(axis_label(quantity_label("rod_length", "m"), display_unit("m", 0.1)), "Rod length (mm)");
}

TEST(Units, ColumnsAndMetricsAreNamedWithoutTheirUnits) {
  const auto label = [](const char* name, const char* unit, double largest) {
    const QuantityLabel quantity = quantity_label(name, unit);
    return axis_label(quantity, display_unit(quantity.unit, largest));
  };
  EXPECT_EQ(label("centroid_shift_m", "m", 2e-7), "Centroid shift (nm)");
  EXPECT_EQ(label("final_void_area_m2", "m2", 2e-12), "Final void area (µm²)");
  EXPECT_EQ(label("hot_spot_work_J_m3", "J/m3", 2e9), "Hot spot work (GJ/m³)");
  EXPECT_EQ(quantity_label("hot_spot_work_J_m3", "J/m3", "", "Work of the hot spot").name,
            "Work of the hot spot");
}

TEST(Units, LabelsHaveDigitsUntilTheyDiffer) {
  const QuantityLabel speed = quantity_label("impact_speed", "m/s", "u"),
                      time = quantity_label("time", "s", "t");
  using Labels = std::vector<std::string>;
  EXPECT_EQ(value_labels(speed, std::vector{1500.0, 1500.1, 1500.2}),
            (Labels{"u = 1.5 km/s", "u = 1.5001 km/s", "u = 1.5002 km/s"}));
  EXPECT_EQ(value_labels(time, std::vector{1e-9, 1.0001e-9, 1e-9}),
            (Labels{"t = 1 ns", "t = 1.0001 ns", "t = 1 ns"}));
  EXPECT_EQ(value_labels(speed, std::vector<double>{}), Labels{});
}

}  // namespace
