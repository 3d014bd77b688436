#pragma once
#include "libmpm/step/step.hpp"
#include "libmpm/step/stepper.hpp"

namespace mpm {

/// The plain step, on the State itself.
template <ShapeFunctions Shape>
class ReferenceStepper : public Stepper {
 public:
  explicit ReferenceStepper(const MaterialModel& model) : model_(model) {}
  StepReport step(State& state, double dt) override { return reference_step<Shape>(state, model_, dt); }

 private:
  MaterialModel model_;
};

}  // namespace mpm
