#pragma once
#include <cmath>

#include "libmpm/core/tensor.hpp"
#include "libmpm/material/material.hpp"

namespace mpm {

/// Von Mises plasticity with linear isotropic and linear kinematic hardening; hypoelastic deviator, radial
/// return:
///   q = sqrt(3/2) ||s - alpha||,   yield at q = sigma_Y0 + (1 - beta) H p,   alpha' = (2/3) beta H e^p',
///   s_trial = R s R^T + 2 G dt dev(D),   dp = (q_trial - sigma_Y) / (3 G + H)
/// with p the equivalent plastic strain and beta the kinematic fraction. s, alpha in Pa, tension positive.
/// Source: Simo & Hughes 1998, Computational Inelasticity, box 3.1; [Xu2007, eqs. 6 to 8].
/// The return is exact for the step, whatever its size. Checked by tests/libmpm/material_test.cpp.
struct J2 {
  double shear_modulus;      ///< G [Pa]
  double yield_stress;       ///< sigma_Y0 [Pa]; infinite: elastic
  double isotropic_modulus;  ///< (1 - beta) H [Pa]
  double kinematic_modulus;  ///< beta H [Pa]

  explicit J2(const Material& m)
      : shear_modulus(m.shear_modulus()),
        yield_stress(m.yield_stress),
        isotropic_modulus((1 - m.kinematic_fraction) * m.hardening_per_equivalent_strain()),
        kinematic_modulus(m.kinematic_fraction * m.hardening_per_equivalent_strain()) {}

  static double von_mises(const PlaneTensor& deviator) {
    return std::sqrt(1.5 * contract(deviator, deviator));
  }

  /// One step. `strain` is dt dev(D). Updates deviator, back stress (may be null) and plastic strain; returns
  /// the plastic work per current volume [J/m^3], >= 0.
  double update(const PlaneTensor& strain, const Rotation& rotation, PlaneTensor& deviator,
                PlaneTensor* back_stress, double& plastic_strain) const {
    PlaneTensor s = rotation(deviator) + 2 * shear_modulus * strain;
    const PlaneTensor alpha = back_stress ? rotation(*back_stress) : PlaneTensor{};
    const PlaneTensor relative = s - alpha;
    const double q = von_mises(relative);
    const double excess = q - (yield_stress + isotropic_modulus * plastic_strain);
    double work = 0;
    if (excess > 0) {
      const double dp = excess / (3 * shear_modulus + isotropic_modulus + kinematic_modulus);
      const PlaneTensor flow = (1.5 * dp / q) * relative;  // increment of plastic strain
      s = s - 2 * shear_modulus * flow;
      work = contract(s, flow) -
             0.5 * (isotropic_modulus + kinematic_modulus) * dp * dp;  // mean stress of the return
      plastic_strain += dp;
      if (back_stress) *back_stress = alpha + (kinematic_modulus / 1.5) * flow;
    } else if (back_stress) {
      *back_stress = alpha;
    }
    deviator = s;
    return work;
  }
};

}  // namespace mpm
