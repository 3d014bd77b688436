#pragma once
/// Strong shocks of an ideal gas that is cold and at rest, or cold and flows inwards: in the cylinder (n = 2)
/// and in the sphere (n = 3).

namespace mpm::verification::exact {

struct IdealGas {
  double gamma;    ///< [1], > 1
  double density;  ///< rho0 of the cold gas [kg/m^3]
};

/// Gas that flows inwards with one speed u everywhere is stopped by a shock that runs outwards from the
/// centre:
///   D = (gamma - 1) / 2 u,   rho = rho0 ((gamma + 1) / (gamma - 1))^n,   P = (gamma - 1) rho u^2 / 2
/// behind it; before it rho = rho0 (1 + u t / r)^(n - 1), P = 0.
/// Source: Noh 1987, J. Comput. Phys. 72, 78.
struct NohShock {
  double shock_speed;  ///< D [m/s]
  double density;      ///< behind [kg/m^3]
  double pressure;     ///< behind [Pa]
};
NohShock noh_shock(const IdealGas&, int n, double inward_speed);

/// A point of a blast wave, in units of the shock: radius over that of the shock, velocity over the speed D
/// of the shock, density over rho0, pressure over rho0 D^2.
struct BlastPoint {
  double radius, velocity, density, pressure;
};

/// The energy E of an explosion at the centre, per length of the cylinder, drives a shock to
///   R(t) = (E t^2 / (alpha rho0))^(1 / (n + 2)),   D = 2 R / ((n + 2) t).
/// Source: Sedov 1959, Similarity and Dimensional Methods in Mechanics, ch. IV. Here the equations of the
/// self-similar flow are integrated from the shock inwards, and alpha from the energy that they hold.
class SedovBlast {
 public:
  SedovBlast(const IdealGas&, int n);

  double alpha() const { return alpha_; }                  ///< [1]; 0.851072 for the sphere of gamma = 1.4
  double shock_radius(double energy, double time) const;   ///< energy [J], of a cylinder [J/m]; time [s]
  double shock_speed(double energy, double time) const;    ///< [m/s]
  double peak_pressure(double energy, double time) const;  ///< behind the shock [Pa]

 private:
  IdealGas gas_;
  int n_;
  double alpha_ = 0;
};

}  // namespace mpm::verification::exact
