#pragma once
#include <array>
#include <cstddef>
#include <optional>
#include <vector>

#include "libmpm/core/thread_team.hpp"
#include "libmpm/step/fast/blocks.hpp"
#include "libmpm/step/fast/node_grid.hpp"
#include "libmpm/step/stepper.hpp"

namespace mpm::fast {

/// The step of step.hpp, made fast. What it does differently, and what each part brings, is told in
/// PERFORMANCE.md.
///   - Particles lie in blocks, lane by lane in neighbouring cells, in units of cells (blocks.hpp).
///   - One pass over them does grid to particles, stress, and particles to grid for the next step
///   (sweep.hpp).
///   - Bands of rows are worked on by several threads, where they are given (ThreadTeam). What a result is
///   made of does not depend on who made which part.
///   - Each shape function and each material model has a kernel, in each instruction set (kernels.hpp). The
///   materials of a scene are taken one after the other.
/// Results agree with the reference step to rounding.
/// state.particles is read in the first step and not afterwards: to change particles, make a new stepper.
template <class Real, int axes = 2>
class FastStepper : public BasicStepper<axes> {
 public:
  using State = BasicState<axes>;
  enum class Shape { bspline2, gimp };
  /// The space must have so many axes.
  FastStepper(const MaterialModels&, Shape, Space = axes == 3 ? Space::three_d : Space::plane_strain,
              InstructionSet = best_instruction_set());

  BasicStepReport<axes> step(State&, double dt) override;
  void refresh_particles(State&) override;
  void refresh_particles(State&, std::span<const std::size_t> which) override;
  void refresh_nodes(State&, int first_row, int last_row) override;
  void carry(State&, Archive&) override;
  std::size_t memory() const override;
  StepTimes times() const override { return times_; }
  void use_threads(int threads) override;
  double helper_seconds() const override { return team_.helper_seconds(); }

 private:
  using Blocks = fast::Blocks<Real, axes>;
  /// The particles of one material, with its model and its kernels.
  struct Stock {
    Layout layout{};
    double density = 0;                  ///< rho0 [kg/m^3]
    std::span<const StateColumn> own{};  ///< of the model
    Kernels<Real, axes> kernels{};
    alignas(16) std::array<std::byte, 320> model{};  ///< of material/list.hpp, for the kernels
    Constants<Real, axes> constants{};
    std::optional<Blocks> blocks{};
  };

  void begin(State&);
  Band<Real> band(Stock&, const typename Blocks::Range&);
  SweepReport sweep(double dt);
  void sweep(Stock&, double dt, SweepReport& sums);
  std::size_t blocks() const;  ///< of all stocks
  /// Returns whether a body has reached an open face.
  bool move(State&, double dt);
  void use(std::int64_t lowest_node, std::int64_t highest_node);

  Space space_;
  double density_;             ///< of unit_mass(): that of the first material [kg/m^3]
  std::vector<Stock> stocks_;  ///< one for each material
  std::optional<NodeGrid<Real, axes>> grid_;
  int first_row_ = 0, last_row_ = -1;      ///< of the nodes that the particles reach
  int moved_first_ = 0, moved_last_ = -1;  ///< of the nodes that moved in the last step
  std::int64_t out_of_step_ = 0;  ///< blocks that fell out of step, summed over the steps since the last sort
  std::vector<SweepReport> reports_;  ///< of the bands in the last sweep
  ThreadTeam team_;
  StepTimes times_;
  bool leaving_band_ = false;  ///< particles are about to leave the rows of their band
};

}  // namespace mpm::fast
