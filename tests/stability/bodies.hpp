#pragma once
/// Bodies made by hand, for cases that no study describes.
#include <string>

#include "libmpm/scene/build.hpp"
#include "tests/stability/case.hpp"

namespace stability {

inline constexpr double um = 1e-6, ns = 1e-9;

/// A scene whose body is made by hand: it lends material, numerics and times.
mpm::Scene frame(double speed, double cell, double end_time);

/// Nothing yet: a grid from `low`, `columns` cells wide.
mpm::State nothing(mpm::Vec2 low, mpm::Vec2 cell, int columns);

inline bool everywhere(const mpm::Vec2&) { return true; }

/// Adds the lattice points, side x side per cell, of [low, low + size] that `inside` takes.
template <class Inside, class Velocity>
void fill(mpm::State& s, const mpm::Scene& scene, mpm::Vec2 low, mpm::Vec2 size, int side,
          const Inside& inside, const Velocity& velocity) {
  const mpm::Vec2 share = s.grid.cell() / side;
  const double volume = share.x() * share.y();
  for (double y = low.y() + 0.5 * share.y(); y < low.y() + size.y(); y += share.y())
    for (double x = low.x() + 0.5 * share.x(); x < low.x() + size.x(); x += share.x())
      if (const mpm::Vec2 at(x, y); inside(at))
        s.particles.add(at, velocity(at), scene.material.reference_density * volume, volume, 0.5 * share);
  s.velocity_gradient.assign(s.particles.size(), mpm::Mat2::Zero());
}

/// To the scene's end, where it leaves the state.
mpm::RunResult go(const mpm::Scene&, mpm::State&);

/// The run held, and so did what the case asks beside it.
Outcome also(Outcome, bool fine, const std::string& note);

/// "what value"
std::string text(const std::string& what, double value);

}  // namespace stability
