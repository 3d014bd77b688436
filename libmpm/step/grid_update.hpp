#pragma once
#include "libmpm/core/grid.hpp"
#include "libmpm/step/one_field.hpp"

namespace mpm {

/// Momentum becomes velocity and force acceleration: a_i = f_i / m_i, v_i <- (m v)_i / m_i + dt a_i.
/// A node without mass stays at zero.
template <int axes, class Fields = OneField>
void update_grid(BasicGrid<axes>& grid, double dt, Fields fields = {}) {
  fields.each_node(grid, [dt](BasicNode<axes>& n) {
    if (n.mass == 0) return;
    const double inverse = 1 / n.mass;
    n.acceleration *= inverse;
    n.velocity = n.velocity * inverse + dt * n.acceleration;
  });
}

/// dt sum m_i a_i over the masses that the particles gave: the momentum that the particles gain in this step.
/// Internal forces add up to zero, so it is the impulse of the walls [kg/s].
template <int axes, class Fields = OneField>
Vec<axes> wall_impulse(BasicGrid<axes>& grid, double dt, Fields fields = {}) {
  Vec<axes> gained = Vec<axes>::Zero();
  fields.each_node(grid, [&](const BasicNode<axes>& n) { gained += dt * n.own_mass * n.acceleration; });
  return gained;
}

}  // namespace mpm
