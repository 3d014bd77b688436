#pragma once
#include "libmpm/step/step.hpp"
#include "libmpm/step/stepper.hpp"

namespace mpm {

/// The plain step, on the State itself.
template <ShapeFunctions Shape, class Transfer = Flip, class Space = space::PlaneStrain,
          class Force = NoBodyForce>
class ReferenceStepper : public BasicStepper<Space::axes> {
 public:
  explicit ReferenceStepper(const MaterialModels& materials, const Transfer& transfer = {},
                            const Force& force = {})
      : materials_(materials), transfer_(transfer), force_(force) {}
  BasicStepReport<Space::axes> step(BasicState<Space::axes>& state, double dt) override {
    return reference_step<Shape, Transfer, Space>(state, materials_, dt, transfer_, force_);
  }

 private:
  MaterialModels materials_;
  Transfer transfer_;
  Force force_;
};

}  // namespace mpm
