#pragma once
#include "libmpm/core/grid.hpp"

namespace mpm {

/// Momentum becomes velocity and force acceleration: a_i = f_i / m_i, v_i <- (m v)_i / m_i + dt a_i.
/// A node without mass stays at zero.
template <int axes>
void update_grid(BasicGrid<axes>& grid, double dt) {
  for (BasicNode<axes>& n : grid.nodes()) {
    if (n.mass == 0) continue;
    const double inverse = 1 / n.mass;
    n.acceleration *= inverse;
    n.velocity = n.velocity * inverse + dt * n.acceleration;
  }
}

/// dt sum m_i a_i over the masses that the particles gave: the momentum that the particles gain in this step.
/// Internal forces add up to zero, so it is the impulse of the walls [kg/s].
template <int axes>
Vec<axes> wall_impulse(const BasicGrid<axes>& grid, double dt) {
  Vec<axes> gained = Vec<axes>::Zero();
  for (const BasicNode<axes>& n : grid.nodes()) gained += dt * n.own_mass * n.acceleration;
  return gained;
}

}  // namespace mpm
