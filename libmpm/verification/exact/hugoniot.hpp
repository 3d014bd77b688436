#pragma once

namespace mpm::verification::exact {

/// A fluid with the polynomial Mie-Grueneisen pressure [Xu2007, eq. 13]. mu = rho/rho0 - 1, eta = 1 -
/// rho0/rho:
///
///   P_H(mu) = C mu + D mu^2 + S mu^3                                                    [Pa]
///   P(mu, e) = P_H (1 - gamma0 eta / 2) + gamma0 rho0 e,  with gamma rho = gamma0 rho0  [Pa]
///   C = rho0 c0^2,  D = C (2 lambda - 1),  S = C (lambda - 1)(3 lambda - 1)
///
/// P is positive in compression. Expansion (mu < 0) goes on with the same polynomial. Valid for gamma0 eta
/// < 2.
struct MieGruneisenFluid {
  double density;        ///< rho0 [kg/m^3], > 0
  double sound_speed;    ///< c0 [m/s], > 0
  double slope;          ///< lambda of Us = c0 + lambda up [1], >= 1: P_H rises with mu
  double gamma;          ///< gamma0 [1]
  double specific_heat;  ///< c_v [J/kg/K], > 0; for the temperature only
  double temperature;    ///< T0 [K]

  double hugoniot_pressure(double mu) const;        ///< P_H [Pa]
  double hugoniot_pressure_slope(double mu) const;  ///< dP_H/dmu [Pa]
  /// [Pa]; density [kg/m^3], specific internal energy [J/kg], zero in the reference state.
  double pressure(double density_now, double energy) const;
  /// dP/dV at constant energy [Pa kg/m^3], V = 1/rho.
  double pressure_slope(double density_now) const;
};

/// The state behind one steady shock that runs into the fluid at rest.
struct HugoniotState {
  double particle_speed;   ///< up [m/s]
  double shock_speed;      ///< Us, against the material ahead [m/s]
  double pressure;         ///< [Pa]
  double density;          ///< [kg/m^3]
  double compression;      ///< mu [1]
  double specific_energy;  ///< e = up^2 / 2 [J/kg]
  double temperature;      ///< [K]
};

/// The Hugoniot at particle speed up > 0 [m/s].
///
/// The jump conditions P = rho0 Us up, rho0 Us = rho (Us - up), e = P eta / (2 rho0) put into P(mu, e) give
/// P (1 - gamma0 eta/2) = P_H (1 - gamma0 eta/2): P = P_H(mu) exactly, for any gamma0. So mu solves
/// P_H(mu) eta = rho0 up^2. Temperature, with x = V0 - V [Walsh & Christian 1955]:
///   c_v dT/dx = (x dP/dx - P)/2 + gamma0 rho0 c_v T.
/// Throws std::invalid_argument where up is not positive, or out of the range in which gamma0 eta < 2.
HugoniotState hugoniot(const MieGruneisenFluid&, double particle_speed);

/// What a shocked element becomes when a free surface releases it to P = 0 along its isentrope.
struct Release {
  double surface_speed;    ///< up + integral of sqrt(-dP dV) [m/s]
  double density;          ///< [kg/m^3]
  double specific_energy;  ///< [J/kg]
};

/// de = -P dV, du = sqrt(-dP dV), from the shocked state to zero pressure.
Release isentropic_release(const MieGruneisenFluid&, const HugoniotState&);

}  // namespace mpm::verification::exact
