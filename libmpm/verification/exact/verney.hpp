#pragma once

namespace mpm::verification::exact {

/// An incompressible shell that implodes: a cylinder in plane strain with v(r) = -u0 a0 / r, or a sphere with
/// v(r) = -u0 (a0 / r)^2.
/// Rigid-plastic: Y = Y0 + H eps, eps the equivalent plastic strain (elastic strains are left out).
struct ImplodingShell {
  double inner_radius;  ///< a0 [m], > 0
  double outer_radius;  ///< b0 [m], > a0
  double density;       ///< rho [kg/m^3], > 0
  double yield_stress;  ///< Y0 [Pa], >= 0
  double hardening;     ///< H [Pa], >= 0
  bool spherical = false;
};

/// b of the shell when its inner radius is a: b^n = b0^n - a0^n + a^n, n = 2 or 3 [m].
double outer_radius(const ImplodingShell&, double inner_radius);

/// u0 [m/s] that stops the shell at inner radius a, 0 <= a <= a0, without hardening: kinetic energy = plastic
/// work,
///   u0^2 = (Y/sqrt3) F / (rho a0^2 ln(b0/a0)),  F = b0^2 ln b0^2 - b^2 ln b^2 - a0^2 ln a0^2 + a^2 ln a^2;
/// of a sphere, with q = b0/a0,
///   u0^2 = (4/3) Y q F / (rho (q - 1)),   F = integral x^2 ln(1 + (q^3 - 1) / x^3) dx from a/a0 to 1.
/// The problem is known by Verney's name; its usual beryllium shell (1845 kg/m^3, 330 MPa, 80/100 mm, stops
/// at 50/78.1 mm; the literature quotes 417.1 m/s) is a test. Throws std::invalid_argument for a shell or
/// radius out of range, or H != 0.
double verney_speed(const ImplodingShell&, double stop_radius);

/// The inverse: stop radius [m] without hardening; 0 where the shell closes.
double verney_stop_radius(const ImplodingShell&, double inner_speed);

struct ShellStop {
  bool closes;    ///< the inner radius falls below a0 / 1000 before the shell stops
  double radius;  ///< where it stops [m]
  double time;    ///< when [s]
};

/// Stop radius and time with hardening, by the equation of motion of A = a da/dt:
///   rho [ dA/dt ln(b/a) - (A^2/2)(1/a^2 - 1/b^2) ] = (2/sqrt3) integral_a^b Y(eps)/r dr,
///   eps(r) = ln(1 + (a0^2 - a^2)/r^2) / sqrt3;
/// of a sphere, with A = a^2 da/dt,
///   rho [ dA/dt (1/a - 1/b) - (A^2/2)(1/a^4 - 1/b^4) ] = 2 integral_a^b Y(eps)/r dr,
///   eps(r) = (2/3) ln(1 + (a0^3 - a^3)/r^3).
/// Throws std::invalid_argument as above, or where u0 is not positive.
ShellStop verney_stop(const ImplodingShell&, double inner_speed);

/// Pressure [Pa] that holds a cylindrical pore of area fraction phi (0 < phi < 1) at yield all through its
/// cell, rigid-plastic: (Y/sqrt3) ln(1/phi).
double pore_collapse_pressure(double yield_stress, double area_fraction);

/// The same for a pore alone in an elastic-plastic medium: (Y/sqrt3) (1 + ln(sqrt3 G / Y)). The elastic field
/// bounds the plastic zone. First yield at its wall: Y/sqrt3.
double lone_pore_collapse_pressure(double yield_stress, double shear_modulus);
double pore_first_yield_pressure(double yield_stress);

}  // namespace mpm::verification::exact
