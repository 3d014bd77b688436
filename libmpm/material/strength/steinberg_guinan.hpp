#pragma once
#include <algorithm>
#include <array>
#include <cmath>

#include "libmpm/material/eos/temperature.hpp"
#include "libmpm/material/strength/flow.hpp"

namespace mpm {

/// Von Mises plasticity whose shear modulus and yield stress rise with pressure and fall with temperature,
/// and which does not know the rate:
///   G = G0 f,   sigma_Y = min(Y0 (1 + beta p)^n, Y_max) f,   f = 1 + A P / eta^(1/3) - B (T - 300 K),
/// eta = rho/rho0, p the equivalent plastic strain; f = 0 from the melting temperature on,
///   T_melt = T_melt0 exp(2 a (1 - 1/eta)) eta^(2 (gamma0 - a - 1/3)).
/// A is G'_P / G0, B is -G'_T / G0, and the yield stress has the same. P is the pressure of the step before,
/// T that of eos/temperature.hpp at the energy in the middle of the step. The deviator changes by 2 G of the
/// step. Source: Steinberg, Cochran, Guinan 1980, J. Appl. Phys. 51, 1498; the melting temperature: Steinberg
/// 1996, UCRL-MA-106439. Valid above rates of 1e5 1/s. Checked by tests/libmpm/steinberg_guinan_test.cpp.
template <class Real>
struct SteinbergGuinanConstants {
  Real shear_modulus;  ///< G0 [Pa]
  double g0, a, b, y0, beta, n, limit;
  double melting, melting_fall, gamma, inverse_heat;

  explicit SteinbergGuinanConstants(const Material& m)
      : shear_modulus(static_cast<Real>(m.shear_modulus())),
        g0(m.shear_modulus()),
        a(m.shear_per_pressure),
        b(m.shear_per_temperature),
        y0(m.yield_stress),
        beta(m.strain_factor),
        n(m.hardening_exponent),
        limit(m.yield_limit),
        melting(m.melting_temperature),
        melting_fall(m.melting_gamma_fall),
        gamma(m.gruneisen_gamma),
        inverse_heat(1 / m.specific_heat) {
    fit_cold_temperature(Temperature(m));
  }

  /// f, 0 or more.
  MPM_INLINE double stiffening(double dilation, double energy, double pressure) const {
    const double ratio = 1 + dilation;  // 1 / eta
    const double temperature = cold_temperature(dilation) + energy * inverse_heat;
    if (!(temperature < melting_at(ratio))) return 0;
    const double f = 1 + a * pressure * __builtin_cbrt(ratio) - b * (temperature - reference_temperature);
    return f > 0 ? f : 0;
  }
  MPM_INLINE double hardened(double p) const {
    const double y = y0 * __builtin_pow(1 + beta * p, n);
    return y < limit ? y : limit;
  }

  /// T at e = 0 [K]: a polynomial in 1 - rho0/rho of degree `degree`, in -0.3 ... 0.5 within 1e-5 of it;
  /// beyond the value at the end.
  MPM_INLINE double cold_temperature(double dilation) const {
    double x = (-dilation - middle) / half;
    x = x > 1 ? 1 : x < -1 ? -1 : x;
    double next = 0, sum = 0;  // Clenshaw
    for (int k = degree; k > 0; --k) {
      const double here = 2 * x * sum - next + cold[k];
      next = sum, sum = here;
    }
    return x * sum - next + cold[0];
  }

 private:
  static constexpr double reference_temperature = 300, middle = 0.1, half = 0.4;
  static constexpr int degree = 12;
  double cold[degree + 1];

  MPM_INLINE double melting_at(double ratio) const {
    if (ratio > 1) return melting;  // in tension
    return melting * __builtin_exp(2 * melting_fall * (1 - ratio)) *
           __builtin_pow(ratio, -2 * (gamma - melting_fall - 1.0 / 3));
  }

