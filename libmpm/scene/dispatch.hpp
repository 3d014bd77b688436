#pragma once
#include <memory>
#include <vector>

#include "libmpm/measure/measurement.hpp"
#include "libmpm/scene/scene.hpp"
#include "libmpm/step/stepper.hpp"

namespace mpm {

/// Names become types here and nowhere else: the stepper for the scheme and the material of a scene.
std::unique_ptr<Stepper> stepper_for(const Scene&);

/// What a scene is measured by. The energy balance is always there and is not in this list.
std::vector<std::unique_ptr<Measurement>> measurements_for(const Scene&, const State&);

}  // namespace mpm
