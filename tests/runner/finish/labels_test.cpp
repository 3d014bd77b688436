// Labels of figures come from the tables of parameters, results and fields.
#include <gtest/gtest.h>

#include "libmpm/scene/physics_version.hpp"

#include "libmpm/io/fields.hpp"
#include "libmpm/measure/results.hpp"
#include "runner/finish/labels.hpp"

namespace mpmstudy {
namespace {

std::string label(const char* name, double largest, const char* unit = "1") {
  const analysis::QuantityLabel quantity = label_of(name, unit);
  return analysis::axis_label(quantity, analysis::display_unit(quantity.unit, largest));
}

TEST(Labels, AreThoseOfTheTables) {
  EXPECT_EQ(label("cavity_radius", 1e-6), "Cavity radius R (µm)");
  EXPECT_EQ(label("wall_thickness", 1e-6), "Downstream wall thickness d (µm)");
  EXPECT_EQ(label("particles_per_cell", 4), "Particles per cell");
  EXPECT_EQ(label("collapsibility", 1), "Collapsibility Φ");
  EXPECT_EQ(label("final_area_m2", 2e-12), "Final cavity area A (µm²)");
  EXPECT_EQ(label("hot_spot_work_J_m3", 2e9), "Plastic work of the hot spot (GJ/m³)");
  EXPECT_EQ(label("shock_pressure_Pa", 3e10), "Shock pressure P (GPa)");
  EXPECT_EQ(label("jet_impact_time_s", 2e-9), "Jet impact time t (ns)");
  EXPECT_EQ(label("stress_xy", 2e9), "Shear stress xy (GPa)");
  EXPECT_EQ(label("von_mises", 2e9), "Von Mises stress q (GPa)");
  EXPECT_EQ(label("time", 2e-9), "Time t (ns)");
  EXPECT_EQ(label("rear.max", 200, "m/s"), "rear.max (m/s)");
  EXPECT_EQ(label("rod_length_m", 0.1, "m"), "Rod length (mm)");
}

TEST(Labels, EveryUnitOfTheTablesHasScales) {
  for (const mpm::ResultRow& row : mpm::results())
    EXPECT_TRUE(analysis::is_known_unit(row.unit)) << row.name << " [" << row.unit << "]";
  for (const mpm::Field& field : mpm::fields())
    EXPECT_TRUE(analysis::is_known_unit(field.unit)) << field.name << " [" << field.unit << "]";
  using mpm::GaugeTarget;
  for (const auto target : {GaugeTarget::point, GaugeTarget::body, GaugeTarget::wall})
    for (const mpm::GaugeQuantity& one : mpm::gauge_quantities(target))
      for (const auto unit : {one.unit, one.axisymmetric, one.three_d})
        EXPECT_TRUE(analysis::is_known_unit(unit)) << one.name << " [" << unit << "]";
}

}  // namespace
TEST(PhysicsVersions, AreThoseOfTheJobsOfAStudy) {
  mpmstudy::Study study;
  study.scenes.resize(2);
  EXPECT_EQ(mpmstudy::physics_versions_of(study), std::set<int>{mpm::physics_version});
  study.scenes[1].numerics.kernel = mpm::Kernel::reference;
  EXPECT_EQ(mpmstudy::physics_versions_of(study),
            (std::set<int>{mpm::physics_version, mpm::physics_version_of(study.scenes[1])}));
  EXPECT_EQ(mpmstudy::physics_versions_text({5}), "physics version 5");
  EXPECT_EQ(mpmstudy::physics_versions_text({5, 6}), "physics versions 5 and 6");
}

}  // namespace mpmstudy
