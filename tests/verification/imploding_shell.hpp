#pragma once
#include <gtest/gtest.h>

#include <cmath>
#include <string>

#include "libmpm/exact/lagrangian_1d.hpp"
#include "tests/libmpm/scenes.hpp"

/// The imploding shell against its two references: the incompressible rigid-plastic shell in closed form, and
/// the compressible elastic-plastic one in one dimension. The second lies up to 1 % of the radius and 2 % of
/// the time away from the first: elastic strain saves plastic work, and the shell rings as it stops.
namespace shell {

struct Case {
  double inner_speed;  ///< [m/s], a row of verney_cylinder_al.csv
  bool hardening;      ///< H = sqrt(3/2) 384 MPa, else none
};
inline constexpr Case cases[] = {{131.0531, false}, {185.0293, false}, {225.0374, false}, {255.9773, false},
                                 {131.0531, true},  {185.0293, true},  {225.0374, true},  {255.9773, true}};

inline std::string name_of(const Case& c) {
  return "u" + std::to_string(static_cast<int>(c.inner_speed)) + (c.hardening ? "hardening" : "ideal");
}

inline mpm::Scene scene(const Case& c, double cell_size) {
  mpm::Scene s = scenes::shell(c.inner_speed, cell_size);
  if (!c.hardening) s.material.hardening_modulus = 0;
  return s;
}

inline mpm::exact::ShellStop incompressible(const mpm::Scene& s) {
  return mpm::exact::verney_stop({s.inner_radius, s.outer_radius, s.material.reference_density,
                                  s.material.yield_stress, s.material.hardening_per_equivalent_strain()},
                                 s.inner_speed);
}

inline mpm::exact::ShellStop compressible(const mpm::Scene& s) {
  const mpm::Material& m = s.material;
  const mpm::exact::MieGruneisenFluid fluid{m.reference_density, m.bulk_sound_speed, m.hugoniot_slope,
                                            m.gruneisen_gamma,   m.specific_heat,    m.initial_temperature};
  return mpm::exact::compressible_shell_stop(
      {fluid, m.shear_modulus(), m.yield_stress, m.hardening_per_equivalent_strain()}, s.inner_radius,
      s.outer_radius, s.inner_speed, 120);
}

/// Relative errors of a run.
struct Errors {
  double radius, time;
};
inline Errors errors(const mpm::RunResult& r, const mpm::exact::ShellStop& exact) {
  return {scenes::metric(r, "stop_radius_m") / exact.radius - 1,
          scenes::metric(r, "stop_time_s") / exact.time - 1};
}

inline void expect_good_run(const mpm::RunResult& r) {
  ASSERT_EQ(r.status, mpm::RunStatus::done) << r.reason;
  EXPECT_EQ(r.outcome, "arrested");
  EXPECT_LT(r.energy_error, 1e-12);
  EXPECT_LT(scenes::metric(r, "momentum_error"), 1e-12);
}

}  // namespace shell
