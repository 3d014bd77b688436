#pragma once
#include "libmpm/material/model.hpp"

namespace mpm {

/// A solid, or a fluid, whose pressure is linear in its energy, P = cold(J) + thermal(J) e, and whose
/// deviator is hypoelastic. Particles carry e at half steps, as FLIP carries v: the work of the second half
/// of the step,
///   dt (s : D - (P + q) tr D) / (2 rho),
/// takes it to the end, where the pressure is wanted. That is linear in P and solved for it.
/// Eos: MieGrueneisenEos, StiffenedGas, TaitEos. Strength: Elastic, IsotropicHardening, KinematicHardening,
/// JohnsonCook, SteinbergGuinan, Fluid, and Failing of those that flow.
template <class Real, template <class> class Eos, class Strength>
struct Solid {
  Eos<Real> eos;
  typename Strength::template Constants<Real> strength;
  BasicArtificialViscosity<Real> viscosity;

  static constexpr auto& state = Strength::state;

  explicit Solid(const MaterialModel& m)
      : eos(m.material), strength(m.material), viscosity(BasicArtificialViscosity<Real>::from(m.viscosity)) {}
  static bool fits(const Material& m) {
    return m.law == MaterialLaw::solid && Eos<Real>::fits(m) && Strength::fits(m);
  }
  static double sound_speed_at_rest(const Material& m) {
    const double stiffness = Strength::has_deviator ? m.shear_modulus() : 0;
    return std::sqrt(Eos<double>::sound_square_at_rest(m) + 4 * stiffness / (3 * m.reference_density));
  }

  MPM_INLINE Validity<Real> validity() const { return eos.validity(); }

  template <class N>
  MPM_INLINE N implicit(N dilation, N theta) const {
    return eos.implicit(dilation, theta);
  }

  template <class N, class Tensor, class Space>
  MPM_INLINE void shear(const Point<N, Tensor>& p, const Strain<N, Space>& e,
                        [[maybe_unused]] Real inverse_dt) const {
    const N volume = eos.inverse_rho0 * (1 + p.dilation);
    if constexpr (AsksForState<Strength>)
      Strength::update(strength, p.stress, p.own, e, volume,
                       ThermalState<N>{p.dilation, p.energy, p.pressure});
    else
      Strength::update(strength, p.stress, p.own, e, volume, inverse_dt);
  }

  template <class N, class Tensor, class Space>
  MPM_INLINE Signal<N> bulk(const Point<N, Tensor>& p, const Strain<N, Space>& e, Real inverse_dt) const {
    const N specific_volume = eos.inverse_rho0 * (1 + p.dilation), growth = trace(e.rate);
    // the pressure of the last step is near enough for the sound speed of viscosity and time step
    const auto at = eos.response(p.dilation, e.compression, p.pressure);
    const N density = eos.rho0 * (1 + e.compression);
    const auto viscous =
        viscosity.response(density, growth, inverse_dt, Number<N>::square_root(at.sound_square));
    const N work = contract(p.stress, e.rate) - viscous.pressure * growth;
    const N energy_end = p.energy + Real(0.5) * specific_volume * work;
    p.pressure = eos.held((at.line.cold + at.line.thermal * energy_end) * e.divisor);
    if constexpr (Strength::fails) p.pressure = strength.held(p.pressure, p.own);
    p.viscous_pressure = viscous.pressure;
    N longitudinal = at.sound_square;
    if constexpr (AsksForState<Strength>)
      longitudinal += Real(4.0 / 3.0) * specific_volume *
                      Strength::shear_modulus(strength, ThermalState<N>{p.dilation, p.energy, p.pressure});
    else if constexpr (Strength::has_deviator)
      longitudinal += (Real(4.0 / 3.0) * strength.shear_modulus) * specific_volume;
    return {viscous.speed, longitudinal};
  }
};

}  // namespace mpm
