#pragma once
/// What the fast step is made of: plain data and a few functions, compiled for several instruction sets.
#include <bit>
#include <cstddef>
#include <cstdint>

#include "libmpm/core/state_column.hpp"
#include "libmpm/space/space.hpp"

namespace mpm::fast {

/// Columns of a block of particles. Lengths are in cells, volumes in cells too, and positions are relative to
/// the nearest node, so that single precision suffices; everything else is SI. Vectors take a column an axis.
/// Columns that a variant lacks have no place in its blocks.
template <int axes>
struct Columns {
  enum : int {
    node,                              ///< number of the lower left node of the stencil, see real_of_node()
    position,                          ///< against the nearest node, -1/2 ... 1/2 [cells]
    velocity = position + axes,        ///< [m/s]
    initial_volume = velocity + axes,  ///< mass [unit_mass()]; 0: a lane without particle
    dilation,                          ///< J - 1 [1]
    energy,                            ///< [J/kg]
    pressure,                          ///< [Pa]
    viscous_pressure,                  ///< [Pa]
    deviator,                          ///< in the order of load() in core/symmetric.hpp [Pa]
    common = deviator + numbers_in(StateForm::deviator, axes),
  };
};

/// The number of a node as it lies in a column: a double, or 32 bits in the place of a float, which counts to
/// 2^24 alone.
template <class Real>
Real real_of_node(std::int64_t node) {
  if constexpr (sizeof(Real) == 8)
    return static_cast<Real>(node);
  else
    return std::bit_cast<Real>(static_cast<std::int32_t>(node));
}
template <class Real>
std::int64_t node_of_real(Real column) {
  if constexpr (sizeof(Real) == 8)
    return static_cast<std::int64_t>(column);
  else
    return std::bit_cast<std::int32_t>(column);
}

/// The columns of a block: the common ones, half sizes of the domains (with GIMP along all axes, in
/// axisymmetry along x), then the material model's own.
struct Layout {
  bool gimp;
  Space space;
  int own_columns;

  constexpr int axes() const { return axes_of(space); }
  constexpr int half_size() const {  ///< [cells]
    return axes() == 3 ? int{Columns<3>::common} : int{Columns<2>::common};
  }
  constexpr int half_sizes() const { return gimp ? axes() : space == Space::axisymmetric ? 1 : 0; }
  constexpr int own() const { return half_size() + half_sizes(); }
  constexpr int columns() const { return own() + own_columns; }
};

/// Components of Nodes::sums. Vectors take a component an axis.
template <int axes>
struct Sums {
  enum : int { mass, momentum, force = momentum + axes, components = force + axes };
};
/// Components of Nodes::motion.
template <int axes>
struct Motion {
  enum : int {
    velocity,                  ///< momentum, then velocity at the end of the step [m/s]
    change = axes,             ///< force, then change of velocity over the step [m/s]
    change_square = 2 * axes,  ///< square of the change of velocity [m^2/s^2]
    mass,                      ///< [unit_mass()]
    components,
  };
};

/// Nodes line by line along x, the lines of a row side by side along z, and row by row along y, in groups of
/// `width` neighbours; the components of a group lie side by side, each a pack. Of two axes a row is one
/// line. Number of node (i, j): (j + 1) to_row + (i + 1); of (i, j, k): (j + 1) to_row + (k + 1) stride + (i
/// + 1). Groups begin at multiples of the width.
template <class Real, int axes>
struct Nodes {
  static constexpr int width = 32 / sizeof(Real);
  static constexpr int entries = 3 * Sums<axes>::components;  ///< of a node in `sums`

  Real* motion;  ///< see Motion
  Real* sums;    ///< component c of node n is the sum over k < 3 of what entry 3 c + k holds at node n - k
  int stride;    ///< from a line to the next: a multiple of the width
  int to_row;    ///< from a row to the next: of two axes the stride
  int columns;   ///< cells along x
  int slices;    ///< cells along z; of two axes 0
  int rows;      ///< nodes j = -1 ... rows - 2

