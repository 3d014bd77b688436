#pragma once
#include "libmpm/shape/shape.hpp"
#include "libmpm/step/p2g.hpp"
#include "libmpm/step/state.hpp"

namespace mpm {

/// Grid to particles, with the energy that belongs to it:
///   v_p += what the transfer gives,   x_p += dt sum w_ip v_i,   L_p = sum v_i (x) grad w_ip
///   m_p de_p = dt V_p sigma_p : sum (v_i - dt a_i/2) (x) grad w_ip
///            + m_p (heat of the transfer) + m_p sum w_ip h_i
/// v_i is the velocity at the end of the step, v_i - dt a_i/2 that in the middle. The first term of the heat
/// is the work of the very stress that made the forces, so that what the grid loses the particles receive.
/// The second is the kinetic energy that the transfer does not carry back (flip.hpp, flip_pic.hpp, apic.hpp),
/// left as heat where it was lost. The third is the heat of contact with the wall
/// (impact_wall.hpp). With all, the sum over the particles of m v^2/2 + m e is constant to rounding, whatever
/// the step and the shape function; for FLIP, a_p = sum w_ip a_i:
///   sum_p m_p (v_p . a_p dt + |a_p|^2 dt^2/2)  +  the second term  =  dt sum_i m_i a_i . (v_i - dt a_i/2)
/// Checked by tests/libmpm/step_test.cpp. Returns the second and third terms, summed [J/m]. In axisymmetry
///   L_zz = sum v_r,i h_ip / r_p   goes to hoop_rate, and sigma_zz times it, of the middle, joins the work.
/// `fields`: as in p2g.
template <ShapeFunctions Shape, class Transfer = Flip, class Space = space::PlaneStrain,
          class Fields = OneField>
double g2p(BasicParticles<Space::axes>& particles, const BasicGrid<Space::axes>& grid, double dt,
           std::vector<Mat<Space::axes>>& velocity_gradient, const Transfer& transfer = {},
           [[maybe_unused]] std::vector<double>* hoop_rate = nullptr, Fields fields = {}) {
  constexpr int axes = Space::axes;
  double transfer_heat = 0;
  for (std::size_t p = 0; p < particles.size(); ++p) {
    const auto stencil = stencil_of<Shape, Space>(grid, particles, p);
    typename Transfer::template Sums<axes> sums(particles, p, dt);
    Vec<axes> velocity = Vec<axes>::Zero();
    Mat<axes> gradient = Mat<axes>::Zero();
    double power = 0, contact = 0;
    [[maybe_unused]] double hoop_velocity = 0;
    const Tensor<axes> stress = particles.stress(p);
    [[maybe_unused]] const double inverse_radius = 1 / particles.position[p].x();
    stencil.for_each(
        grid, [&](const auto& at, double w, const Vec<axes>& g, [[maybe_unused]] double hoop = 0) {
          const auto& n = fields.node(at, p);
          sums.add(n, w, offset_of<Transfer>(grid, particles, p, at));
          velocity += w * n.velocity;
          gradient += n.velocity * g.transpose();
          power += product(stress, g).dot(n.velocity - 0.5 * dt * n.acceleration);
          contact += w * n.contact_heat;
          if constexpr (Space::has_hoop) {
            hoop_velocity += hoop * n.velocity.x();
            power += stress.zz * inverse_radius * hoop * (n.velocity.x() - 0.5 * dt * n.acceleration.x());
          }
        });
    const double work = dt * particles.volume(p) * power;
    const double heat = particles.mass[p] * (transfer.give(sums, particles, p, dt) + contact);
    particles.energy[p] += (work + heat) / particles.mass[p];
    particles.position[p] += dt * velocity;
    Shape::follow(grid, particles, p, Mat<axes>(dt * gradient));
    velocity_gradient[p] = gradient;
    if constexpr (Space::has_hoop) (*hoop_rate)[p] = hoop_velocity * inverse_radius;
    transfer_heat += heat;
  }
  return transfer_heat;
}

}  // namespace mpm
