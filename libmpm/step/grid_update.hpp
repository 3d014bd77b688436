#pragma once
#include "libmpm/core/grid.hpp"

namespace mpm {

/// Momentum becomes velocity and force acceleration: a_i = f_i / m_i, v_i <- (m v)_i / m_i + dt a_i.
/// A node without mass stays at zero.
inline void update_grid(Grid& grid, double dt) {
  for (Node& n : grid.nodes()) {
    if (n.mass == 0) continue;
    const double inverse = 1 / n.mass;
    n.acceleration *= inverse;
    n.velocity = n.velocity * inverse + dt * n.acceleration;
  }
}

/// dt sum m_i a_i over the masses that the particles gave: the momentum that the particles gain in this step.
/// Internal forces add up to zero, so it is the impulse of the walls [kg/s].
inline Vec2 wall_impulse(const Grid& grid, double dt) {
  Vec2 gained = Vec2::Zero();
  for (const Node& n : grid.nodes()) gained += dt * n.own_mass * n.acceleration;
  return gained;
}

}  // namespace mpm
