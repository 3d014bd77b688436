#pragma once
#include <memory>
#include <vector>

#include "libmpm/measure/measurement.hpp"
#include "libmpm/scene/scene.hpp"
#include "libmpm/step/state.hpp"

namespace mpm {

/// A compiled time step.
using StepFunction = StepReport (*)(State&, const MaterialModel&, double dt);

/// Names become types here and nowhere else: the step for the scheme of a scene.
StepFunction step_for(const Numerics&);

/// What a scene is measured by. The energy balance is always there and is not in this list.
std::vector<std::unique_ptr<Measurement>> measurements_for(const Scene&, const State&, Observer&);

}  // namespace mpm
