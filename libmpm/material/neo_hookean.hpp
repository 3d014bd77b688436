#pragma once
#include <array>
#include <cmath>
#include <limits>

#include "libmpm/core/state_column.hpp"
#include "libmpm/material/model.hpp"

namespace mpm {

/// b - 1, of b = F F^T: the left Cauchy-Green tensor without the 1, so that small strains keep their digits.
inline constexpr StateColumn left_cauchy_green_column{"left_cauchy_green_less_one", StateForm::symmetric};

/// A compressible neo-Hookean solid, elastic at any strain, with J = det F:
///   J sigma = lambda ln J 1 + mu (b - 1)      [Pa],   b <- (1 + dt L) b (1 + dt L)^T
///   rho0 c^2 = lambda (1 - ln J) + mu (1 + n.b n), at most with |b - 1| in place of n.b n - 1,
///     at least mu
/// lambda and mu are the Lame constants of E and nu. The energy that particles carry is that of the strain;
/// its heat is left out: the temperature stays that at rest. Source: Kamojjala, Brannon, Sadeghirad, Guilkey
/// 2015, Eng. Comput. 31, 193; c: the acoustic tensor, Bonet & Wood 2008, Nonlinear Continuum Mechanics for
/// Finite Element Analysis, sections 6.4.3 and 6.6. Checked by tests/libmpm/neo_hookean_test.cpp and the
/// problems of verification/.
template <class Real>
struct NeoHookean {
  Real rho0, inverse_rho0;
  Real lambda, mu;  ///< [Pa]
  Real pressure_limit;
  BasicArtificialViscosity<Real> viscosity;

  static constexpr std::array state{left_cauchy_green_column};
  static constexpr bool asks_for_displacement = true;

  explicit NeoHookean(const MaterialModel& m)
      : rho0(static_cast<Real>(m.material.reference_density)),
        inverse_rho0(static_cast<Real>(1 / m.material.reference_density)),
        lambda(static_cast<Real>(m.material.lame_lambda())),
        mu(static_cast<Real>(m.material.shear_modulus())),
        pressure_limit(static_cast<Real>(m.material.pressure_limit)),
        viscosity(BasicArtificialViscosity<Real>::from(m.viscosity)) {}
  static bool fits(const Material& m) { return m.law == MaterialLaw::neo_hookean; }
  static double sound_speed_at_rest(const Material& m) {
    return std::sqrt((m.lame_lambda() + 2 * m.shear_modulus()) / m.reference_density);
  }

  MPM_INLINE Validity<Real> validity() const {
    return {Real(least_dilation), Real(most_dilation), pressure_limit};
  }

  template <class N>
  MPM_INLINE N implicit(N, N) const {
    return N{};
  }

  template <class N, class Tensor, class Space, class Displacement>
  MPM_INLINE void shear(const Point<N, Tensor>& p, const Strain<N, Space, Displacement>& e, Real) const {
    typename Space::template Symmetric<N> b;
    load(p.own, b);
    b = carried(e.displacement, b);
    store(b, p.own);
    p.stress = scaled(mu / (1 + p.dilation), deviator(b));
  }

  template <class N, class Tensor, class Space, class Displacement>
  MPM_INLINE Signal<N> bulk(const Point<N, Tensor>& p, const Strain<N, Space, Displacement>& e,
                            Real inverse_dt) const {
    typename Space::template Symmetric<N> b;
    load(p.own, b);
    const N log = Number<N>::logarithm_of_one_plus(p.dilation);
    p.pressure = -(lambda * log + mu * Real(1.0 / 3.0) * trace(b)) / (1 + p.dilation);
    const N stiffness = lambda * (1 - log) + mu * (2 + Number<N>::square_root(norm_square(b)));
    const N square = inverse_rho0 * Number<N>::larger(stiffness, Number<N>::all(mu));
    const auto viscous = viscosity.response(N(rho0 * (1 + e.compression)), trace(e.rate), inverse_dt,
                                            Number<N>::square_root(square));
    p.viscous_pressure = viscous.pressure;
    return {viscous.speed, square};
  }
};

}  // namespace mpm
