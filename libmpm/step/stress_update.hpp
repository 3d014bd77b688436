#pragma once
#include "libmpm/step/state.hpp"

namespace mpm {

/// New density, deviator, pressure and viscous pressure of every particle from its velocity gradient, by the
/// model of its material (material/model.hpp). Fills the report's signal, dilations, kinetic energy and the
/// mass beyond the model's validity.
template <int axes>
void update_stress(BasicState<axes>&, const MaterialModels&, double dt, BasicStepReport<axes>&);

}  // namespace mpm
