#pragma once
#include <memory>
#include <vector>

#include "libmpm/measure/measurement.hpp"
#include "libmpm/scene/scene.hpp"

namespace mpm {

using Measurements = std::vector<std::unique_ptr<Measurement>>;

/// Runs a state that was prepared by hand to the scene's end. Of the scene it takes material, numerics,
/// measures, end time and, for the first time step, the speed; the body is the state's. The balance and the
/// health of the run are always measured. A breakdown is a result.
RunResult run_state(const Scene&, State&, const Measurements&, Observer&);

}  // namespace mpm
