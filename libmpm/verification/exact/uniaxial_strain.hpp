#pragma once
#include "libmpm/verification/exact/elastic_plastic_impact.hpp"

namespace mpm::verification::exact {

/// A material point on a path of uniaxial strain, loaded and unloaded at will: no shocks, no heat conduction.
///
/// eps = ln(rho/rho0), compression positive. q, the von Mises stress, here has the sign of the compression,
/// and with it the back stress a; beta is the share of the hardening that is kinematic:
///   elastic:  dq = 2 G d_eps                               while |q - a| < R = Y0 + (1 - beta) H p
///   plastic:  dp = 2 G |d_eps| / (3 G + H),  dq = +-H dp,  da = +-beta H dp
///   sigma = P(rho, e) + 2 q/3,   de = sigma d_eps / rho    (de = -sigma dV)
/// q is piecewise linear in eps and exact; the energy by Runge-Kutta of fourth order on each piece.
/// With beta = 0 and from rest: q = Y0 + H (2 G eps - Y0)/(3 G + H) beyond eps = Y0/2G, and on release
/// elastic until q = -q_max, then plastic in reverse.
class UniaxialStrain {
 public:
  /// At rest, without stress.
  explicit UniaxialStrain(const ElasticPlasticSolid&, double kinematic_fraction = 0);
  /// Behind a shock; hardening is isotropic.
  UniaxialStrain(const ElasticPlasticSolid&, const ImpactState&);

  void strain_to(double strain);

  double strain() const { return strain_; }                  ///< eps [1]
  double density() const;                                    ///< [kg/m^3]
  double von_mises() const { return q_; }                    ///< q, signed [Pa]
  double plastic_strain() const { return plastic_strain_; }  ///< p [1]
  double specific_energy() const { return energy_; }         ///< e [J/kg]
  double pressure() const;                                   ///< P [Pa]
  double normal_stress() const;                              ///< sigma, compression positive [Pa]
  double elastic_range() const { return 2 * radius(); }      ///< |dq| from yield to yield in reverse [Pa]
  /// Integral of sqrt(dsigma dV) over the path so far: what a simple wave along it adds to the speed [m/s].
  double wave_speed_change() const { return speed_; }

 private:
  double radius() const {
    return solid_.yield_stress + (1 - kinematic_) * solid_.hardening * plastic_strain_;
  }
  double normal_stress_at(double strain, double energy, double q) const;
  void move(double change, double slope);

  ElasticPlasticSolid solid_;
  double kinematic_;
  double strain_ = 0, q_ = 0, back_ = 0, plastic_strain_ = 0, energy_ = 0, speed_ = 0;
};

}  // namespace mpm::verification::exact
