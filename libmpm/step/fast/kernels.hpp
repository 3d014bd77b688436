#pragma once
/// What the fast step is made of: plain data and a few functions, compiled for several instruction sets.
#include <cstddef>
#include <cstdint>

#include "libmpm/space/space.hpp"

namespace mpm::fast {

/// Columns of a block of particles. Lengths are in cells, volumes in cells too, and positions are relative to
/// the nearest node, so that single precision suffices; everything else is SI. Columns that a variant lacks
/// have no place in its blocks.
enum Column : int {
  node,              ///< index of the lower left node of the stencil, a whole number
  position_x,        ///< against the nearest node, -1/2 ... 1/2 [cells]
  position_y,        ///< [cells]
  velocity_x,        ///< [m/s]
  velocity_y,        ///< [m/s]
  initial_volume,    ///< mass [unit_mass()]; 0: a lane without particle
  dilation,          ///< J - 1 [1]
  energy,            ///< [J/kg]
  pressure,          ///< [Pa]
  viscous_pressure,  ///< [Pa]
  deviator_xx,       ///< [Pa]; deviator_zz = -(xx + yy)
  deviator_yy,
  deviator_xy,
  common_columns,
};

/// The columns of a block: the common ones, half sizes of the domains (with GIMP along both axes, in
/// axisymmetry along x), then the material model's own.
struct Layout {
  bool gimp;
  Space space;
  int own_columns;

  static constexpr int half_size() { return common_columns; }  ///< [cells]
  constexpr int half_sizes() const { return gimp ? 2 : space == Space::axisymmetric ? 1 : 0; }
  constexpr int own() const { return half_size() + half_sizes(); }
  constexpr int columns() const { return own() + own_columns; }
};

/// Components of Nodes::sums and of Nodes::motion.
enum Sum : int { node_mass, momentum_of_x, momentum_of_y, force_of_x, force_of_y, sum_components };
enum Motion : int {
  motion_x,  ///< momentum, then velocity at the end of the step [m/s]
  motion_y,
  change_x,  ///< force, then change of velocity over the step [m/s]
  change_y,
  change_square,  ///< square of the change of velocity [m^2/s^2]
  motion_mass,    ///< [unit_mass()]
  motion_components,
};

/// Nodes row by row, in groups of `width` neighbours; the components of a group lie side by side, each a
/// pack. Number of node (i, j): (j + 1) stride + (i + 1). Groups begin at multiples of the width.
template <class Real>
struct Nodes {
  static constexpr int width = 32 / sizeof(Real);

  Real* motion;  ///< see Motion
  Real* sums;    ///< component c of node n is the sum over k < 3 of what entry 3 c + k holds at node n - k
  int stride;    ///< a multiple of the width
  int columns;   ///< cells across
  int rows;      ///< nodes j = -1 ... rows - 2

  static constexpr std::ptrdiff_t motion_at(std::ptrdiff_t node, int component = 0) {
    return (node / width * motion_components + component) * width + node % width;
  }
  static constexpr std::ptrdiff_t sum_at(std::ptrdiff_t node, int entry = 0) {
    return (node / width * (3 * sum_components) + entry) * width + node % width;
  }
};

/// Numbers of the grid that transfers use.
template <class Real>
struct Constants {
  Real inverse_rho0;
  Real force_x, force_y;  ///< 1 / (rho0 hx), 1 / (rho0 hy)
  Real inverse_cell_x, inverse_cell_y;
};

/// Blocks side by side, and the rows of nodes in which their stencils may start. A particle that would leave
/// these rows is broken: it is kept inside, so that nothing else is overwritten.
template <class Real>
struct Band {
  Real* blocks;
  std::size_t count;
  int columns;  ///< of a block
  int first_row, last_row;
};

/// Sums over the particles of a band.
struct SweepReport {
  double largest_signal, smallest_dilation, largest_dilation;
  double overpressed, overstrained;  ///< mass beyond the equation of state [unit_mass()]
  double lowest_node, highest_node;  ///< index of the lower left node of a stencil, after the step
  double transfer_heat, kinetic;     ///< [unit_mass() m^2/s^2]
  double momentum_x, momentum_y;     ///< gained [unit_mass() m/s]
  std::int64_t out_of_step;          ///< blocks whose lanes do not lie in neighbouring cells
  bool broken;                       ///< a particle is not finite or left its rows
};

/// Blocks that go through the stages of a sweep together: so few that they stay in the first-level cache.
inline constexpr int chunk_blocks = 8;

/// Largest and smallest values of a sweep, lane by lane.
template <class Real>
struct alignas(32) Extremes {
  static constexpr int width = 32 / sizeof(Real);
  Real signal[width] = {}, low_dilation[width] = {}, high_dilation[width] = {}, high_pressure[width] = {};
  Real finite[width] = {};  ///< 0, or not a number where a state is not finite
};

/// dt L of the blocks of a chunk: the gradients of the displacement over the step, each xx, xy, yx, yy.
template <class Real>
struct alignas(32) Gradients {
  static constexpr int width = 32 / sizeof(Real);
  Real of_block[chunk_blocks][4][width];
  Real hoop[chunk_blocks][width];  ///< dt v_r / r, in a space that has it
};

/// The stress update of a material model.
template <class Real>
struct StressUpdate {
  /// New state of `count` <= chunk_blocks blocks, whose columns of the model begin at `own`.
  void (*update)(const void* model, Real* blocks, int count, int columns, int own, const Gradients<Real>&,
                 Real inverse_dt, Extremes<Real>&);
  /// Adds to the report what has become of a band.
  void (*report)(const void* model, const Band<Real>&, const Extremes<Real>&, SweepReport&);
  const void* model = nullptr;  ///< of the list's type (material/list.hpp)
};

/// The transfers, which depend on the shape function.
template <class Real>
struct Transfers {
  /// Particles to grid: adds mass, momentum and internal force of blocks to the sums.
  void (*scatter)(const Band<Real>&, const Nodes<Real>&, const Constants<Real>&);
  /// Grid to particles, stress, and particles to the sums of the next step, in one pass over the particles.
  void (*sweep)(const Band<Real>&, const Nodes<Real>&, const Constants<Real>&, double dt,
                const StressUpdate<Real>&, SweepReport&);
  /// Sums of rows [first, last] become mass, momentum and force, and are cleared.
  void (*collect)(const Nodes<Real>&, int first_row, int last_row);
  /// Momentum and force of rows [first, last] become motion. Nodes without mass stay at zero.
  void (*move)(const Nodes<Real>&, int first_row, int last_row, double dt);
};

template <class Real>
struct Kernels {
  Transfers<Real> transfers;
  StressUpdate<Real> stress;
};

enum class InstructionSet { baseline, avx2 };
bool supported(InstructionSet);
/// The best one of this processor.
InstructionSet best_instruction_set();

/// `model`: place in the list of material/list.hpp.
template <class Real>
Kernels<Real> kernels_for(bool gimp, Space, std::size_t model, InstructionSet);

}  // namespace mpm::fast