  void fit_cold_temperature(const Temperature& temperature) {
    constexpr int nodes = 4 * degree;
    constexpr double pi = 3.14159265358979323846;
    for (int k = 0; k <= degree; ++k) {
      double sum = 0;
      for (int j = 0; j < nodes; ++j) {
        const double angle = pi * (j + 0.5) / nodes;
        sum += temperature(-(middle + half * std::cos(angle)), 0) * std::cos(k * angle);
      }
      cold[k] = (k == 0 ? 1.0 : 2.0) * sum / nodes;
    }
  }
};

/// Own columns: equivalent plastic strain, plastic work.
struct SteinbergGuinan {
  template <class Real>
  using Constants = SteinbergGuinanConstants<Real>;
  static constexpr bool has_deviator = true;
  static constexpr bool fails = false;
  static constexpr bool asks_for_state = true;
  static constexpr std::array state{plastic_strain_column, plastic_work_column};
  static bool fits(const Material& m) { return m.strength == StrengthModel::steinberg_guinan && !m.fails(); }

  /// G of the state [Pa].
  template <class Real, class N>
  static MPM_INLINE N shear_modulus(const Constants<Real>& constants, const ThermalState<N>& at) {
    return modulus<Real, N>(constants, stiffening(constants, at));
  }

  template <class Real, class N, class Tensor, class Space>
  static MPM_INLINE void update(const Constants<Real>& constants, Tensor& s, N* own,
                                const Strain<N, Space>& e, N specific_volume, const ThermalState<N>& at) {
    const auto stiffness = stiffening(constants, at);
    const N g = modulus<Real, N>(constants, stiffness);
    const Tensor trial = sum(rotated(e.rotation, s), Real(1), scaled(N(2 * g), deviator(e.rate)));
    struct Flow {
      const Constants<Real>& constants;
      double f, three_g;
      MPM_INLINE double hardened(double p) const { return constants.hardened(p); }
      MPM_INLINE double stress(double p, double dp) const { return hardened(p + dp) * f; }
    };
    const auto flow_in = [&](int lane) __attribute__((always_inline)) {
      const double f = stiffness.of[lane];
      return Flow{constants, f, 3 * constants.g0 * f};
    };
    take_back(trial, specific_volume, flow_in, s, own);
  }

 private:
  /// f of every lane.
  template <class N>
  struct Stiffness {
    double of[Number<N>::width];
  };
  template <class Real, class N>
  static MPM_INLINE Stiffness<N> stiffening(const Constants<Real>& constants, const ThermalState<N>& at) {
    Stiffness<N> f;
    for (int lane = 0; lane < Number<N>::width; ++lane)
      f.of[lane] = constants.stiffening(Number<N>::lane(at.dilation, lane), Number<N>::lane(at.energy, lane),
                                        Number<N>::lane(at.pressure, lane));
    return f;
  }
  template <class Real, class N>
  static MPM_INLINE N modulus(const Constants<Real>& constants, const Stiffness<N>& f) {
    N g{};
    for (int lane = 0; lane < Number<N>::width; ++lane)
      Number<N>::set_lane(g, lane, static_cast<Real>(constants.g0 * f.of[lane]));
    return g;
  }
};

inline constexpr MaterialUse strength_is_steinberg_guinan{
    "strength = \"steinberg-guinan\"", [](const Material& m) {
      return m.law == MaterialLaw::solid && m.strength == StrengthModel::steinberg_guinan;
    }};
inline constexpr MaterialRow steinberg_guinan_rows[] = {
    {"strain_factor", "1", "strain_factor", "beta of Steinberg-Guinan", Range::non_negative,
     &Material::strain_factor, strength_is_steinberg_guinan, "", Section::material, 0.0},
    {"yield_limit", "Pa", "yield_limit_Pa", "Y_max of Steinberg-Guinan, to which strain hardens",
     Range::non_negative, &Material::yield_limit, strength_is_steinberg_guinan, "", Section::material, 0.0},
    {"shear_per_pressure", "Pa-1", "shear_per_pressure_per_Pa", "G'_P / G0 of Steinberg-Guinan",
     Range::non_negative, &Material::shear_per_pressure, strength_is_steinberg_guinan, "", Section::material,
     0.0},
    {"shear_per_temperature", "K-1", "shear_per_temperature_per_K", "-G'_T / G0 of Steinberg-Guinan",
     Range::non_negative, &Material::shear_per_temperature, strength_is_steinberg_guinan, "",
     Section::material, 0.0},
    {"melting_gamma_fall", "1", "melting_gamma_fall", "a of the melting temperature of Steinberg-Guinan",
     Range::non_negative, &Material::melting_gamma_fall, strength_is_steinberg_guinan, "", Section::material,
     0.0},
};

}  // namespace mpm
