#pragma once

namespace mpm::verification::exact {

/// A compressible neo-Hookean solid in plane strain, J = det F, per initial volume:
///   W = lambda ln^2 J / 2 - mu ln J + mu (F : F - 2) / 2      [J/m^3]
///   J sigma = lambda ln J 1 + mu (F F^T - 1)                  [Pa]
/// Source: Kamojjala, Brannon, Sadeghirad, Guilkey 2015, Eng. Comput. 31, 193.
struct NeoHookean {
  double density;  ///< rho0 [kg/m^3], > 0
  double lambda;   ///< first Lame constant [Pa], >= 0
  double mu;       ///< shear modulus [Pa], > 0

  /// Of small strains. E [Pa], nu < 1/2 [1].
  static NeoHookean of(double density, double youngs_modulus, double poissons_ratio);

  double youngs_modulus() const;      ///< E of small strains [Pa]
  double longitudinal_speed() const;  ///< sqrt((lambda + 2 mu)/rho0) [m/s]
  /// W [J/m^3], of J > 0 and tr(F F^T - 1).
  double strain_energy(double jacobian, double trace) const;
  /// ... of F = (xx xy; yx yy).
  double strain_energy(double xx, double xy, double yx, double yy) const {
    return strain_energy(xx * yy - xy * yx, xx * xx + xy * xy + yx * yx + yy * yy - 2);
  }
};

}  // namespace mpm::verification::exact
