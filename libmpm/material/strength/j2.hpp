#pragma once
#include <cmath>

#include "libmpm/material/material.hpp"
#include "libmpm/material/model.hpp"

namespace mpm {

/// Von Mises plasticity with linear isotropic and linear kinematic hardening; hypoelastic deviator, radial
/// return:
///   q = sqrt(3/2) ||s - alpha||,   yield at q = sigma_Y0 + (1 - beta) H p,   alpha' = (2/3) beta H e^p',
///   s_trial = R s R^T + 2 G dt dev(D),   dp = (q_trial - sigma_Y) / (3 G + H)
/// with p the equivalent plastic strain and beta the kinematic fraction. s, alpha in Pa, tension positive.
/// Source: Simo & Hughes 1998, Computational Inelasticity, box 3.1; [Xu2007, eqs. 6 to 8].
/// The return is exact for the step, whatever its size. Checked by tests/libmpm/material_test.cpp.
template <class Real>
struct BasicJ2 {
  Real shear_modulus;      ///< G [Pa]
  Real yield_stress;       ///< sigma_Y0 [Pa]; infinite: elastic
  Real isotropic_modulus;  ///< (1 - beta) H [Pa]
  Real kinematic_modulus;  ///< beta H [Pa]
  Real inverse_return;     ///< 1 / (3 G + H) [1/Pa]
  bool kinematic;          ///< beta > 0: there is a back stress

  explicit BasicJ2(const Material& m)
      : shear_modulus(m.shear_modulus()),
        yield_stress(m.yield_stress),
        isotropic_modulus((1 - m.kinematic_fraction) * m.hardening_per_equivalent_strain()),
        kinematic_modulus(m.kinematic_fraction * m.hardening_per_equivalent_strain()),
        inverse_return(1 / (3 * shear_modulus + isotropic_modulus + kinematic_modulus)),
        kinematic(m.hardens_kinematically()) {}
  /// The same constants, rounded.
  template <class Other>
  explicit BasicJ2(const BasicJ2<Other>& o)
      : shear_modulus(static_cast<Real>(o.shear_modulus)),
        yield_stress(static_cast<Real>(o.yield_stress)),
        isotropic_modulus(static_cast<Real>(o.isotropic_modulus)),
        kinematic_modulus(static_cast<Real>(o.kinematic_modulus)),
        inverse_return(static_cast<Real>(o.inverse_return)),
        kinematic(o.kinematic) {}

  /// q of a deviator [Pa].
  template <class Tensor>
  static double von_mises(const Tensor& deviator) {
    return std::sqrt(1.5 * contract(deviator, deviator));
  }
};
using J2 = BasicJ2<double>;

/// The columns of its own that a strength has, in this order.
enum OwnColumn : int { own_plastic_strain, own_plastic_work, own_back_stress };

/// No yield.
struct Elastic {
  static constexpr int own_columns = 0;
  static bool fits(const J2& j2) { return std::isinf(j2.yield_stress); }

  template <class Real, class N, class Tensor, class Space>
  static MPM_INLINE void update(const BasicJ2<Real>& j2, Tensor& s, N*, const Strain<N, Space>& e, N) {
    s = sum(rotated(e.rotation, s), 2 * j2.shear_modulus, deviator(e.rate));
  }
};

/// Isotropic hardening. Own columns: equivalent plastic strain [1], plastic work [J/kg].
struct IsotropicHardening {
  static constexpr int own_columns = 2;
  static bool fits(const J2& j2) { return !Elastic::fits(j2) && !j2.kinematic; }

  template <class Real, class N, class Tensor, class Space>
  static MPM_INLINE void update(const BasicJ2<Real>& j2, Tensor& s, N* own, const Strain<N, Space>& e,
                                N specific_volume) {
    const Real twice = 2 * j2.shear_modulus;
    const Tensor trial = sum(rotated(e.rotation, s), twice, deviator(e.rate));
    const N mises = Number<N>::square_root(3 * second_invariant(trial));
    const N excess =
        Number<N>::larger(mises - (j2.yield_stress + j2.isotropic_modulus * own[own_plastic_strain]), N{});
    const N dp = excess * j2.inverse_return;
    const N flow = mises > 0 ? Real(1.5) * dp / mises : N{};
    s = scaled(1 - twice * flow, trial);
    // mean stress of the return times the increment
    const N work = dp * (mises - (3 * j2.shear_modulus + Real(0.5) * j2.isotropic_modulus) * dp);
    own[own_plastic_strain] += dp;
    own[own_plastic_work] += work * specific_volume;
  }
};

/// ... and kinematic hardening. Own columns: those, and the back stress xx, yy, xy [Pa]; of three axes xz, yz
/// too, which own_columns does not count.
struct KinematicHardening {
  static constexpr int own_columns = 5;
  static bool fits(const J2& j2) { return !Elastic::fits(j2) && j2.kinematic; }

  template <class Real, class N, class Tensor, class Space>
  static MPM_INLINE void update(const BasicJ2<Real>& j2, Tensor& s, N* own, const Strain<N, Space>& e,
                                N specific_volume) {
    const Real twice = 2 * j2.shear_modulus;
    Tensor alpha;
    load(own + own_back_stress, alpha);
    alpha = rotated(e.rotation, alpha);
    const Tensor relative = sum(rotated(e.rotation, s), twice, deviator(e.rate)) - alpha;
    const N mises = Number<N>::square_root(3 * second_invariant(relative));
    const N excess =
        Number<N>::larger(mises - (j2.yield_stress + j2.isotropic_modulus * own[own_plastic_strain]), N{});
    const N dp = excess * j2.inverse_return;
    const N flow = mises > 0 ? Real(1.5) * dp / mises : N{};
    s = sum(alpha, 1 - twice * flow, relative);
    // mean stress of the return times the increment
    const N work =
        flow * contract(s, relative) - Real(0.5) * (j2.isotropic_modulus + j2.kinematic_modulus) * dp * dp;
    const N moved = j2.kinematic_modulus / Real(1.5) * flow;
    store(sum(alpha, moved, relative), own + own_back_stress);
    own[own_plastic_strain] += dp;
    own[own_plastic_work] += work * specific_volume;
  }
};

}  // namespace mpm
