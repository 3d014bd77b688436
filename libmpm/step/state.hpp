#pragma once
#include <cstdint>
#include <optional>
#include <vector>

#include "libmpm/boundary/mirror.hpp"
#include "libmpm/core/grid.hpp"
#include "libmpm/core/particles.hpp"
#include "libmpm/material/model.hpp"
#include "libmpm/space/space.hpp"

namespace mpm {

/// What one field of bodies gave another in a step, both by their numbers (contact/contacts.hpp).
template <int axes>
struct BasicContactImpulse {
  int first, second;                       ///< first < second
  Vec<axes> on_first = Vec<axes>::Zero();  ///< the other one has the opposite [kg/s]
};

/// Sums over the particles after a step. Per metre of depth; in axisymmetry per radian; of three axes whole,
/// in kg and J.
template <int axes>
struct BasicStepReport {
  /// Fastest signal against the grid, sound + viscosity + motion [m/s]; NaN if a particle's state is not
  /// finite or a particle is outside the grid.
  double largest_signal = 0;
  double smallest_dilation = 0, largest_dilation = 0;  ///< J - 1 [1]
  double overpressed_mass = 0;   ///< of particles beyond the pressure limit of their model, Validity [kg/m]
  double overstrained_mass = 0;  ///< of particles outside its densities, Validity [kg/m]
  double kinetic_energy = 0;     ///< [J/m]
  double transfer_heat = 0;  ///< kinetic energy that the transfer took and left as heat in this step [J/m]
  Vec<axes> wall_impulse = Vec<axes>::Zero();     ///< that all walls gave in this step [kg/s]
  double gravity_work = 0;                        ///< that gravity did in this step [J/m]
  Vec<axes> gravity_impulse = Vec<axes>::Zero();  ///< that it gave [kg/s]
  // Of contact between bodies.
  double contact_heat = 0;   ///< kinetic energy that it left as heat in this step, friction with it [J/m]
  double friction_heat = 0;  ///< [J/m]
  double rigid_work = 0;     ///< that rigid bodies did on the others in this step [J/m]
  Vec<axes> rigid_impulse = Vec<axes>::Zero();        ///< that they gave [kg/s]
  std::vector<BasicContactImpulse<axes>> contacts{};  ///< of the pairs that touched
  bool at_open_face = false;                          ///< a body has reached an open side or floor
};
using StepReport = BasicStepReport<2>;

/// Everything that a step changes.
template <int axes>
struct BasicState {
  BasicParticles<axes> particles;
  BasicGrid<axes> grid;
  std::vector<Mat<axes>> velocity_gradient;  ///< of each particle, over the last step [1/s]
  double time = 0;                           ///< [s]
  std::int64_t step = 0;
  Floor floor = Floor::impact_wall;  ///< what y = origin of the grid is
  /// In axisymmetry x = 0, the axis, is the left side of the grid.
  Space space = axes == 3 ? Space::three_d : Space::plane_strain;
  std::vector<double>
      hoop_rate{};  ///< v_r / r of each particle, over the last step [1/s]; empty without hoop
  /// Row of nodes along which there is a mirror above the body, for the plain step.
  std::optional<int> ceiling{};
  OpenSides open{};
  Vec<axes> gravity = Vec<axes>::Zero();  ///< acceleration of all particles, for the plain step [m/s^2]
  double gravity_rise = 0;                ///< time over which it grows from nothing [s]
  bool has_rigid_bodies = false;          ///< which are no particles, and may do work on those
  bool tracks_wall_gap = false;           ///< of an impact wall: see boundary/impact_wall.hpp
  std::vector<double> wall_gaps{};  ///< of its columns, in the order of the stepper [m]; empty: none yet
};
using State = BasicState<2>;

/// Of a particle, in the plane of the grid [m^2].
inline double area(const State& s, std::size_t p) {
  const double volume = s.particles.volume(p);
  return s.space == Space::axisymmetric ? volume / s.particles.position[p].x() : volume;
}

/// What a particle fills of the grid's cells: an area [m^2], of three axes a volume [m^3].
inline double filled(const State& s, std::size_t p) { return area(s, p); }
inline double filled(const BasicState<3>& s, std::size_t p) { return s.particles.volume(p); }

}  // namespace mpm
