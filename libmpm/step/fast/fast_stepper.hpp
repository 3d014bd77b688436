#pragma once
#include <optional>

#include "libmpm/step/fast/blocks.hpp"
#include "libmpm/step/fast/node_grid.hpp"
#include "libmpm/step/stepper.hpp"

namespace mpm::fast {

/// The step of step.hpp, made fast. What it does differently, and what each part brings, is told in
/// PERFORMANCE.md.
///   - Particles lie in blocks in the order of the cells (blocks.hpp), in units of cells.
///   - One pass over them does grid to particles, stress, and particles to grid for the next step
///   (sweep.hpp):
///     the grid exists twice, and when a step is over one of the two holds the next step's momentum and
///     forces.
///   - Each combination of shape function and physics that needs code of its own has a kernel, in each
///     instruction set (kernels.hpp).
/// Results agree with the reference step to rounding, and are the same bits for every instruction set.
/// state.particles is read in the first step and not afterwards: to change particles, make a new stepper.
class FastStepper : public Stepper {
 public:
  FastStepper(const MaterialModel&, const Variant&);
  FastStepper(const MaterialModel&, const Variant&, const Kernels<double>&);

  StepReport step(State&, double dt) override;
  void refresh_particles(State&) override;
  void refresh_particles(State&, std::span<const std::size_t> which) override;
  void refresh_nodes(State&, int first_row, int last_row) override;
  std::size_t memory() const override;

 private:
  void begin(State&);

  MaterialModel model_;
  Variant variant_;
  Kernels<double> kernels_;
  Constants<double> constants_{};
  std::optional<Blocks<double>> blocks_;
  std::optional<NodeGrid<double>> now_, next_;
  double lowest_ = 0, highest_ = 0;  ///< of the particles [cells]
  int since_sort_ = 0;
};

}  // namespace mpm::fast
