#pragma once
#include <array>
#include <cmath>
#include <concepts>

#include "libmpm/core/state_column.hpp"
#include "libmpm/material/material.hpp"
#include "libmpm/material/model.hpp"
#include "libmpm/material/row.hpp"

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

  explicit BasicJ2(const Material& m) requires std::same_as<Real, double>
      : shear_modulus(m.shear_modulus()),
        yield_stress(m.yield_stress),
        isotropic_modulus((1 - m.kinematic_fraction) * m.hardening_per_equivalent_strain()),
        kinematic_modulus(m.kinematic_fraction* m.hardening_per_equivalent_strain()),
        inverse_return(1 / (3 * shear_modulus + isotropic_modulus + kinematic_modulus)) {}
  /// The same constants, rounded.
  explicit BasicJ2(const Material& m) requires(!std::same_as<Real, double>) : BasicJ2(BasicJ2<double>(m)) {}
  template <class Other>
  explicit BasicJ2(const BasicJ2<Other>& o)
      : shear_modulus(static_cast<Real>(o.shear_modulus)),
        yield_stress(static_cast<Real>(o.yield_stress)),
        isotropic_modulus(static_cast<Real>(o.isotropic_modulus)),
        kinematic_modulus(static_cast<Real>(o.kinematic_modulus)),
        inverse_return(static_cast<Real>(o.inverse_return)) {}
};
using J2 = BasicJ2<double>;

/// What plastic materials keep: the equivalent plastic strain [1], the plastic work [J/kg], the back stress
/// [Pa].
inline constexpr StateColumn plastic_strain_column{"plastic_strain"};
inline constexpr StateColumn plastic_work_column{"plastic_work"};
inline constexpr StateColumn back_stress_column{"back_stress", StateForm::deviator};

/// Places of their numbers.
enum OwnNumber : int { own_plastic_strain, own_plastic_work, own_back_stress };

/// What strengths of von Mises share.
struct J2Strength {
  template <class Real>
  using Constants = BasicJ2<Real>;
  static constexpr bool has_deviator = true;
  static constexpr bool fails = false;
};

/// No yield.
struct Elastic : J2Strength {
  static constexpr std::array<StateColumn, 0> state{};
  static bool fits(const Material& m) {
    return m.strength == StrengthModel::von_mises && std::isinf(m.yield_stress);
  }

  template <class Real, class N, class Tensor, class Space>
  static MPM_INLINE void update(const BasicJ2<Real>& j2, Tensor& s, N*, const Strain<N, Space>& e, N, Real) {
    s = sum(rotated(e.rotation, s), 2 * j2.shear_modulus, deviator(e.rate));
  }
};

/// Isotropic hardening.
struct IsotropicHardening : J2Strength {
  static constexpr std::array state{plastic_strain_column, plastic_work_column};
  /// With or without failure (failing.hpp).
  static bool is_of(const Material& m) {
    return m.strength == StrengthModel::von_mises && std::isfinite(m.yield_stress) &&
           !m.hardens_kinematically();
  }
  static bool fits(const Material& m) { return is_of(m) && !m.fails(); }

  template <class Real, class N, class Tensor, class Space>
  static MPM_INLINE void update(const BasicJ2<Real>& j2, Tensor& s, N* own, const Strain<N, Space>& e,
                                N specific_volume, Real) {
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

/// ... and kinematic hardening.
struct KinematicHardening : J2Strength {
  static constexpr std::array state{plastic_strain_column, plastic_work_column, back_stress_column};
  static bool is_of(const Material& m) { return m.hardens_kinematically(); }
  static bool fits(const Material& m) { return is_of(m) && !m.fails(); }

  template <class Real, class N, class Tensor, class Space>
  static MPM_INLINE void update(const BasicJ2<Real>& j2, Tensor& s, N* own, const Strain<N, Space>& e,
                                N specific_volume, Real) {
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

inline constexpr MaterialUse where_strong{
    "law = \"solid\" and a strength",
    [](const Material& m) { return m.law == MaterialLaw::solid && m.strength != StrengthModel::none; }};
inline constexpr MaterialUse where_elastic{
    "a strength",
    [](const Material& m) { return m.law == MaterialLaw::neo_hookean || m.strength != StrengthModel::none; }};
inline constexpr MaterialUse where_plastic{"a finite yield_stress", [](const Material& m) {
                                             return m.law == MaterialLaw::solid &&
                                                    m.strength == StrengthModel::von_mises &&
                                                    std::isfinite(m.yield_stress);
                                           }};
inline constexpr MaterialUse where_hardening{
    "hardening_modulus above 0 and a finite yield_stress",
    [](const Material& m) { return where_plastic.holds(m) && m.hardening_modulus > 0; }};

inline constexpr MaterialRow j2_rows[] = {
    {"yield_stress", "Pa", "yield_stress_Pa", "initial yield stress; infinite: elastic",
     Range::non_negative_or_infinite, &Material::yield_stress, where_strong, "Y", Section::parameters},
    {"youngs_modulus", "Pa", "youngs_modulus_Pa", "Young's modulus of the deviator", Range::positive,
     &Material::youngs_modulus, where_elastic},
    {"poissons_ratio", "1", "poissons_ratio", "Poisson's ratio of the deviator", Range::non_negative,
     &Material::poissons_ratio, where_elastic},
    {"hardening_modulus", "Pa", "hardening_modulus_Pa",
     "hardening modulus, in the measure of hardening_measure", Range::non_negative,
     &Material::hardening_modulus, where_plastic, "E"},
    {"kinematic_fraction", "1", "kinematic_fraction", "share of the hardening that is kinematic",
     Range::non_negative, &Material::kinematic_fraction, where_hardening},
};
inline constexpr auto hardening_words = words<HardeningMeasure>({{HardeningMeasure::norm, "norm"},
                                                                 {HardeningMeasure::equivalent, "equivalent"},
                                                                 {HardeningMeasure::tangent, "tangent"}});
inline constexpr MaterialChoice j2_choices[] = {
    {"hardening_measure", "measure of strain of hardening_modulus", hardening_words,
     [](const Material& m) { return static_cast<std::size_t>(m.hardening_measure); },
     [](Material& m, std::size_t i) { m.hardening_measure = static_cast<HardeningMeasure>(i); },
     where_hardening},
};

}  // namespace mpm
