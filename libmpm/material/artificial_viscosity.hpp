#pragma once
#include "libmpm/core/number.hpp"

namespace mpm {

/// Viscous pressure that spreads a shock over a few cells of size h and heats by its work:
///   q = rho h |theta| (q1 c + q2 h |theta|)   where theta = tr D < 0, else 0      [Pa]
/// Source: von Neumann & Richtmyer 1950, J. Appl. Phys. 21, 232 (quadratic); Landshoff 1955, LA-1930
/// (linear). Too small a q2 leaves the pressure right and the deviator wrong: see tests/verification/.
template <class Real>
struct BasicArtificialViscosity {
  Real linear;     ///< q1 [1]
  Real quadratic;  ///< q2 [1]
  Real length;     ///< h [m]

  /// The same coefficients, rounded.
  template <class Other>
  static BasicArtificialViscosity from(const BasicArtificialViscosity<Other>& o) {
    return {static_cast<Real>(o.linear), static_cast<Real>(o.quadratic), static_cast<Real>(o.length)};
  }

  template <class N>
  struct Response {
    N speed;     ///< that viscosity adds to the signal, q / (rho h |theta|) [m/s]; 0 in expansion
    N pressure;  ///< q [Pa]
  };
  /// `growth` = dt theta.
  template <class N>
  MPM_INLINE Response<N> response(N density, N growth, Real inverse_dt, N sound_speed) const {
    const N closing =
        Number<N>::smaller(growth * (inverse_dt * length), N{});  // h theta of compression [m/s]
    const N speed = closing < 0 ? linear * sound_speed - quadratic * closing : N{};
    return {speed, -(density * closing) * speed};
  }
};
using ArtificialViscosity = BasicArtificialViscosity<double>;

}  // namespace mpm
