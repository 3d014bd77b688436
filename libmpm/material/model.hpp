#pragma once
/// What a material model is: one plain struct whose text is compiled for a particle at a time (the plain
/// step) and for packs of particles (the fast step), over a number type N (core/number.hpp) and the tensors
/// of core/symmetric.hpp. Adding one: a file in this folder and a line in list.hpp; see README.md.
///
/// The step over time dt first describes the motion (strain_over(): density, strain, rotation), then asks for
/// the deviator, then for the pressure:
///   shear()  own numbers and deviator at the end of the step
///   bulk()   pressure and viscous pressure; speeds of signals
/// Two calls, because the pressure asks for the work of the deviator, and because a pack's chain of
/// operations is long: the fast step makes each call for several packs at once.
#include <concepts>
#include <cstddef>
#include <limits>
#include <span>
#include <type_traits>
#include <utility>
#include <vector>

#include "libmpm/core/state_column.hpp"
#include "libmpm/core/symmetric.hpp"
#include "libmpm/material/artificial_viscosity.hpp"
#include "libmpm/material/material.hpp"
#include "libmpm/space/space.hpp"

namespace mpm {

/// What the models are made from: the constants of a material, and the artificial viscosity of the scene.
struct MaterialModel {
  Material material;
  ArtificialViscosity viscosity;
};

/// Of the materials of a scene, in the order of BasicParticles::material_ends.
struct MaterialModels {
  std::vector<MaterialModel> of;
  MaterialModels(MaterialModel one) : of{std::move(one)} {}
  explicit MaterialModels(std::vector<MaterialModel> all) : of(std::move(all)) {}
};

/// Models that need all of dt L say so: `static constexpr bool asks_for_displacement = true`.
template <class Model>
concept AsksForDisplacement = Model::asks_for_displacement;

/// In place of dt L, for the other models.
struct NoDisplacement {};

/// The motion of a particle over a step, seen from its middle.
template <class N, class Space = space::PlaneStrain, class Displacement = NoDisplacement>
struct Strain {
  using Increment = typename Space::template Increment<N>;
  using Rotation = typename Space::template Rotation<N>;
  Increment rate;     ///< dt D
  Rotation rotation;  ///< of the spin, by the midpoint rule: Hughes & Winget 1980
  N compression;      ///< mu = rho / rho0 - 1 at the end of the step
  N divisor;          ///< 1 / (1 + implicit(J - 1, tr(dt D)))
  [[no_unique_address]] Displacement displacement{};  ///< dt L
};

/// What strain_over() makes for a model.
template <class N, class Space, class Model>
using StrainFor = Strain<
    N, Space,
    std::conditional_t<AsksForDisplacement<Model>, typename Space::template Displacement<N>, NoDisplacement>>;

/// What a model sees of a particle: references to its columns. Tensor: the deviator of the space.
template <class N, class Tensor = Deviator<N>>
struct Point {
  const N& dilation;    ///< J - 1 = rho0 / rho - 1 at the end of the step [1]
  const N& energy;      ///< specific internal energy in the middle of the step [J/kg]
  Tensor& stress;       ///< deviator of the stress, positive in tension [Pa]
  N& pressure;          ///< positive in compression [Pa]
  N& viscous_pressure;  ///< [Pa]
  N* own;               ///< the numbers of the model's own columns (StateColumn)
};

/// At a volume, P = cold + thermal e.
template <class N>
struct PressureLine {
  N cold;     ///< [Pa]
  N thermal;  ///< [kg/m^3]
};

/// What an equation of state gives at a volume.
template <class N>
struct LinearResponse {
  PressureLine<N> line;
  N sound_square;  ///< of the bulk sound on an isentrope, dP/drho|e + (P/rho^2) dP/de [m^2/s^2]
};

/// What a strength sees of pressure and heat, if it says asks_for_state.
template <class N>
struct ThermalState {
  N dilation, energy, pressure;  ///< as in Point
};
template <class Strength>
concept AsksForState = Strength::asks_for_state;

/// Speeds of signals in a particle.
template <class N>
struct Signal {
  N viscous;              ///< that viscosity adds [m/s]
  N longitudinal_square;  ///< square of the longitudinal sound speed [m^2/s^2]
};

/// Of J - 1, for all models: fourfold compression, tenfold expansion. Single particles pass the first where a
/// cavity closes, and reach the second in what jets leave behind.
inline constexpr double least_dilation = -0.75, most_dilation = 9;

/// Where a model holds. `most_dilation`: particles that expand further are kept there.
template <class Real>
struct Validity {
  Real least_dilation, most_dilation;  ///< of J - 1
  Real pressure_limit;                 ///< [Pa]
};

template <class M, class N, class S = space::PlaneStrain>
concept MaterialModelOver = requires(const M m, const Point<N, typename S::template Deviator<N>>& point,
                                     const StrainFor<N, S, M>& strain, N n, Scalar<N> dt,
                                     const Material& material) {
  { m.validity() } -> std::same_as<Validity<Scalar<N>>>;
  /// implicit(J - 1, theta), linear in theta: what the work over the step of the pressure at its end, P theta
  /// / (2 rho), takes from this very pressure, as a share of it. Zero for a pressure that does not depend on
  /// the energy.
  { m.implicit(n, n) } -> std::same_as<N>;
  { m.shear(point, strain, dt) } -> std::same_as<void>;  // dt: one over it
  { m.bulk(point, strain, dt) } -> std::same_as<Signal<N>>;
  /// The columns that it keeps of a particle.
  { M::state } -> std::convertible_to<std::span<const StateColumn>>;
  /// Whether it is the model of a material.
  { M::fits(material) } -> std::same_as<bool>;
  /// Longitudinal [m/s].
  { M::sound_speed_at_rest(material) } -> std::same_as<double>;
};

/// Density and motion from dt L = l:
///   J <- J det(1 + l), at most the model's tenfold;   D, W: parts of l (1 + l/2)^-1, the middle of the step.
/// One division for four: divisions are slow, and these numbers are all near 1.
/// `hoop`: dt L_zz, in a space that has it.
template <class N, class Space = space::PlaneStrain, class Model>
MPM_INLINE StrainFor<N, Space, Model> strain_over(N& dilation_column, const Gradient<N>& l,
                                                  const Model& model, [[maybe_unused]] N hoop = N{}) {
  using R = Scalar<N>;
  using F = Number<N>;
  // det(1 + l) - 1 without the 1, so that small dilations keep their digits
  N growth = (l.xx + l.yy) + (l.xx * l.yy - l.xy * l.yx);
  if constexpr (Space::has_hoop) growth += hoop * (1 + growth);
  // the second of smaller() wins where it is not a number
  const N dilation =
      F::smaller(F::all(model.validity().most_dilation), dilation_column + (1 + dilation_column) * growth);
  dilation_column = dilation;
  const N ratio = 1 + dilation;

  // l (1 + l/2)^-1 times the determinant
  const N a = 1 + R(0.5) * l.xx, b = R(0.5) * l.xy, c = R(0.5) * l.yx, d = 1 + R(0.5) * l.yy;
  const N det = a * d - b * c;
  const N xx_det = l.xx * d - l.xy * c, xy_det = l.xy * a - l.xx * b;
  const N yx_det = l.yx * d - l.yy * c, yy_det = l.yy * a - l.yx * b;
  // the rotation of the spin w: tan(w/2) = turn / det
  const N turn = R(0.25) * (yx_det - xy_det);
  const N det_square = det * det, turn_square = turn * turn, norm = det_square + turn_square;
  N theta_det = xx_det + yy_det;
  [[maybe_unused]] N zz{};
  if constexpr (Space::has_hoop) {
    zz = hoop / (1 + R(0.5) * hoop);
    theta_det += zz * det;
  }
  const N implicit = model.implicit(dilation, theta_det) + det;  // 1 / divisor, times det

  const N ratio_det = ratio * det, norm_implicit = norm * implicit;
  const N inverse_all = 1 / (ratio_det * norm_implicit);
  const N inverse_first = inverse_all * norm_implicit, inverse_second = inverse_all * ratio_det;
  const N inverse_det = inverse_first * ratio, inverse_norm = inverse_second * implicit;
  typename Strain<N, Space>::Increment rate{xx_det * inverse_det, yy_det * inverse_det,
                                            R(0.5) * (xy_det + yx_det) * inverse_det};
  if constexpr (Space::has_hoop) rate.zz = zz;
  StrainFor<N, Space, Model> strain{
      rate,
      {(det_square - turn_square) * inverse_norm, (turn + turn) * det * inverse_norm},
      -dilation * (inverse_first * det),
      det * (inverse_second * norm)};
  if constexpr (AsksForDisplacement<Model>) {
    if constexpr (Space::has_hoop)
      strain.displacement = {l, hoop};
    else
      strain.displacement = {l};
  }
  return strain;
}

/// The same of three axes.
template <class N, class Space, class Model>
MPM_INLINE StrainFor<N, Space, Model> strain_over(N& dilation_column, const FullGradient<N>& l,
                                                  const Model& model) {
  using F = Number<N>;
  // the second of smaller() wins where it is not a number
  const N dilation = F::smaller(F::all(model.validity().most_dilation),
                                dilation_column + (1 + dilation_column) * growth_of(l));
  dilation_column = dilation;
  const FullGradient<N> middle = midpoint(l);
  const auto rate = symmetric_part(middle);
  StrainFor<N, Space, Model> strain{rate, rotation_of_spin(middle), -dilation / (1 + dilation),
                                    1 / (1 + model.implicit(dilation, trace(rate)))};
  if constexpr (AsksForDisplacement<Model>) strain.displacement = {l};
  return strain;
}

}  // namespace mpm
