#include "libmpm/verification/exact/elastic_plastic_impact.hpp"

#include <cmath>
#include <limits>
#include <stdexcept>

#include "csv.hpp"

namespace {

using namespace mpm::verification::exact;

ElasticPlasticSolid aluminium(double hardening) {
  return {{2700, 5350, 1.34, 1.96, 880, 300}, 69e9 / (2 * 1.33), 120e6, hardening};
}

double hardening_of(const std::string& reading) {
  if (reading == "H=0") return 0;
  if (reading == "H=Et") return 384e6;
  return std::sqrt(1.5) * 384e6;  // the paper's words: per unit of ||e^p||
}

void expect_row(const CsvRow& row) {
  const ElasticPlasticSolid solid = aluminium(hardening_of(row.at("hardening")));
  const double up = number(row, "u_m_s");
  const ImpactState state = elastic_plastic_impact(solid, up);
  constexpr double digits = 1e-6;
  expect_close(state.elastic_wave_speed, row, "D_elastic_Lagr_m_s", 1, digits);
  expect_close(state.elastic_limit_speed, row, "u_HEL_m_s", 1, digits);
  expect_close(state.elastic_limit_stress, row, "sigma_HEL_MPa", 1e6, digits);
  expect_close(state.plastic_wave_speed, row, "C_plastic_Lagr_m_s", 1, digits);
  expect_close(state.normal_stress, row, "sigma_xx_GPa", 1e9, digits);
  expect_close(state.pressure, row, "P_GPa", 1e9, digits);
  expect_close(state.von_mises, row, "vonMises_MPa", 1e6, digits);
  expect_close(state.equivalent_plastic_strain, row, "eps_p_eq", 1, digits);
  expect_close(state.density, row, "rho_kg_m3", 1, digits);
  expect_close(state.specific_energy, row, "e_kJ_kg", 1e3, digits);
  EXPECT_EQ(state.structure == WaveStructure::overdriven, row.at("overdriven") == "1");
  expect_close(state.front_speed_from_wall(solid), row, "x_plastic_front_wallframe_m_s", 1, digits);
  expect_close(10e-6 / state.plastic_wave_speed, row, "t_plastic_H10um_ns", 1e-9, digits);
  if (state.structure != WaveStructure::elastic)  // see tests/data/reference/README.md
    expect_close(state.precursor_speed_from_wall(solid), row, "x_elastic_front_wallframe_m_s", 1, digits);
  if (state.structure == WaveStructure::two_waves)
    expect_close(10e-6 / state.elastic_wave_speed, row, "t_elastic_H10um_ns", 1e-9, digits);

  const SimpleRelease release = simple_release(solid, state);
  expect_close(release.surface_speed, row, "u_fs_simple_release_m_s", 1, 1e-5);
  expect_close(release.density, row, "rho_released", 1, 1e-6);
  expect_close(release.equivalent_plastic_strain, row, "eps_p_after_release", 1, 1e-5);
}

TEST(ElasticPlasticImpact, AgreesWithEveryRowOfTheTable) {
  const auto rows = read_reference("ep_twowave.csv");
  ASSERT_EQ(rows.size(), 27u);
  for (const CsvRow& row : rows) {
    SCOPED_TRACE(row.at("hardening") + ", u = " + row.at("u_m_s") + " m/s");
    expect_row(row);
  }
}

TEST(ElasticPlasticImpact, EnergyBehindAnOverdrivenShockIsTheKineticEnergy) {
  const ImpactState state = elastic_plastic_impact(aluminium(0), 1120);
  EXPECT_EQ(state.structure, WaveStructure::overdriven);
  EXPECT_NEAR(state.specific_energy / (1120.0 * 1120 / 2), 1, 1e-11);
  EXPECT_NEAR(state.normal_stress / (2700 * state.plastic_wave_speed * 1120), 1, 1e-11);
}

TEST(ElasticPlasticImpact, BecomesTheFluidWithoutStrength) {
  ElasticPlasticSolid solid = aluminium(0);
  solid.yield_stress = 1;  // [Pa]: 1e-10 of the pressure
  const ImpactState state = elastic_plastic_impact(solid, 1500);
  const HugoniotState fluid = hugoniot(solid.fluid, 1500);
  EXPECT_NEAR(state.normal_stress / fluid.pressure, 1, 1e-9);
  EXPECT_NEAR(state.density / fluid.density, 1, 1e-9);
}

TEST(ElasticPlasticImpact, IsContinuousAtTheElasticLimit) {
  const ElasticPlasticSolid solid = aluminium(384e6);
  const double limit = elastic_plastic_impact(solid, 100).elastic_limit_speed;
  const ImpactState below = elastic_plastic_impact(solid, limit * (1 - 1e-9));
  const ImpactState above = elastic_plastic_impact(solid, limit * (1 + 1e-9));
  EXPECT_EQ(below.structure, WaveStructure::elastic);
  EXPECT_EQ(above.structure, WaveStructure::two_waves);
  EXPECT_NEAR(below.normal_stress / above.normal_stress, 1, 1e-7);
}

TEST(ElasticPlasticImpact, RefusesImpossibleInput) {
  EXPECT_THROW(elastic_plastic_impact(aluminium(0), 0), std::invalid_argument);
  EXPECT_THROW(elastic_plastic_impact(aluminium(-1), 100), std::invalid_argument);
  ElasticPlasticSolid solid = aluminium(0);
  solid.yield_stress = std::numeric_limits<double>::quiet_NaN();
  EXPECT_THROW(elastic_plastic_impact(solid, 100), std::invalid_argument);
}

}  // namespace
