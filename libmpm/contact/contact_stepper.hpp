#pragma once
#include <memory>

#include "libmpm/scene/scene.hpp"
#include "libmpm/step/stepper.hpp"

namespace mpm {

/// The plain step with contact between the bodies of a scene.
template <int axes>
std::unique_ptr<BasicStepper<axes>> contact_stepper(const Scene&);

}  // namespace mpm
