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

TEST(Units, ColumnsAndMetricsAreNamedWithoutTheirUnits) {
  const auto label = [](const char* name, const char* unit, double largest) {
    const Quantity quantity = named_quantity(name, unit);
    return axis_label(quantity, display_unit(quantity.unit, largest));
  };
  EXPECT_EQ(label("centroid_shift_m", "m", 2e-7), "Centroid shift (nm)");
  EXPECT_EQ(label("final_void_area_m2", "m2", 2e-12), "Final void area (µm²)");
  EXPECT_EQ(label("final_area_m2", "m^2", 2e-12), "Final cavity area A (µm²)");
  EXPECT_EQ(label("hot_spot_work_J_m3", "J/m3", 2e9), "Plastic work of the hot spot (GJ/m³)");
  EXPECT_EQ(label("shock_pressure_Pa", "Pa", 3e10), "Shock pressure (GPa)");
  EXPECT_EQ(label("jet_impact_time_s", "s", 2e-9), "Jet impact time (ns)");
  // Every unit that runner/catalog/README.md gives to a metric.
  for (const char* unit : {"1", "m", "m2", "s", "m/s", "Pa", "K", "J/m3", "kg/m"})
    EXPECT_TRUE(is_known_unit(unit)) << unit;
}

TEST(Units, LabelsHaveDigitsUntilTheyDiffer) {
  const Quantity speed = named_quantity("impact_speed"), time = named_quantity("time");
  using Labels = std::vector<std::string>;
  EXPECT_EQ(value_labels(speed, std::vector{1500.0, 1500.1, 1500.2}),
            (Labels{"u = 1.5 km/s", "u = 1.5001 km/s", "u = 1.5002 km/s"}));
  EXPECT_EQ(value_labels(time, std::vector{1e-9, 1.0001e-9, 1e-9}),
            (Labels{"t = 1 ns", "t = 1.0001 ns", "t = 1 ns"}));
  EXPECT_EQ(value_labels(speed, std::vector<double>{}), Labels{});
}

}  // namespace
