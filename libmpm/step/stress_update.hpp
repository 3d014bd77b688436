#pragma once
#include "libmpm/step/state.hpp"

namespace mpm {

/// New density, deviator, pressure and viscous pressure of every particle from its velocity gradient, by its
/// material model (material/model.hpp). Fills the report's signal, dilations, kinetic energy and the mass
/// beyond the model's validity.
template <int axes>
void update_stress(BasicState<axes>&, const MaterialModel&, double dt, BasicStepReport<axes>&);

}  // namespace mpm
