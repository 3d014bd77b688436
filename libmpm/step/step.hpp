#pragma once
/// The time step, on one screen. This is the plain one: it is read to learn the method and it is the oracle
/// that every faster step is held against.
///
/// Stages, in order (explicit, symplectic; stress last):
///   1. p2g       mass, momentum and internal forces go to the grid, gravity and body forces where there are
///   any
///   2. mirrors   what lies behind a side wall is the image of what lies before it
///   3. grid      a = f/m, v <- v + dt a; bodies in contact push each other, and the impact wall them
///   4. g2p       particles accelerate (flip.hpp, flip_pic.hpp, apic.hpp), move, receive their work and the
///                heat of the transfer
///   5. stress    density, deviator, pressure, viscosity from the new velocity gradient
///
///        particles                  nodes                       particles
///   +---+---+---+---+        +---+---+---+---+             +---+---+---+---+
///   | . . | . . |   |   1    |   m, m v, f   |    4        |. . | . .|   |   |
///   | . . | . . |   |  --->  o---o---o---o---o   --->      |. . | . .|   |   |   5: stress of the new
///   |   | . . | . . |        | 2 mirrors, 3 a = f/m |      |   |. . | . .|   |      velocity gradient
///   +---+---+---+---+        +---+---+---+---+             +---+---+---+---+
///
/// Velocities and energies that particles carry belong to the middle between two stresses (leapfrog),
/// positions, densities and stresses to whole steps. Energy is conserved to rounding by construction (see
/// g2p.hpp).
#include <algorithm>
#include <limits>

#include "libmpm/boundary/impact_wall.hpp"
#include "libmpm/boundary/mirror.hpp"
#include "libmpm/step/body_force.hpp"
#include "libmpm/step/g2p.hpp"
#include "libmpm/step/gravity.hpp"
#include "libmpm/step/grid_update.hpp"
#include "libmpm/step/p2g.hpp"
#include "libmpm/step/stress_update.hpp"

namespace mpm {

template <ShapeFunctions Shape, class Transfer = Flip, class Space = space::PlaneStrain,
          class Force = NoBodyForce, class Fields = OneField>
BasicStepReport<Space::axes> reference_step(BasicState<Space::axes>& state, const MaterialModels& materials,
                                            double dt, const Transfer& transfer = {}, const Force& force = {},
                                            Fields fields = {}) {
  static_assert(ShapeIn<Shape, Space>);
  BasicStepReport<Space::axes> report;
  auto& grid = state.grid;
  double highest = grid.origin().y();
  bool inside = true;
  for (const auto& x : state.particles.position) {
    highest = std::max(highest, x.y());
    inside &= grid.holds(x);
  }
  if (!inside) {  // or not a number: no node to write to
    report.largest_signal = std::numeric_limits<double>::quiet_NaN();
    return report;
  }
  if constexpr (requires { Shape::start(state.particles); }) Shape::start(state.particles);
  Transfer::start(state.particles);
  if constexpr (Space::has_hoop) state.hoop_rate.resize(state.particles.size());
  const int highest_row = static_cast<int>((highest - grid.origin().y()) * grid.inverse_cell().y());
  const int top = std::max(highest_row, state.ceiling.value_or(0)) + Shape::reach;
  grid.grow_to_row(top);
  grid.clear();

  fields.template start<Shape, Space>(state);
  p2g<Shape, Transfer, Space>(state.particles, grid, fields);
  add_body_force<Shape, Space>(state, force);
  const Vec<Space::axes> gravity = gravity_now(state);
  const bool heavy = !gravity.isZero(0);
  if (heavy) add_gravity(grid, gravity, fields);
  fields.each_node(grid, [](auto& n) { n.own_mass = n.mass; });
  report.at_open_face = at_open_face(grid, state.open, state.floor, top) || fields.at_open_face(state, top);
  reflect_sides(grid, top);
  if (state.floor == Floor::mirror) reflect_floor(grid);
  if (state.ceiling) reflect_row(grid, *state.ceiling, Shape::reach);
  fields.template reflect<Shape, Transfer, Space>(state);
  update_grid(grid, dt, fields);
  fields.push(state, dt, report);
  if (state.floor == Floor::impact_wall) {
    apply_impact_wall(grid, dt, state.tracks_wall_gap ? &state.wall_gaps : nullptr);
    fields.push_off_wall(dt);
  }
  report.wall_impulse = wall_impulse(grid, dt, fields) - report.rigid_impulse;
  if (heavy) {
    report_gravity(grid, gravity, dt, report, fields);
    report.wall_impulse -= report.gravity_impulse;
  }
  fields.settle(state, dt, report);
  report.transfer_heat = g2p<Shape, Transfer, Space>(state.particles, grid, dt, state.velocity_gradient,
                                                     transfer, &state.hoop_rate, fields);
  update_stress(state, materials, dt, report);

  state.time += dt;
  ++state.step;
  return report;
}

}  // namespace mpm
