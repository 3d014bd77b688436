#pragma once
#include <cmath>
#include <functional>

#include "libmpm/boundary/impact_wall.hpp"
#include "libmpm/boundary/mirror.hpp"
#include "libmpm/step/g2p.hpp"
#include "libmpm/step/grid_update.hpp"
#include "libmpm/step/p2g.hpp"

/// A neo-Hookean body under a body force, for manufactured solutions: the library's p2g, grid update and g2p
/// with a stress of its own,
///   sigma = (lambda ln J 1 + mu (F F^T - 1)) / J,   F <- (1 + dt L) F.
/// Density 1. Source: [Kamojjala2015, Eng. Comput. 31, 193].
struct NeoHookeanBody {
  double lambda, mu;  ///< [Pa]
  mpm::State state;
  std::vector<mpm::Vec2> initial;  ///< X of each particle
  std::vector<mpm::Mat2> deformation;

  NeoHookeanBody(double l, double m, mpm::Vec2 origin, double cell, int columns)
      : lambda(l), mu(m), state{{}, mpm::Grid(origin, {cell, cell}, columns), {}, 0, 0, mpm::Floor::mirror} {}

  double sound_speed() const { return std::sqrt(lambda + 2 * mu); }

  void add(mpm::Vec2 x, mpm::Vec2 velocity, double volume, double half) {
    state.particles.add(x, velocity, volume, volume, {half, half});
    initial.push_back(x);
    deformation.push_back(mpm::Mat2::Identity());
    state.velocity_gradient.push_back(mpm::Mat2::Zero());
  }

  /// One step under b(X, x, t) [N/kg]. `top`: row of a mirror there, or of any row above the body.
  template <class Shape>
  void step(double dt, int top, bool mirror_at_top,
            const std::function<mpm::Vec2(const mpm::Vec2&, const mpm::Vec2&, double)>& force) {
    mpm::Particles& ps = state.particles;
    mpm::Grid& grid = state.grid;
    if constexpr (requires { Shape::start(ps); }) Shape::start(ps);
    grid.grow_to_row(top + 1 + Shape::reach);
    grid.clear();
    mpm::p2g<Shape>(ps, grid);
    for (std::size_t p = 0; p < ps.size(); ++p) {
      const mpm::Vec2 b = ps.mass[p] * force(initial[p], ps.position[p], state.time);
      mpm::stencil_of<Shape>(grid, ps, p).for_each(grid, [&](mpm::Node& n, double w, const mpm::Vec2&) {
        n.acceleration += w * b;
      });
    }
    for (mpm::Node& n : grid.nodes()) n.own_mass = n.mass;
    mpm::reflect_sides(grid, top + Shape::reach);
    if (state.floor == mpm::Floor::mirror) mpm::reflect_floor(grid);
    if (mirror_at_top) reflect_top(top, Shape::reach);
    mpm::update_grid(grid, dt);
    if (state.floor == mpm::Floor::impact_wall) mpm::apply_impact_wall(grid, dt);
    mpm::g2p<Shape>(ps, grid, dt, state.velocity_gradient);
    for (std::size_t p = 0; p < ps.size(); ++p) {
      mpm::Mat2& f = deformation[p];
      f = (mpm::Mat2::Identity() + dt * state.velocity_gradient[p]) * f;
      const double jacobian = f(0, 0) * f(1, 1) - f(0, 1) * f(1, 0);
      const double mean = (lambda * std::log(jacobian) - mu) / jacobian, k = mu / jacobian;
      ps.dilation[p] = jacobian - 1;
      ps.deviator[p] = {mean + k * f.row(0).squaredNorm(), mean + k * f.row(1).squaredNorm(), 0,
                        k * f.row(0).dot(f.row(1))};  // the whole stress; the pressure stays 0
    }
    state.time += dt;
  }

 private:
  void reflect_top(int row, int reach) {
    const int ghosts = mpm::Grid::ghosts;
    const auto image = [](mpm::Vec2 v) { return mpm::Vec2(v.x(), -v.y()); };
    for (int i = -ghosts; i <= state.grid.columns() + ghosts; ++i) {
      for (int k = 1; k <= reach; ++k) {
        mpm::Node &inside = state.grid.at(i, row - k), &outside = state.grid.at(i, row + k);
        inside.mass += outside.mass;
        inside.velocity += image(outside.velocity);
        inside.acceleration += image(outside.acceleration);
        outside.mass = inside.mass;
        outside.velocity = image(inside.velocity);
        outside.acceleration = image(inside.acceleration);
      }
      state.grid.at(i, row).velocity.y() = state.grid.at(i, row).acceleration.y() = 0;
    }
  }
};
