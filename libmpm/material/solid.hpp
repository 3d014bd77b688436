#pragma once
#include "libmpm/material/eos/mie_grueneisen.hpp"
#include "libmpm/material/strength/j2.hpp"

namespace mpm {

/// A solid whose pressure is linear in its energy, P = cold(J) + thermal e, and whose deviator is
/// hypoelastic. Particles carry e at half steps, as FLIP carries v: the work of the second half of the step,
///   dt (s : D - (P + q) tr D) / (2 rho),
/// takes it to the end, where the pressure is wanted. That is linear in P and solved for it.
/// Strength: Elastic, IsotropicHardening, KinematicHardening. `linear_tension`: Tension::linear.
template <class Real, class Strength, bool linear_tension>
struct Solid {
  BasicMieGrueneisen<Real> eos;
  BasicJ2<Real> strength;
  BasicArtificialViscosity<Real> viscosity;

  static constexpr auto& state = Strength::state;

  explicit Solid(const MaterialModel& m)
      : eos(MieGrueneisen(m.material)),
        strength(J2(m.material)),
        viscosity(BasicArtificialViscosity<Real>::from(m.viscosity)) {}
  static bool fits(const Material& m) {
    return m.law == MaterialLaw::solid && Strength::fits(m) &&
           linear_tension == (m.tension == Tension::linear);
  }
  static double sound_speed_at_rest(const Material& m) {
    const MieGrueneisen eos(m);
    return std::sqrt(eos.sound_speed_squared(MieGrueneisen::Volume(0), 0) +
                     4 * m.shear_modulus() / (3 * eos.rho0));
  }

  MPM_INLINE Validity<Real> validity() const {
    return {eos.least_dilation, eos.most_dilation, eos.pressure_limit};
  }

  template <class N>
  MPM_INLINE N implicit(N dilation, N theta) const {
    return eos.template implicit<linear_tension>(dilation, theta);
  }

  template <class N, class Tensor, class Space>
  MPM_INLINE void shear(const Point<N, Tensor>& p, const Strain<N, Space>& e) const {
    Strength::update(strength, p.stress, p.own, e, N(eos.inverse_rho0 * (1 + p.dilation)));
  }

  template <class N, class Tensor, class Space>
  MPM_INLINE Signal<N> bulk(const Point<N, Tensor>& p, const Strain<N, Space>& e, Real inverse_dt) const {
    const N specific_volume = eos.inverse_rho0 * (1 + p.dilation), growth = trace(e.rate);
    // the pressure of the last step is near enough for the sound speed of viscosity and time step
    const auto at = eos.template response<linear_tension, N>({p.dilation, e.compression}, p.pressure);
    const N density = eos.rho0 * (1 + e.compression);
    const auto viscous =
        viscosity.response(density, growth, inverse_dt, Number<N>::square_root(at.sound_square));
    const N work = contract(p.stress, e.rate) - viscous.pressure * growth;
    const N energy_end = p.energy + Real(0.5) * specific_volume * work;
    p.pressure = eos.held((at.line.cold + at.line.thermal * energy_end) * e.divisor);
    p.viscous_pressure = viscous.pressure;
    return {viscous.speed, at.sound_square + (Real(4.0 / 3.0) * strength.shear_modulus) * specific_volume};
  }
};

}  // namespace mpm
