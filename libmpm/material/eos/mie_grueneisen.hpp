#pragma once
#include <limits>

#include "libmpm/material/material.hpp"
#include "libmpm/material/model.hpp"
#include "libmpm/material/row.hpp"

namespace mpm {

/// Mie-Grueneisen pressure on a linear Us-Up Hugoniot, cubic in mu = rho/rho0 - 1:
///   P = A(mu) (1 - gamma mu/2) + gamma0 rho0 e,   A = C mu + D mu^2 + S mu^3      [Pa]
///   C = rho0 c0^2, D = C (2 lambda - 1), S = C (lambda - 1)(3 lambda - 1), gamma rho = gamma0 rho0.
/// Since gamma mu = gamma0 eta with eta = 1 - rho0/rho = -(J - 1), and A is the pressure on the Hugoniot
/// exactly. Source: [Xu2007, eq. 13]. Valid up to Material::pressure_limit. Tension: see mpm::Tension.
/// Checked by tests/libmpm/material_test.cpp.
template <class Real>
struct BasicMieGrueneisen {
  Real rho0;                ///< [kg/m^3]
  Real inverse_rho0;        ///< [m^3/kg]
  Real c, d, s;             ///< C, D, S [Pa]
  Real gamma0;              ///< [1]
  Real least_sound_square;  ///< a tenth of c0^2, a lower bound of sound_square [m^2/s^2]
  Real pressure_floor;      ///< minus the spall strength; minus infinity without [Pa]
  Real pressure_limit;      ///< upper end of its validity [Pa]
  Tension tension;
  /// Range of rho0/rho - 1.
  static constexpr Real least_dilation = Real(mpm::least_dilation), most_dilation = Real(mpm::most_dilation);
  /// Inside the range, its upper end not included: particles are held there. The factor of A makes
  /// the cold tension grow with the volume without bound, and with it the sound speed: 0.22 TPa and 31 km/s
  /// at ten times the volume, 1.18 TPa and 146 km/s at 47 times, to which one torn-off particle would hold
  /// the time step of a whole run. What is held at the end of the range and goes on expanding at the rate
  /// theta loses its pressure and its tension, as debris does, dP/dt = -gamma0 P rho0/rho theta (but with
  /// Tension::linear, which has no energy term), and its energy is accounted for as everywhere. The expansion
  /// that was not counted is not taken back when it is pressed together again.
  Validity<Real> validity() const { return {least_dilation, most_dilation, pressure_limit}; }

  explicit BasicMieGrueneisen(const Material& m)
      : rho0(m.reference_density),
        inverse_rho0(1 / rho0),
        c(rho0 * m.bulk_sound_speed * m.bulk_sound_speed),
        d(c * (2 * m.hugoniot_slope - 1)),
        s(c * (m.hugoniot_slope - 1) * (3 * m.hugoniot_slope - 1)),
        gamma0(m.gruneisen_gamma),
        least_sound_square(0.1 * c * inverse_rho0),
        pressure_floor(m.tension == Tension::cutoff ? -m.spall_strength
                                                    : -std::numeric_limits<Real>::infinity()),
        pressure_limit(m.pressure_limit),
        tension(m.tension) {}
  /// The same constants, rounded.
  template <class Other>
  explicit BasicMieGrueneisen(const BasicMieGrueneisen<Other>& o)
      : rho0(static_cast<Real>(o.rho0)),
        inverse_rho0(static_cast<Real>(o.inverse_rho0)),
        c(static_cast<Real>(o.c)),
        d(static_cast<Real>(o.d)),
        s(static_cast<Real>(o.s)),
        gamma0(static_cast<Real>(o.gamma0)),
        least_sound_square(static_cast<Real>(o.least_sound_square)),
        pressure_floor(static_cast<Real>(o.pressure_floor)),
        pressure_limit(static_cast<Real>(o.pressure_limit)),
        tension(o.tension) {}

  /// A state of volume: dilation J - 1 = rho0/rho - 1 and compression mu = rho/rho0 - 1.
  template <class N>
  struct VolumeOf {
    N dilation, mu;
  };
  struct Volume : VolumeOf<Real> {
    explicit Volume(Real d) : VolumeOf<Real>{d, -d / (1 + d)} {}
  };

