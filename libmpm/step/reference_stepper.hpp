#pragma once
#include "libmpm/step/step.hpp"
#include "libmpm/step/stepper.hpp"

namespace mpm {

/// The plain step, on the State itself.
template <ShapeFunctions Shape, class Transfer = Flip, class Space = space::PlaneStrain>
class ReferenceStepper : public BasicStepper<Space::axes> {
 public:
  explicit ReferenceStepper(const MaterialModel& model, const Transfer& transfer = {})
      : model_(model), transfer_(transfer) {}
  BasicStepReport<Space::axes> step(BasicState<Space::axes>& state, double dt) override {
    return reference_step<Shape, Transfer, Space>(state, model_, dt, transfer_);
  }

 private:
  MaterialModel model_;
  Transfer transfer_;
};

}  // namespace mpm