  static constexpr std::ptrdiff_t motion_at(std::ptrdiff_t node, int component = 0) {
    return (node / width * Motion<axes>::components + component) * width + node % width;
  }
  static constexpr std::ptrdiff_t sum_at(std::ptrdiff_t node, int entry = 0) {
    return (node / width * entries + entry) * width + node % width;
  }
  /// From the lower left node of a stencil to the first one of its line (j, k).
  std::ptrdiff_t to_line(int j, int k) const {
    return j * static_cast<std::ptrdiff_t>(to_row) + k * static_cast<std::ptrdiff_t>(stride);
  }
};

/// Numbers of the grid that transfers use.
template <class Real, int axes>
struct Constants {
  Real inverse_rho0;
  Real force[axes];  ///< 1 / (rho0 h), by axis
  Real inverse_cell[axes];
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
  double overpressed, overstrained;        ///< mass beyond the equation of state [unit_mass()]
  std::int64_t lowest_node, highest_node;  ///< number of the lower left node of a stencil, after the step
  double transfer_heat, kinetic;           ///< [unit_mass() m^2/s^2]
  double momentum[3];                      ///< gained, by axis [unit_mass() m/s]
  std::int64_t out_of_step;                ///< blocks whose lanes do not lie in neighbouring cells
  bool broken;                             ///< a particle is not finite or left its rows
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

/// dt L of the blocks of a chunk: the gradients of the displacement over the step, each row by row: xx, xy,
/// ...
template <class Real, int axes>
struct alignas(32) Gradients {
  static constexpr int width = 32 / sizeof(Real);
  Real of_block[chunk_blocks][axes * axes][width];
  Real hoop[chunk_blocks][width];  ///< dt v_r / r, in a space that has it
};

/// The stress update of a material model.
template <class Real, int axes>
struct StressUpdate {
  /// New state of `count` <= chunk_blocks blocks, whose columns of the model begin at `own`.
  void (*update)(const void* model, Real* blocks, int count, int columns, int own,
                 const Gradients<Real, axes>&, Real inverse_dt, Extremes<Real>&);
  /// Adds to the report what has become of a band.
  void (*report)(const void* model, const Band<Real>&, const Extremes<Real>&, SweepReport&);
  const void* model = nullptr;  ///< of the list's type (material/list.hpp)
};

/// The transfers, which depend on the shape function.
template <class Real, int axes>
struct Transfers {
  using Nodes = fast::Nodes<Real, axes>;
  using Constants = fast::Constants<Real, axes>;

  /// Particles to grid: adds mass, momentum and internal force of blocks to the sums.
  void (*scatter)(const Band<Real>&, const Nodes&, const Constants&);
  /// Grid to particles, stress, and particles to the sums of the next step, in one pass over the particles.
  void (*sweep)(const Band<Real>&, const Nodes&, const Constants&, double dt, const StressUpdate<Real, axes>&,
                SweepReport&);
  /// Sums of rows [first, last] become mass, momentum and force, and are cleared.
  void (*collect)(const Nodes&, int first_row, int last_row);
  /// Momentum and force of rows [first, last] become motion. Nodes without mass stay at zero.
  void (*move)(const Nodes&, int first_row, int last_row, double dt);
};

template <class Real, int axes>
struct Kernels {
  Transfers<Real, axes> transfers;
  StressUpdate<Real, axes> stress;
};

enum class InstructionSet { baseline, avx2 };
bool supported(InstructionSet);
/// The best one of this processor.
InstructionSet best_instruction_set();

/// `model`: place in the list of material/list.hpp. The space must have so many axes.
template <class Real, int axes>
Kernels<Real, axes> kernels_for(bool gimp, Space, std::size_t model, InstructionSet);

}  // namespace mpm::fast
