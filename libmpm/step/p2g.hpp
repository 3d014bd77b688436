#pragma once
#include "libmpm/shape/shape.hpp"
#include "libmpm/step/flip.hpp"
#include "libmpm/step/one_field.hpp"
#include "libmpm/step/state.hpp"

namespace mpm {

/// From a particle to a node [m]; zero where the transfer does not ask.
template <class Transfer, int axes>
Vec<axes> offset_of(const BasicGrid<axes>& grid, const BasicParticles<axes>& particles, std::size_t p,
                    const BasicNode<axes>& n) {
  if constexpr (Transfer::affine) return grid.position(n) - particles.position[p];
  return Vec<axes>::Zero();
}

/// Particles to grid. With w_ip the weight of particle p at node i:
///   m_i = sum w_ip m_p,   (m v)_i = sum w_ip m_p v_p,   f_i = - sum V_p sigma_p grad w_ip
/// Node::velocity receives the momentum and Node::acceleration the force. The sums of m, m v over the nodes
/// are those over the particles, and the forces add up to zero, to rounding: partition of unity. Source:
/// Sulsky, Chen, Schreyer 1994, Comput. Methods Appl. Mech. Engng 118, 179.
/// v_p may depend on the node: it is what the transfer brings there. In axisymmetry the hoop stress gives
///   f_r,i -= V_p sigma_zz h_ip / r_p,   see space/space.hpp.
/// `fields`: which node it is, where bodies have velocity fields of their own.
template <ShapeFunctions Shape, class Transfer = Flip, class Space = space::PlaneStrain,
          class Fields = OneField>
void p2g(const BasicParticles<Space::axes>& particles, BasicGrid<Space::axes>& grid, Fields fields = {}) {
  using Vector = Vec<Space::axes>;
  for (std::size_t p = 0; p < particles.size(); ++p) {
    const auto stencil = stencil_of<Shape, Space>(grid, particles, p);
    const double mass = particles.mass[p];
    const Tensor<Space::axes> stress = particles.volume(p) * particles.stress(p);
    [[maybe_unused]] const double hoop_stress = stress.zz / particles.position[p].x();
    stencil.for_each(grid, [&](auto& at, double w, const Vector& g, [[maybe_unused]] double hoop = 0) {
      auto& n = fields.node(at, p);
      n.mass += w * mass;
      n.velocity += w * (mass * Transfer::brought(particles, p, offset_of<Transfer>(grid, particles, p, at)));
      n.acceleration -= product(stress, g);
      if constexpr (Space::has_hoop) n.acceleration.x() -= hoop * hoop_stress;
    });
  }
}

}  // namespace mpm