  using Line = PressureLine<Real>;
  /// Where far expansion makes the square of the sound speed small, a tenth of c0^2 is returned: it bounds
  /// time steps and viscosity, nothing else. `linear`: Tension::linear. p: pressure, for the sound speed
  /// [Pa].
  template <bool linear, class N>
  MPM_INLINE LinearResponse<N> response(const VolumeOf<N>& v, N p) const {
    const N ratio = 1 + v.dilation, mu = v.mu;
    const N a = mu * (c + mu * (d + mu * s));
    const N a_slope = c + mu * (2 * d + 3 * mu * s);
    const N away = 1 + Real(0.5) * gamma0 * v.dilation, ratio_square = ratio * ratio;
    N square = (a_slope * away + gamma0 * ratio_square * (p - Real(0.5) * a)) * inverse_rho0;
    square = Number<N>::larger(square, Number<N>::all(least_sound_square));
    N cold = a * away, thermal = Number<N>::all(gamma0 * rho0);
    if constexpr (linear) {
      cold = mu < 0 ? c * mu : cold;
      thermal = mu < 0 ? N{} : thermal;
      square = mu < 0 ? Number<N>::all(c * inverse_rho0) : square;
    }
    return {{cold, thermal}, square};
  }
  /// See model.hpp: gamma0 rho0 / (2 rho) times rho0 / rho0.
  template <bool linear, class N>
  MPM_INLINE N implicit(N dilation, N theta) const {
    const N part = theta * (Real(0.5) * gamma0 * (1 + dilation));
    if constexpr (linear) return dilation > 0 ? N{} : part;
    return part;
  }
  /// Of a pressure, what the tension model lets stand.
  template <class N>
  MPM_INLINE N held(N p) const {
    return Number<N>::larger(p, Number<N>::all(pressure_floor));
  }

  // For one state at a time, with the tension of the material.
  Line line(Volume v) const { return response_of(v, 0).line; }
  double sound_speed_squared(Volume v, double p) const { return response_of(v, p).sound_square; }
  double pressure(Volume v, double energy) const {
    const Line l = line(v);
    return held(l.cold + l.thermal * energy);
  }

 private:
  LinearResponse<Real> response_of(Volume v, Real p) const {
    return tension == Tension::linear ? response<true, Real>(v, p) : response<false, Real>(v, p);
  }
};
using MieGrueneisen = BasicMieGrueneisen<double>;

/// The same as the equation of state of a model. `linear`: Tension::linear.
template <class Real, bool linear>
struct MieGrueneisenOf : BasicMieGrueneisen<Real> {
  using Base = BasicMieGrueneisen<Real>;

  explicit MieGrueneisenOf(const Material& m) : Base(MieGrueneisen(m)) {}
  static bool fits(const Material& m) {
    return m.eos == EquationOfState::mie_grueneisen && linear == (m.tension == Tension::linear);
  }
  static double sound_square_at_rest(const Material& m) {
    return MieGrueneisen(m).sound_speed_squared(MieGrueneisen::Volume(0), 0);
  }
  template <class N>
  MPM_INLINE auto response(N dilation, N compression, N p) const {
    return Base::template response<linear, N>({dilation, compression}, p);
  }
  template <class N>
  MPM_INLINE N implicit(N dilation, N theta) const {
    return Base::template implicit<linear>(dilation, theta);
  }
};
template <class Real>
using MieGrueneisenEos = MieGrueneisenOf<Real, false>;
template <class Real>
using MieGrueneisenWithLinearTension = MieGrueneisenOf<Real, true>;

inline constexpr MaterialUse eos_is_mie_grueneisen{"eos = \"mie-grueneisen\"", [](const Material& m) {
                                                     return m.law == MaterialLaw::solid &&
                                                            m.eos == EquationOfState::mie_grueneisen;
                                                   }};

inline constexpr MaterialRow mie_grueneisen_rows[] = {
    {"bulk_sound_speed", "m/s", "bulk_sound_speed_m_s", "c0 of Us = c0 + lambda Up", Range::positive,
     &Material::bulk_sound_speed, eos_is_mie_grueneisen},
    {"hugoniot_slope", "1", "hugoniot_slope", "lambda of Us = c0 + lambda Up", Range::non_negative,
     &Material::hugoniot_slope, eos_is_mie_grueneisen},
    {"gruneisen_gamma", "1", "gruneisen_gamma", "Grueneisen coefficient at rest", Range::non_negative,
     &Material::gruneisen_gamma, eos_is_mie_grueneisen},
    {"pressure_limit", "Pa", "pressure_limit_Pa", "pressure up to which the equation of state is valid",
     Range::positive, &Material::pressure_limit},
};

/// Of expanded material.
inline constexpr MaterialRow tension_rows[] = {
    {"spall_strength",
     "Pa",
     "spall_strength_Pa",
     "tension at which pressure is cut off (tension = \"cutoff\")",
     Range::non_negative,
     &Material::spall_strength,
     {"tension = \"cutoff\"",
      [](const Material& m) { return m.law == MaterialLaw::solid && m.tension == Tension::cutoff; }}},
};
inline constexpr auto tension_words = words<Tension>(
    {{Tension::polynomial, "polynomial"}, {Tension::linear, "linear"}, {Tension::cutoff, "cutoff"}});
inline constexpr MaterialChoice tension_choices[] = {
    {"tension", "pressure of expanded material", tension_words,
     [](const Material& m) { return static_cast<std::size_t>(m.tension); },
     [](Material& m, std::size_t i) { m.tension = static_cast<Tension>(i); }, law_is_solid},
};

}  // namespace mpm
