#pragma once
#include <cmath>

#include "libmpm/material/model.hpp"
#include "libmpm/material/row.hpp"

namespace mpm {

/// Tait's equation as Cole writes it, for liquids: pressure by the density alone,
///   P = B ((rho/rho0)^n - 1)      [Pa]
///   c^2 = n (P + B) / rho
/// Source: R. H. Cole 1948, Underwater Explosions, Princeton, ch. 2. Beside the stiffened gas, which knows
/// heat: here viscosity and plastic work heat and do not push. Tension is cut off at minus the spall strength
/// with Tension::cutoff; otherwise it ends at -B, where the sound speed vanishes. Checked by
/// tests/libmpm/tait_test.cpp.
template <class Real>
struct TaitEos {
  Real rho0, inverse_rho0;
  double exponent;      ///< n [1]
  Real b;               ///< B [Pa]
  Real least_square;    ///< a lower bound of c^2 for the viscosity and the step [m^2/s^2]
  Real pressure_floor;  ///< [Pa]
  Real pressure_limit;  ///< [Pa]

  explicit TaitEos(const Material& m)
      : rho0(static_cast<Real>(m.reference_density)),
        inverse_rho0(static_cast<Real>(1 / m.reference_density)),
        exponent(m.tait_exponent),
        b(static_cast<Real>(m.tait_pressure)),
        least_square(static_cast<Real>(1e-3 * sound_square_at_rest(m))),
        pressure_floor(
            static_cast<Real>(m.tension == Tension::cutoff ? -m.spall_strength : -m.tait_pressure)),
        pressure_limit(static_cast<Real>(m.pressure_limit)) {}
  static bool fits(const Material& m) {
    return m.eos == EquationOfState::tait && m.tension != Tension::linear;
  }
  static double sound_square_at_rest(const Material& m) {
    return m.tait_exponent * m.tait_pressure / m.reference_density;
  }
  MPM_INLINE Validity<Real> validity() const {
    return {Real(least_dilation), Real(most_dilation), pressure_limit};
  }

  template <class N>
  MPM_INLINE LinearResponse<N> response(N dilation, N compression, N) const {
    N power{};  // (rho/rho0)^n - 1, which keeps the digits of small strains
    for (int lane = 0; lane < Number<N>::width; ++lane) {
      const double mu = Number<N>::lane(compression, lane);
      Number<N>::set_lane(power, lane, static_cast<Real>(__builtin_expm1(exponent * __builtin_log1p(mu))));
    }
    const N square = (Real(exponent) * b * inverse_rho0) * (1 + power) * (1 + dilation);
    return {{b * power, N{}}, Number<N>::larger(square, Number<N>::all(least_square))};
  }
  template <class N>
  MPM_INLINE N implicit(N, N) const {
    return N{};
  }
  template <class N>
  MPM_INLINE N held(N p) const {
    return Number<N>::larger(p, Number<N>::all(pressure_floor));
  }
};

/// What compression alone has put in, the integral of P / rho^2 over rho [J/kg]:
///   B / rho0 ((x^(n - 1) - 1) / (n - 1) + 1/x - 1),   x = rho/rho0
inline double tait_energy(const Material& m, double dilation) {
  const double less_one = m.tait_exponent - 1;
  return m.tait_pressure / m.reference_density *
         (std::expm1(-less_one * std::log1p(dilation)) / less_one + dilation);
}

/// Of mass and momentum across a shock, P = rho0 Us up, rho = rho0 Us / (Us - up), by bisection [m/s].
inline double tait_shock_speed(const Material& m, double particle_speed) {
  const double sound = std::sqrt(TaitEos<double>::sound_square_at_rest(m));
  double low = sound, high = sound + (m.tait_exponent + 1) * particle_speed;
  const auto excess = [&](double speed) {  // of the momentum over the pressure
    const double x = speed / (speed - particle_speed);
    return m.reference_density * speed * particle_speed -
           m.tait_pressure * (std::pow(x, m.tait_exponent) - 1);
  };
  for (;;) {
    const double middle = 0.5 * (low + high);
    if (!(middle > low && middle < high)) return high;
    (excess(middle) < 0 ? low : high) = middle;
  }
}

inline constexpr MaterialUse eos_is_tait{
    "eos = \"tait\"",
    [](const Material& m) { return m.law == MaterialLaw::solid && m.eos == EquationOfState::tait; }};
inline constexpr MaterialRow tait_rows[] = {
    {"tait_pressure", "Pa", "tait_pressure_Pa", "B of Tait", Range::non_negative, &Material::tait_pressure,
     eos_is_tait, "", Section::material, 0.0},
    {"tait_exponent", "1", "tait_exponent", "n of Tait", Range::non_negative, &Material::tait_exponent,
     eos_is_tait, "", Section::material, 0.0},
};

}  // namespace mpm
