#pragma once
#include <algorithm>
#include <array>
#include <cmath>

#include "libmpm/material/strength/flow.hpp"
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
    struct Flow {
      const Constants<Real>& constants;
      double softened, inverse_dt, three_g;
      MPM_INLINE double hardened(double p) const { return constants.hardened(p); }
      MPM_INLINE double stress(double p, double dp) const {
        return hardened(p + dp) * constants.of_rate(dp * inverse_dt) * softened;
      }
    };
    const auto flow_in = [&](int lane) __attribute__((always_inline)) {
      return Flow{constants, constants.of_heat(Number<N>::lane(own[own_plastic_work], lane)), inverse_dt,
                  3 * static_cast<double>(constants.shear_modulus)};
    };
    take_back(trial, specific_volume, flow_in, s, own);
  }
};

inline constexpr MaterialUse strength_is_johnson_cook{"strength = \"johnson-cook\"", [](const Material& m) {
                                                        return m.law == MaterialLaw::solid &&
                                                               m.strength == StrengthModel::johnson_cook;
                                                      }};
inline constexpr MaterialUse strength_has_an_exponent{
    "strength = \"johnson-cook\" or \"steinberg-guinan\"", [](const Material& m) {
      return m.law == MaterialLaw::solid &&
             (m.strength == StrengthModel::johnson_cook || m.strength == StrengthModel::steinberg_guinan);
    }};
inline constexpr MaterialRow johnson_cook_rows[] = {
    {"strain_hardening", "Pa", "strain_hardening_Pa", "B of Johnson-Cook; A is yield_stress",
     Range::non_negative, &Material::strain_hardening, strength_is_johnson_cook, "", Section::material, 0.0},
    {"hardening_exponent", "1", "hardening_exponent", "n of Johnson-Cook and of Steinberg-Guinan",
     Range::non_negative, &Material::hardening_exponent, strength_has_an_exponent, "", Section::material,
     0.0},
    {"rate_hardening", "1", "rate_hardening", "C of Johnson-Cook; 0: no effect of the rate",
     Range::non_negative, &Material::rate_hardening, strength_is_johnson_cook, "", Section::material, 0.0},
    {"reference_strain_rate", "s-1", "reference_strain_rate_per_s", "rate above which rate_hardening acts",
     Range::non_negative, &Material::reference_strain_rate, strength_is_johnson_cook, "", Section::material,
     0.0},
    {"softening_exponent", "1", "softening_exponent", "m of Johnson-Cook; 0: no effect of the temperature",
     Range::non_negative, &Material::softening_exponent, strength_is_johnson_cook, "", Section::material,
     0.0},
    {"melting_temperature", "K", "melting_temperature_K",
     "temperature at which Johnson-Cook and, at the density of rest, Steinberg-Guinan have no strength",
     Range::non_negative, &Material::melting_temperature, strength_has_an_exponent, "", Section::material,
     0.0},
};

}  // namespace mpm
