#pragma once
#include "libmpm/step/one_field.hpp"
#include "libmpm/step/state.hpp"

namespace mpm {

/// Gravity at the start of the step that is next [m/s^2]: all of it, or while it rises t / rise of it.
template <int axes>
Vec<axes> gravity_now(const BasicState<axes>& s) {
  return s.time < s.gravity_rise ? Vec<axes>(s.time / s.gravity_rise * s.gravity) : s.gravity;
}

/// The weight of what every node has: f_i += m_i g   [N], with g the same everywhere.
/// Call between p2g and the mirrors.
template <int axes, class Fields = OneField>
void add_gravity(BasicGrid<axes>& grid, const Vec<axes>& gravity, Fields fields = {}) {
  fields.each_node(grid, [&](BasicNode<axes>& n) { n.acceleration += n.mass * gravity; });
}

/// What gravity does in a step whose motion the grid has: with the masses that the particles gave,
///   work = dt sum m_i g . (v_i - dt a_i/2),   impulse = dt sum m_i g
/// v_i - dt a_i/2 is the velocity in the middle of the step, so that the work is what the particles' kinetic
/// and internal energy gain, to rounding (g2p.hpp). Checked by tests/libmpm/gravity_test.cpp.
template <int axes, class Fields = OneField>
void report_gravity(BasicGrid<axes>& grid, const Vec<axes>& gravity, double dt, BasicStepReport<axes>& report,
                    Fields fields = {}) {
  double mass = 0;
  Vec<axes> moved = Vec<axes>::Zero();
  fields.each_node(grid, [&](const BasicNode<axes>& n) {
    mass += n.own_mass;
    moved += n.own_mass * (n.velocity - 0.5 * dt * n.acceleration);
  });
  report.gravity_work = dt * gravity.dot(moved);
  report.gravity_impulse = dt * mass * gravity;
}

}  // namespace mpm
