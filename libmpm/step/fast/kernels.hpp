#pragma once
/// What the fast step is made of: plain data and two functions, compiled for several instruction sets.
#include <cstddef>
#include <cstdint>

namespace mpm::fast {

/// Columns of a block of particles. Lengths are in cells, volumes in cells too, so that single precision
/// suffices; everything else is SI. Columns that a variant lacks have no place in its blocks.
enum Column : int {
  position_x,        ///< against the grid's origin [cells]
  position_y,        ///< [cells]
  velocity_x,        ///< [m/s]
  velocity_y,        ///< [m/s]
  initial_volume,    ///< [cells]; 0: a lane without particle. Mass is rho0 times it.
  dilation,          ///< J - 1 [1]
  energy,            ///< [J/kg]
  pressure,          ///< [Pa]
  viscous_pressure,  ///< [Pa]
  deviator_xx,       ///< [Pa]; deviator_zz = -(xx + yy)
  deviator_yy,
  deviator_xy,
  plastic_strain,  ///< [1]
  plastic_work,    ///< [J/kg]
  common_columns,
};

/// What is compiled: each combination is a kernel of its own, so that what a scene lacks costs nothing.
struct Variant {
  bool gimp;            ///< two more columns: half sizes of the domain [cells]
  bool back_stress;     ///< three more columns: kinematic hardening
  bool linear_tension;  ///< P = C mu in expansion

  int columns() const { return common_columns + (gimp ? 2 : 0) + (back_stress ? 3 : 0); }
};

/// Nodes row by row. Index of node (i, j): (j + 1) stride + (i + 1).
template <class Real>
struct Nodes {
  Real* motion;  ///< four a node: momentum and force, then velocity and change of velocity over the step
  Real* mass;    ///< [rho0 hx hy]
  Real* square;  ///< of the change of velocity [m^2/s^2]
  int stride;    ///< a multiple of 4
  int columns;   ///< cells across
  int rows;      ///< nodes j = -1 ... rows - 2
};

/// Numbers of the material and the grid that a sweep uses.
template <class Real>
struct Constants {
  Real rho0, inverse_rho0;
  Real cold_c, cold_d, cold_s, gamma0, least_sound_square, pressure_floor,
      pressure_limit;                                                      ///< see MieGrueneisen
  Real shear_modulus, yield_stress, isotropic_modulus, kinematic_modulus;  ///< see J2
  Real inverse_return;                                                     ///< 1 / (3 G + H)
  Real linear_viscosity, quadratic_viscosity, viscous_length;              ///< see ArtificialViscosity
  Real force_x, force_y;                                                   ///< 1 / (rho0 hx), 1 / (rho0 hy)
  Real inverse_cell_x, inverse_cell_y;
};

/// Sums over the particles of a sweep.
struct SweepReport {
  double largest_signal, smallest_dilation, largest_dilation;
  double overpressed;             ///< mass beyond the equation of state [rho0 hx hy]
  double lowest, highest;         ///< y of the particles after the step [cells]
  double transfer_heat;           ///< [rho0 hx hy m^2/s^2]
  double momentum_x, momentum_y;  ///< gained [rho0 hx hy m/s]
  bool broken;                    ///< a particle is not finite or left the grid
};

template <class Real>
struct Kernels {
  /// Particles to grid: adds mass, momentum and internal force of blocks to `to`.
  void (*scatter)(const Real* blocks, std::size_t block_count, const Nodes<Real>& to, const Constants<Real>&);
  /// Grid to particles, stress, and particles to the grid of the next step, in one pass over the particles.
  void (*sweep)(Real* blocks, std::size_t block_count, const Nodes<Real>& from, const Nodes<Real>& to,
                const Constants<Real>&, double dt, SweepReport&);
  /// Momentum and force of rows [first, last] become motion. Nodes without mass stay at zero.
  void (*move)(const Nodes<Real>&, int first_row, int last_row, double dt);
};

/// The kernels of the best instruction set of this processor.
Kernels<double> kernels_for(const Variant&);
/// Those of one instruction set; null pointers where it is not there. For tests.
enum class InstructionSet { baseline, avx2 };
Kernels<double> kernels_for(const Variant&, InstructionSet);
bool supported(InstructionSet);

namespace baseline {
Kernels<double> kernels(const Variant&);
}
namespace avx2 {
Kernels<double> kernels(const Variant&);
}

}  // namespace mpm::fast
