#pragma once
#include <functional>
#include <memory>
#include <vector>

#include "libmpm/core/symmetric.hpp"
#include "libmpm/material/material.hpp"
#include "libmpm/verification/lagrangian/quad_mesh.hpp"

namespace mpm::verification::lagrangian {

/// A two-dimensional Lagrangian code in plane strain, the reference of scenes that have no exact answer and
/// whose material does not turn over. It shares the text of the material models with the material point
/// method (libmpm/material) and nothing else: no particles, no grid, no transfer.
///
/// Nodes carry position and velocity, quadrilaterals density, energy and stress (staggered). With the area
/// vector a_c = dA/dx_c of corner c, the gradient of a cell and the force on its corner are
///   L = sum_c v_c a_c^T / A,   F_c = -sigma a_c + F_c(viscosity) + F_c(hourglass)              [N/m]
///   m_j dv_j/dt = sum of F_c over the cells at node j
///   m de = -sum_c F_c . (v_c + v_c') / 2 dt    v, v': before and after
/// so that the sum of kinetic and internal energy is constant to rounding (compatible form: Caramana, Burton,
/// Shashkov, Whalen 1998, J. Comput. Phys. 146, 227). Velocity and energy stand half a step before positions
/// and stress, as the material models want it (material/solid.hpp).
///
/// Viscosity (Caramana, Shashkov, Whalen 1998, J. Comput. Phys. 144, 70): along each edge of a cell that
/// shortens, from node 1 to node 2 with D = v2 - v1 and the area vector S of the line from the edge's middle
/// to that of the cell,
///   F_1 = -F_2 = (1 - psi) rho (q1 c + q2 |D|) |S . D| D/|D|   where S . D < 0
///   psi = max(0, min(1, (r + r')/2, 2 r, 2 r')),  r = (D_n . D / dx_n . dx) |dx|^2 / |D|^2
/// r, r': of the next edge beyond each end; 1 where there is none (as beyond a mirror). Where the motion is
/// smooth psi is nearly 1 and viscosity of second order.
/// Hourglass: Flanagan & Belytschko 1981, Int. J. Numer. Meth. Engng 17, 679, the viscous form: with gamma,
/// the part of (1, -1, 1, -1) that is orthogonal to every linear field,
///   F_c = -k rho c sqrt(A) gamma_c sum_b gamma_b v_b.
/// Scales by powers of two do not change a bit of the dimensionless result. One thread.
class Lagrangian2d {
 public:
  struct Options {
    double linear_viscosity = 0.3;     ///< q1 [1]
    double quadratic_viscosity = 1.5;  ///< q2 [1]
    bool limiter = true;               ///< psi as above; else 0
    double hourglass = 0.1;            ///< k [1]
    double cfl = 0.4;                  ///< share of the stability limit [1]
  };

  /// At rest density and without stress, with the velocity of each node [m/s] (what holds forbid is left
  /// out). Throws std::invalid_argument where a cell has no area, or counts do not fit.
  Lagrangian2d(const Material&, QuadMesh, std::vector<Vec2> velocities, const Options&);
  ~Lagrangian2d();

  /// One step, no longer than `longest` [s]. False, and nothing done any more, once a cell has no area left:
  /// the mesh does not follow the material further.
  bool advance(double longest);

  double time() const { return time_; }  ///< of the positions [s]
  const QuadMesh& mesh() const { return mesh_; }
  const std::vector<Vec2>& positions() const { return mesh_.nodes; }
  const std::vector<Vec2>& velocities() const { return velocity_; }    ///< half a step earlier [m/s]
  double pressure(std::size_t cell) const { return pressure_[cell]; }  ///< of the equation of state [Pa]
  const Deviator<double>& deviator(std::size_t cell) const { return deviator_[cell]; }  ///< [Pa]
  double area(std::size_t cell) const { return area_[cell]; }                           ///< [m^2]
  double mass(std::size_t cell) const { return mass_[cell]; }                           ///< [kg/m]
  /// The material's own numbers of a cell (StateColumn), one after the other.
  const double* own(std::size_t cell) const { return &own_[cell * own_count_]; }
  /// Kinetic + internal energy, half a step earlier, and what the floor took away by then [J/m].
  double energy() const;
  double steps() const { return steps_; }

 private:
  struct Edge {
    int from, to;
    int before, after;  ///< the next edges; -1: none
  };
  struct Corners;  ///< of a cell, its geometry

  void find_edges();
  double limiter(const Edge&) const;
  double stable_step() const;
  void find_forces();
  void accelerate(double dt);
  void deform(double dt);

  Material material_;
  QuadMesh mesh_;
  Options options_;
  std::vector<Vec2> velocity_;
  std::vector<double> node_mass_;
  std::vector<Edge> edges_;
  std::vector<std::array<int, 4>> cell_edges_;  ///< edge k of a cell leads from its node k to k + 1
  std::vector<std::array<Vec2, 4>> force_;      ///< on the corners of each cell [N/m]
  std::vector<double> mass_, first_area_, area_, dilation_, energy_, pressure_, sound_, own_;
  std::vector<Deviator<double>> deviator_;
  std::size_t own_count_ = 0;
  double time_ = 0, last_step_ = 0, floor_work_ = 0, steps_ = 0;
  bool tangled_ = false;
};

}  // namespace mpm::verification::lagrangian
