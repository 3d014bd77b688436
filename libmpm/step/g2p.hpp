#pragma once
#include "libmpm/shape/shape.hpp"
#include "libmpm/step/state.hpp"

namespace mpm {

/// Grid to particles (FLIP), with the energy that belongs to it:
///   a_p = sum w_ip a_i,   v_p += dt a_p,   x_p += dt sum w_ip v_i,   L_p = sum v_i (x) grad w_ip
///   m_p de_p = dt V_p sigma_p : sum (v_i - dt a_i/2) (x) grad w_ip
///            + (dt^2/2) m_p (sum w_ip |a_i|^2 - |a_p|^2) + m_p sum w_ip h_i
/// v_i is the velocity at the end of the step, v_i - dt a_i/2 that in the middle. The first term of the heat
/// is the work of the very stress that made the forces, so that what the grid loses the particles receive.
/// The second is the kinetic energy that FLIP does not carry back: the variance of the acceleration over the
/// particle's nodes, never negative, left as heat where it was lost. The third is the heat of contact with
/// the wall (impact_wall.hpp). With all, the sum over the particles of m v^2/2 + m e is constant to rounding,
/// whatever the step and the shape function:
///   sum_p m_p (v_p . a_p dt + |a_p|^2 dt^2/2)  +  the second term  =  dt sum_i m_i a_i . (v_i - dt a_i/2)
/// Checked by tests/libmpm/step_test.cpp. Returns the second and third terms, summed [J/m].
template <ShapeFunctions Shape>
double g2p(Particles& particles, const Grid& grid, double dt, std::vector<Mat2>& velocity_gradient) {
  double transfer_heat = 0;
  for (std::size_t p = 0; p < particles.size(); ++p) {
    const Stencil n = stencil_at<Shape>(grid, particles.position[p], particles.half_size[p]);
    Vec2 acceleration = Vec2::Zero(), velocity = Vec2::Zero();
    Mat2 gradient = Mat2::Zero();
    double power = 0, square = 0, contact = 0;
    const PlaneTensor stress = particles.stress(p);
    for (int j = 0; j < 3; ++j) {
      const Node* row = &grid.at(n.x.first, n.y.first + j);
      for (int i = 0; i < 3; ++i) {
        const double w = n.weight(i, j);
        const Vec2 g = n.gradient(i, j, grid.inverse_cell());
        acceleration += w * row[i].acceleration;
        velocity += w * row[i].velocity;
        gradient += row[i].velocity * g.transpose();
        const Vec2 traction(stress.xx * g.x() + stress.xy * g.y(), stress.xy * g.x() + stress.yy * g.y());
        power += traction.dot(row[i].velocity - 0.5 * dt * row[i].acceleration);
        contact += w * row[i].contact_heat;
        square += w * row[i].acceleration.squaredNorm();
      }
    }
    const double work = dt * particles.volume(p) * power;
    const double heat = particles.mass[p] * (0.5 * dt * dt * (square - acceleration.squaredNorm()) + contact);
    particles.energy[p] += (work + heat) / particles.mass[p];
    particles.velocity[p] += dt * acceleration;
    particles.position[p] += dt * velocity;
    if (Shape::domains_follow_stretch) {
      particles.half_size[p].x() *= 1 + dt * gradient(0, 0);
      particles.half_size[p].y() *= 1 + dt * gradient(1, 1);
    }
    velocity_gradient[p] = gradient;
    transfer_heat += heat;
  }
  return transfer_heat;
}

}  // namespace mpm
