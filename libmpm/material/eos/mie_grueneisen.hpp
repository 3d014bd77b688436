#pragma once
#include <algorithm>

#include "libmpm/material/material.hpp"

namespace mpm {

/// Mie-Grueneisen pressure on a linear Us-Up Hugoniot, cubic in mu = rho/rho0 - 1:
///   P = A(mu) (1 - gamma mu/2) + gamma0 rho0 e,   A = C mu + D mu^2 + S mu^3      [Pa]
///   C = rho0 c0^2, D = C (2 lambda - 1), S = C (lambda - 1)(3 lambda - 1), gamma rho = gamma0 rho0.
/// Since gamma mu = gamma0 eta with eta = 1 - rho0/rho = -(J - 1), and A is the pressure on the Hugoniot
/// exactly. Source: [Xu2007, eq. 13]. Valid up to Material::pressure_limit. Tension: see mpm::Tension.
/// Checked by tests/libmpm/material_test.cpp.
struct MieGrueneisen {
  double rho0;          ///< [kg/m^3]
  double inverse_rho0;  ///< [m^3/kg]
  double c, d, s;       ///< C, D, S [Pa]
  double gamma0;        ///< [1]
  Tension tension;
  double spall_strength;  ///< [Pa], positive
  double pressure_limit;  ///< upper end of its validity [Pa]
  /// Range of rho0/rho - 1: fourfold compression, tenfold expansion. Single particles pass the first where a
  /// cavity closes, and reach the second in what jets leave behind.
  static constexpr double least_dilation = -0.75, most_dilation = 9;
  /// Inside the range, its upper end not included: particles are held there (expanded()).
  static bool holds_at(double dilation) { return dilation >= least_dilation && dilation < most_dilation; }

  /// `dilation`, counted up to tenfold expansion; not a number stays so. The factor of A makes
  /// the cold tension grow with the volume without bound, and with it the sound speed: 0.22 TPa and 31 km/s
  /// at ten times the volume, 1.18 TPa and 146 km/s at 47 times, to which one torn-off particle would hold
  /// the time step of a whole run. What is held at the end of the range and goes on expanding at the rate
  /// theta loses its pressure and its tension, as debris does, dP/dt = -gamma0 P rho0/rho theta (but with
  /// Tension::linear, which has no energy term), and its energy is accounted for as everywhere. The expansion
  /// that was not counted is not taken back when it is pressed together again.
  static double expanded(double dilation) { return std::min(dilation, most_dilation); }

  explicit MieGrueneisen(const Material& m)
      : rho0(m.reference_density),
        inverse_rho0(1 / rho0),
        c(rho0 * m.bulk_sound_speed * m.bulk_sound_speed),
        d(c * (2 * m.hugoniot_slope - 1)),
        s(c * (m.hugoniot_slope - 1) * (3 * m.hugoniot_slope - 1)),
        gamma0(m.gruneisen_gamma),
        tension(m.tension),
        spall_strength(m.spall_strength),
        pressure_limit(m.pressure_limit) {}

  /// A state of volume: dilation J - 1 = rho0/rho - 1 and compression mu = rho/rho0 - 1.
  struct Volume {
    double dilation, mu;
    explicit Volume(double d) : dilation(d), mu(-d / (1 + d)) {}
  };

  /// P = cold + thermal * e: the two numbers.
  struct Line {
    double cold;     ///< [Pa]
    double thermal;  ///< [kg/m^3]
  };
  Line line(Volume v) const {
    if (tension == Tension::linear && v.mu < 0) return {c * v.mu, 0};
    return {v.mu * (c + v.mu * (d + v.mu * s)) * (1 + 0.5 * gamma0 * v.dilation), gamma0 * rho0};
  }

  /// What the material holds of a pressure P.
  double held(double p) const { return tension == Tension::cutoff ? std::max(p, -spall_strength) : p; }

  double pressure(Volume v, double energy) const {
    const Line l = line(v);
    return held(l.cold + l.thermal * energy);
  }

  /// Square of the bulk sound speed on an isentrope, dP/drho|e + (P/rho^2) dP/de [m^2/s^2]. Where far
  /// expansion makes it small, a tenth of c0^2 is returned: it bounds time steps and viscosity, nothing else.
  double sound_speed_squared(Volume v, double p) const {
    if (tension == Tension::linear && v.mu < 0) return c * inverse_rho0;
    const double a = v.mu * (c + v.mu * (d + v.mu * s));
    const double a_slope = c + v.mu * (2 * d + 3 * v.mu * s);
    const double square = (1 + v.dilation) * (1 + v.dilation);
    // dP/dmu at constant e, and gamma0 P rho0/rho^2
    const double slope = a_slope * (1 + 0.5 * gamma0 * v.dilation) - 0.5 * gamma0 * a * square;
    return std::max((slope + gamma0 * p * square) * inverse_rho0, 0.1 * c * inverse_rho0);
  }
};

}  // namespace mpm
