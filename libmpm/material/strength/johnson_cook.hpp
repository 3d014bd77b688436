#pragma once
#include <algorithm>
#include <array>
#include <cmath>

#include "libmpm/material/strength/j2.hpp"

namespace mpm {

/// Von Mises plasticity whose yield stress depends on strain, rate and temperature:
///   sigma_Y = (A + B p^n) (1 + C ln max(p'/p0', 1)) (1 - T*^m),   T* = (T - T0) / (T_melt - T0), 0 ... 1
/// with p the equivalent plastic strain. T rises from T0 by the plastic work, all of it, with c_v; the heat
/// of compression is left out. Hardening and rate are those at the end of the step (implicit), the
/// temperature that at its start. Source: Johnson & Cook 1983, Proc. 7th Int. Symp. Ballistics, 541; return:
/// Simo & Hughes 1998, box 3.1. Checked by tests/libmpm/johnson_cook_test.cpp.
template <class Real>
struct JohnsonCookConstants {
  Real shear_modulus;  ///< G [Pa]
  double a, b, n, c, inverse_reference_rate, m;
  double inverse_heat;  ///< 1 / (c_v (T_melt - T0)) [kg/J]

  explicit JohnsonCookConstants(const Material& material)
      : shear_modulus(static_cast<Real>(material.shear_modulus())),
        a(material.yield_stress),
        b(material.strain_hardening),
        n(material.hardening_exponent),
        c(material.rate_hardening),
        inverse_reference_rate(c > 0 ? 1 / material.reference_strain_rate : 0),
        m(material.softening_exponent),
        inverse_heat(m > 0 ? 1 / (material.specific_heat *
                                  (material.melting_temperature - material.initial_temperature))
                           : 0) {}

  MPM_INLINE double hardened(double p) const { return a + (b > 0 ? b * __builtin_pow(p, n) : 0); }
  /// 1 + C ln max(p'/p0', 1)
  MPM_INLINE double of_rate(double rate) const {
    const double ratio = rate * inverse_reference_rate;
    return ratio > 1 ? 1 + c * __builtin_log(ratio) : 1;
  }
  /// 1 - T*^m
  MPM_INLINE double of_heat(double plastic_work) const {
    if (!(m > 0)) return 1;
    const double homologous = plastic_work * inverse_heat;
    return homologous >= 1 ? 0 : homologous > 0 ? 1 - __builtin_pow(homologous, m) : 1;
  }

  /// The increment of p that takes the trial stress q back to the yield surface: the root of
  ///   q - 3 G dp - sigma_Y(p + dp, dp / dt),
  /// which falls with dp, by Newton's method kept between two ends that hold it.
  MPM_INLINE double increment(double q, double p, double softened, double inverse_dt) const {
    const double three_g = 3 * static_cast<double>(shear_modulus);
    const auto excess = [&](double dp) __attribute__((always_inline)) {
      return q - three_g * dp - hardened(p + dp) * of_rate(dp * inverse_dt) * softened;
    };
    double low = 0, high = q / three_g;
    if (!(excess(0) > 0)) return 0;
    double dp = excess(0) / three_g;
    for (int k = 0; k < 60; ++k) {
      const double f = excess(dp);
      (f > 0 ? low : high) = dp;
      const double step = 1e-6 * high, slope = (excess(dp + step) - f) / step;
      double next = dp - f / slope;
      if (!(next > low && next < high)) next = 0.5 * (low + high);
      const bool done = !(__builtin_fabs(next - dp) > 1e-15 * high);
      dp = next;
      if (done) break;
    }
    return dp;
  }
};

/// Own columns: equivalent plastic strain, plastic work.
struct JohnsonCook {
  template <class Real>
  using Constants = JohnsonCookConstants<Real>;
  static constexpr bool has_deviator = true;
  static constexpr bool fails = false;
  static constexpr std::array state{plastic_strain_column, plastic_work_column};
  static bool is_of(const Material& m) { return m.strength == StrengthModel::johnson_cook; }
  static bool fits(const Material& m) { return is_of(m) && !m.fails(); }

  template <class Real, class N, class Tensor, class Space>
  static MPM_INLINE void update(const Constants<Real>& constants, Tensor& s, N* own,
                                const Strain<N, Space>& e, N specific_volume, Real inverse_dt) {
    const Tensor trial = sum(rotated(e.rotation, s), 2 * constants.shear_modulus, deviator(e.rate));
    const N mises = Number<N>::square_root(3 * second_invariant(trial));
    // one lane at a time: roots take each lane as many turns as it needs
    N increment{}, left = Number<N>::all(1), work{};
    for (int lane = 0; lane < Number<N>::width; ++lane) {
      const double q = Number<N>::lane(mises, lane), p = Number<N>::lane(own[own_plastic_strain], lane);
      const double softened = constants.of_heat(Number<N>::lane(own[own_plastic_work], lane));
      const double dp = constants.increment(q, p, softened, inverse_dt);
      if (!(dp > 0)) continue;
      const double end = q - 3 * static_cast<double>(constants.shear_modulus) * dp;
      // the stress of the step, its hardening counted to the middle
      const double before = constants.hardened(p), after = constants.hardened(p + dp);
      Number<N>::set_lane(increment, lane, static_cast<Real>(dp));
      Number<N>::set_lane(left, lane, static_cast<Real>(end / q));
      const double middle = 0.5 * (1 + (after > 0 ? before / after : 1)) * end;
      Number<N>::set_lane(work, lane, static_cast<Real>(dp * middle));
    }
    s = scaled(left, trial);
    own[own_plastic_strain] += increment;
    own[own_plastic_work] += work * specific_volume;
  }
};

inline constexpr MaterialUse strength_is_johnson_cook{"strength = \"johnson-cook\"", [](const Material& m) {
                                                        return m.law == MaterialLaw::solid &&
                                                               m.strength == StrengthModel::johnson_cook;
                                                      }};
inline constexpr MaterialRow johnson_cook_rows[] = {
    {"strain_hardening", "Pa", "strain_hardening_Pa", "B of Johnson-Cook; A is yield_stress",
     Range::non_negative, &Material::strain_hardening, strength_is_johnson_cook, "", Section::material, 0.0},
    {"hardening_exponent", "1", "hardening_exponent", "n of Johnson-Cook", Range::non_negative,
     &Material::hardening_exponent, strength_is_johnson_cook, "", Section::material, 0.0},
    {"rate_hardening", "1", "rate_hardening", "C of Johnson-Cook; 0: no effect of the rate",
     Range::non_negative, &Material::rate_hardening, strength_is_johnson_cook, "", Section::material, 0.0},
    {"reference_strain_rate", "s-1", "reference_strain_rate_per_s", "rate above which rate_hardening acts",
     Range::non_negative, &Material::reference_strain_rate, strength_is_johnson_cook, "", Section::material,
     0.0},
    {"softening_exponent", "1", "softening_exponent", "m of Johnson-Cook; 0: no effect of the temperature",
     Range::non_negative, &Material::softening_exponent, strength_is_johnson_cook, "", Section::material,
     0.0},
    {"melting_temperature", "K", "melting_temperature_K", "temperature at which Johnson-Cook has no strength",
     Range::non_negative, &Material::melting_temperature, strength_is_johnson_cook, "", Section::material,
     0.0},
};

}  // namespace mpm
