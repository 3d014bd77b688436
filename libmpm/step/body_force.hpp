#pragma once
#include <concepts>
#include <cstddef>

#include "libmpm/shape/shape.hpp"
#include "libmpm/space/stencil.hpp"
#include "libmpm/step/state.hpp"

namespace mpm {

/// A scene without body forces.
struct NoBodyForce {};

/// Adds to the forces of the nodes what acts on the body from afar:
///   f_i += sum w_ip m_p b_p,   b_p = force(p, t)      [N/kg]
/// with t the time at the start of the step. Call between p2g and the walls. The work of the force is motion
/// that the balance of energy counts as it counts that of a wall.
template <ShapeFunctions Shape, class Space, class Force>
void add_body_force(BasicState<Space::axes>& state, const Force& force) {
  if constexpr (!std::same_as<Force, NoBodyForce>) {
    using Vector = Vec<Space::axes>;
    const auto& ps = state.particles;
    for (std::size_t p = 0; p < ps.size(); ++p) {
      const Vector push = ps.mass[p] * force(p, state.time);
      stencil_of<Shape, Space>(state.grid, ps, p)
          .for_each(state.grid, [&](auto& n, double w, const auto&...) { n.acceleration += w * push; });
    }
  }
}

}  // namespace mpm
