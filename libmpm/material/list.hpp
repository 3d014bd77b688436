#pragma once
/// The material models that are compiled, for the plain and the fast step, each number and each instruction
/// set. Of a combination of strength and equation of state that has no line, find_problems() says so.
#include <algorithm>
#include <cstddef>
#include <stdexcept>

#include "libmpm/material/eos/mie_grueneisen.hpp"
#include "libmpm/material/eos/stiffened_gas.hpp"
#include "libmpm/material/eos/tait.hpp"
#include "libmpm/material/neo_hookean.hpp"
#include "libmpm/material/solid.hpp"
#include "libmpm/material/strength/failing.hpp"
#include "libmpm/material/strength/fluid.hpp"
#include "libmpm/material/strength/j2.hpp"
#include "libmpm/material/strength/johnson_cook.hpp"
#include "libmpm/material/strength/steinberg_guinan.hpp"

namespace mpm {

template <class... Models>
struct ModelList {
  static constexpr std::size_t size = sizeof...(Models);
};

template <class Real>
using CompiledModels =
    ModelList<Solid<Real, MieGrueneisenEos, Failing<IsotropicHardening>>,
              Solid<Real, MieGrueneisenEos, Failing<KinematicHardening>>,
              Solid<Real, MieGrueneisenEos, Failing<JohnsonCook>>,  //
              Solid<Real, MieGrueneisenEos, Elastic>, Solid<Real, MieGrueneisenEos, IsotropicHardening>,
              Solid<Real, MieGrueneisenEos, KinematicHardening>, Solid<Real, MieGrueneisenEos, JohnsonCook>,
              Solid<Real, MieGrueneisenEos, Fluid>,  //
              Solid<Real, MieGrueneisenWithLinearTension, Elastic>,
              Solid<Real, MieGrueneisenWithLinearTension, IsotropicHardening>,
              Solid<Real, MieGrueneisenWithLinearTension, KinematicHardening>,  //
              Solid<Real, MieGrueneisenEos, SteinbergGuinan>,                   //
              Solid<Real, TaitEos, Fluid>,                                      //
              Solid<Real, StiffenedGas, Fluid>,                                 //
              NeoHookean<Real>>;

namespace detail {
template <class Use, class... Models>
void with_first(const Material& m, Use& use, ModelList<Models...>) {
  std::size_t index = 0;
  const auto tried = [&]<class Model>() {
    if (!Model::fits(m)) return ++index, false;
    use.template operator()<Model>(index);
    return true;
  };
  if (!(tried.template operator()<Models>() || ...))
    throw std::logic_error("a material model that is not compiled");
}
}  // namespace detail

/// Calls use.operator()<Model>(place in the list) with the first model that fits.
template <class Real, class Use>
void with_model_type(const Material& m, Use use) {
  detail::with_first(m, use, CompiledModels<Real>{});
}

/// Calls use(model, place in the list) with it.
template <class Real, class Use>
void with_model(const MaterialModel& m, Use use) {
  with_model_type<Real>(m.material, [&]<class Model>(std::size_t place) { use(Model(m), place); });
}

/// The most numbers that a compiled model keeps of a particle.
template <class Real, int axes>
constexpr int most_own_numbers = []<class... Models>(ModelList<Models...>) {
  return std::max({numbers_in(Models::state, axes)...});
}(CompiledModels<Real>{});

}  // namespace mpm
