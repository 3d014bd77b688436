#pragma once
#include <memory>

#include "libmpm/measure/measurement.hpp"
#include "libmpm/scene/scene.hpp"
#include "libmpm/step/stepper.hpp"

namespace mpm {

/// Names become types here and nowhere else: the stepper for the scheme and the material of a scene.
template <int axes = 2>
std::unique_ptr<BasicStepper<axes>> stepper_for(const Scene&);

/// What a scene is measured by. The energy balance is always there and is not in this list.
template <int axes>
BasicMeasurements<axes> measurements_for(const Scene&, const BasicState<axes>&);

}  // namespace mpm
