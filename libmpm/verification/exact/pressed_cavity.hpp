#pragma once
/// A spherical cavity in an endless solid that is incompressible, elastic and perfectly plastic, and at rest:
/// at time 0 a pressure acts far away. Source of the equations: Carroll & Holt 1972, J. Appl. Phys. 43, 1626;
/// the pressure of an elastic-plastic medium: Hill 1950, The Mathematical Theory of Plasticity, ch. V.

namespace mpm::verification::exact {

struct PressedCavity {
  double radius;         ///< a0 [m]
  double density;        ///< rho [kg/m^3]
  double yield_stress;   ///< Y [Pa]
  double shear_modulus;  ///< G [Pa]
};

/// Far pressure [Pa] that holds the cavity at the radius a <= a0, with w = (a0^3 - a^3) / a^3:
///   4 G w / 3                        elastic, w <= Y / (2 G)
///   (2 Y / 3) (1 + ln(2 G w / Y))    plastic about the cavity
double holding_pressure(const PressedCavity&, double radius);

/// Far pressure above which the cavity closes: its work over the way to the centre is that of the holding
/// pressure, (2 Y / 3) (1 + ln(2 G / Y)), exact for a small Y / G.
double closing_pressure(const PressedCavity&);

struct CavityStop {
  bool closes;    ///< the radius falls below a thousandth of the first
  double radius;  ///< where it turns; the last one of a cavity that closes [m]
  double time;    ///< [s]
};
/// By rho (a a'' + 3/2 a'^2) = holding pressure - far pressure, from rest.
CavityStop pressed_cavity_stop(const PressedCavity&, double far_pressure);
/// When the radius falls to that value [s]; infinite where it does not.
double pressed_cavity_time(const PressedCavity&, double far_pressure, double radius);

}  // namespace mpm::verification::exact
