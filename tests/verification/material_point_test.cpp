// The material alone, by the library's equation of state and stress update, against exact solutions and the
// reference tables.
#include <gtest/gtest.h>

#include "libmpm/verification/problems/material_point.hpp"
#include "libmpm/verification/problems/problems.hpp"
#include "tests/verification/exact/csv.hpp"
#include "tests/verification/expect_numbers.hpp"

namespace {

const mpm::Material aluminium = mpm::named_material("aluminium");

TEST(MaterialPoint, HoldsTheLadder) {
  expect_all_hold(mpm::verification::hugoniot_numbers({}));
  expect_all_hold(mpm::verification::uniaxial_path_numbers({}));
  expect_all_hold(mpm::verification::release_numbers({}));
  expect_all_hold(mpm::verification::bauschinger_numbers({}));
}

TEST(MaterialPoint, StandsOnEveryRowOfTheHugoniot) {
  const auto rows = read_reference("hugoniot.csv");
  ASSERT_EQ(rows.size(), 33u);
  for (const CsvRow& row : rows) {
    SCOPED_TRACE("up = " + row.at("up_m_s") + " m/s");
    const mpm::verification::MaterialHugoniot ours =
        mpm::verification::material_hugoniot(aluminium, number(row, "up_m_s"));
    expect_close(ours.pressure, row, "P_poly_GPa", 1e9, 1e-5);
    expect_close(ours.shock_speed, row, "Us_poly_m_s", 1, 1e-5);
    expect_close(ours.density, row, "rho_poly_kg_m3", 1, 1e-5);
    expect_close(ours.temperature, row, "T_K_cv880", 1, 1e-5);
  }
}

// Behind a weak shock, which hardly heats, the path of the uniaxial strain ends in the row's state.
TEST(MaterialPoint, ReachesTheStateOfAWeakImpact) {
  for (const CsvRow& row : read_reference("ep_twowave.csv")) {
    if (row.at("hardening") != "Hlit=sqrt(3/2)Et" || number(row, "u_m_s") > 50) continue;
    SCOPED_TRACE("u = " + row.at("u_m_s") + " m/s");
    mpm::verification::MaterialPoint point(aluminium);
    point.strain_to(std::log(number(row, "rho_kg_m3") / aluminium.reference_density), 1000);
    expect_close(point.von_mises(), row, "vonMises_MPa", 1e6, 3e-4);  // of the digits of the density
    expect_close(point.normal_stress(), row, "sigma_xx_GPa", 1e9, 3e-4);
  }
}

}  // namespace
