#pragma once
/// Elastic bodies for exact problems whose material is not that of the scenes: the library's p2g, grid update
/// and g2p with a neo-Hookean stress, under a body force.
#include <cmath>
#include <cstddef>
#include <vector>

#include "libmpm/boundary/mirror.hpp"
#include "libmpm/exact/neo_hookean.hpp"
#include "libmpm/step/g2p.hpp"
#include "libmpm/step/grid_update.hpp"
#include "libmpm/step/p2g.hpp"

namespace mpmstudy {

/// For bodies that nothing drives.
inline mpm::Vec2 no_force(const mpm::Vec2& /*initial*/, double /*t*/) { return {0, 0}; }

/// The body's particles carry F <- (1 + dt L) F, and the stress
///   sigma = (lambda ln J 1 + mu (F F^T - 1)) / J.
/// Cells are squares. A body that is not between mirrors must stay two cells clear of the grid's sides.
class NeoHookeanBody {
 public:
  NeoHookeanBody(const mpm::exact::NeoHookean& solid, mpm::Vec2 origin, double cell, int columns)
      : solid_(solid), state_{{}, mpm::Grid(origin, {cell, cell}, columns), {}, 0, 0, mpm::Floor::mirror} {}

  /// A particle at rest density: volume [m^2] and half of its edge [m].
  void add(const mpm::Vec2& x, const mpm::Vec2& velocity, double volume, double half) {
    state_.particles.add(x, velocity, solid_.density * volume, volume, {half, half});
    initial_.push_back(x);
    deformation_.push_back(mpm::Mat2::Identity());
    state_.velocity_gradient.push_back(mpm::Mat2::Zero());
  }

  const mpm::exact::NeoHookean& solid() const { return solid_; }
  const mpm::Particles& particles() const { return state_.particles; }
  const mpm::Grid& grid() const { return state_.grid; }
  const std::vector<mpm::Vec2>& initial() const { return initial_; }  ///< X of each particle [m]
  double time() const { return state_.time; }                         ///< [s]

  /// One step under the body force b(X, t) [N/kg] of the particle that began at X. `top`: row of a mirror
  /// there, or of any row above the body.
  template <class Shape, class Transfer = mpm::Flip, class Force>
  void step(double dt, int top, bool mirror_at_top, const Force& force, const Transfer& transfer = {}) {
    mpm::Particles& ps = state_.particles;
    mpm::Grid& grid = state_.grid;
    if constexpr (requires { Shape::start(ps); }) Shape::start(ps);
    grid.grow_to_row(top + 1 + Shape::reach);
    grid.clear();
    mpm::p2g<Shape, Transfer>(ps, grid);
    for (std::size_t p = 0; p < ps.size(); ++p) {
      const mpm::Vec2 b = ps.mass[p] * force(initial_[p], state_.time);
      mpm::stencil_of<Shape>(grid, ps, p).for_each(grid, [&](mpm::Node& n, double w, const mpm::Vec2&) {
        n.acceleration += w * b;
      });
    }
    for (mpm::Node& n : grid.nodes()) n.own_mass = n.mass;
    mpm::reflect_sides(grid, top + Shape::reach);
    mpm::reflect_floor(grid);
    if (mirror_at_top) mpm::reflect_row(grid, top, Shape::reach);
    mpm::update_grid(grid, dt);
    mpm::g2p<Shape>(ps, grid, dt, state_.velocity_gradient, transfer);
    for (std::size_t p = 0; p < ps.size(); ++p) update_stress(p, dt);
    state_.time += dt;
  }

  double mass() const {  ///< [kg/m]
    double sum = 0;
    for (const double m : state_.particles.mass) sum += m;
    return sum;
  }
  mpm::Vec2 momentum() const {  ///< [kg/s]
    mpm::Vec2 sum(0, 0);
    for (std::size_t p = 0; p < initial_.size(); ++p)
      sum += state_.particles.mass[p] * state_.particles.velocity[p];
    return sum;
  }
  double kinetic_energy() const {  ///< [J/m]
    double sum = 0;
    for (std::size_t p = 0; p < initial_.size(); ++p)
      sum += state_.particles.mass[p] * state_.particles.velocity[p].squaredNorm() / 2;
    return sum;
  }
  double strain_energy() const {  ///< of the deformation, by the solid's W [J/m]
    double sum = 0;
    for (std::size_t p = 0; p < initial_.size(); ++p) {
      const mpm::Mat2& f = deformation_[p];
      sum += state_.particles.initial_volume[p] * solid_.strain_energy(f(0, 0), f(0, 1), f(1, 0), f(1, 1));
    }
    return sum;
  }
  double internal_energy() const {  ///< what the stress did, and the heat of the transfer [J/m]
    double sum = 0;
    for (std::size_t p = 0; p < initial_.size(); ++p)
      sum += state_.particles.mass[p] * state_.particles.energy[p];
    return sum;
  }

 private:
  void update_stress(std::size_t p, double dt) {
    mpm::Mat2& f = deformation_[p];
    f = (mpm::Mat2::Identity() + dt * state_.velocity_gradient[p]) * f;
    const double jacobian = f(0, 0) * f(1, 1) - f(0, 1) * f(1, 0);
    const double mean = (solid_.lambda * std::log(jacobian) - solid_.mu) / jacobian;
    const double k = solid_.mu / jacobian;
    state_.particles.dilation[p] = jacobian - 1;
    // The whole stress; the pressure stays 0.
    state_.particles.deviator[p] = {mean + k * f.row(0).squaredNorm(), mean + k * f.row(1).squaredNorm(), 0,
                                    k * f.row(0).dot(f.row(1))};
  }

  mpm::exact::NeoHookean solid_;
  mpm::State state_;
  std::vector<mpm::Vec2> initial_;
  std::vector<mpm::Mat2> deformation_;
};

}  // namespace mpmstudy
