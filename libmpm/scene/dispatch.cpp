#include "libmpm/scene/dispatch.hpp"

#include <stdexcept>

#include "libmpm/measure/cavity.hpp"
#include "libmpm/measure/hot_spots.hpp"
#include "libmpm/measure/planar_shock.hpp"
#include "libmpm/measure/shell.hpp"
#include "libmpm/shape/bspline2.hpp"
#include "libmpm/shape/gimp.hpp"
#include "libmpm/step/step.hpp"

namespace mpm {

StepFunction step_for(const Numerics& n) {
  switch (n.scheme) {
    case ShapeFunction::gimp:
      return reference_step<Gimp>;
    case ShapeFunction::bspline2:
      return reference_step<BSpline2>;
  }
  throw std::logic_error("a scheme that is not compiled");
}

std::vector<std::unique_ptr<Measurement>> measurements_for(const Scene& s, const State& state,
                                                           Observer& observer) {
  std::vector<std::unique_ptr<Measurement>> all;
  if (s.kind == SceneKind::cavity_impact) all.push_back(std::make_unique<Cavity>(s, state, observer));
  if (s.kind == SceneKind::planar_impact) all.push_back(std::make_unique<PlanarShock>(s, state));
  if (s.kind == SceneKind::imploding_shell) all.push_back(std::make_unique<Shell>(s, state));
  all.push_back(std::make_unique<HotSpots>(
      Temperature{MieGrueneisen(s.material), s.material.specific_heat, s.material.initial_temperature}));
  return all;
}

}  // namespace mpm
