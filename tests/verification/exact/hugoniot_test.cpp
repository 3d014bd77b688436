#include "libmpm/verification/exact/hugoniot.hpp"

#include <cmath>
#include <stdexcept>

#include "csv.hpp"

namespace {

using mpm::verification::exact::hugoniot;
using mpm::verification::exact::HugoniotState;

constexpr mpm::verification::exact::MieGruneisenFluid aluminium{2700, 5350, 1.34, 1.96, 880, 300};

TEST(Hugoniot, AgreesWithEveryRowOfTheTable) {
  const auto rows = read_reference("hugoniot.csv");
  ASSERT_EQ(rows.size(), 33u);
  for (const CsvRow& row : rows) {
    SCOPED_TRACE("up = " + row.at("up_m_s") + " m/s");
    const HugoniotState state = hugoniot(aluminium, number(row, "up_m_s"));
    expect_close(state.pressure, row, "P_poly_GPa", 1e9, 1e-5);
    expect_close(state.shock_speed, row, "Us_poly_m_s", 1, 1e-5);
    expect_close(state.density, row, "rho_poly_kg_m3", 1, 1e-5);
    expect_close(state.compression, row, "mu", 1, 1e-5);
    expect_close(state.specific_energy, row, "e_kJ_kg", 1e3, 1e-5);
    expect_close(state.temperature, row, "T_K_cv880", 1, 1e-5);
    const mpm::verification::exact::Release release = isentropic_release(aluminium, state);
    // The table's quadrature of the release ends within one step of P = 0: good to five parts in 1e5.
    expect_close(release.surface_speed, row, "u_fs_isentropic_m_s", 1, 5e-5);
    expect_close(release.density, row, "rho_released_kg_m3", 1, 2e-5);
    // What is left after a weak shock is a difference of nearly equal works: fewer digits of it are known.
    expect_close(release.specific_energy, row, "e_released_kJ_kg", 1e3,
                 number(row, "up_m_s") < 200 ? 2e-3 : 1e-4);
  }
}

TEST(Hugoniot, ObeysTheJumpConditionsInTheFullEquationOfState) {
  for (const double up : {1.0, 200.0, 1120.0, 3000.0}) {
    const HugoniotState s = hugoniot(aluminium, up);
    EXPECT_NEAR(s.pressure / (2700 * s.shock_speed * up), 1, 1e-13);
    EXPECT_NEAR(s.density * (s.shock_speed - up) / (2700 * s.shock_speed), 1, 1e-13);
    EXPECT_NEAR(s.specific_energy / (up * up / 2), 1, 1e-11);
    EXPECT_NEAR(aluminium.pressure(s.density, s.specific_energy) / s.pressure, 1, 1e-11);
  }
}

TEST(Hugoniot, SlopesAreDerivatives) {
  const double mu = 0.12, step = 1e-5;
  EXPECT_NEAR((aluminium.hugoniot_pressure(mu + step) - aluminium.hugoniot_pressure(mu - step)) / (2 * step) /
                  aluminium.hugoniot_pressure_slope(mu),
              1, 1e-8);
  const double v = 1 / 3000.0, h = v * 1e-5, e = 3e5;
  EXPECT_NEAR((aluminium.pressure(1 / (v + h), e) - aluminium.pressure(1 / (v - h), e)) / (2 * h) /
                  aluminium.pressure_slope(3000),
              1, 1e-8);
}

TEST(Hugoniot, WeakShocksRunAtTheSoundSpeed) {
  EXPECT_NEAR(hugoniot(aluminium, 1e-3).shock_speed / 5350, 1, 1e-6);
}

TEST(Hugoniot, RefusesWhatIsNotAShock) {
  EXPECT_THROW(hugoniot(aluminium, 0), std::invalid_argument);
  EXPECT_THROW(hugoniot(aluminium, -5), std::invalid_argument);
  EXPECT_THROW(hugoniot(aluminium, std::nan("")), std::invalid_argument);
}

}  // namespace
