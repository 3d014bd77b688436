#include "libmpm/verification/problems/elastic_bodies.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <vector>

#include "libmpm/verification/problems/neo_hookean_body.hpp"
#include "libmpm/verification/problems/with_shape.hpp"

namespace mpm::verification {
namespace {

/// Angular frequency of a vibration by the first and the last time at which its velocity turns from positive
/// to negative, a whole number of periods apart.
class Turns {
 public:
  void add(double t, double v) {
    if (last_v_ > 0 && v <= 0) {
      const double at = last_t_ + (t - last_t_) * last_v_ / (last_v_ - v);
      if (count_ == 0) first_ = at;
      latest_ = at;
      ++count_;
    }
    last_t_ = t, last_v_ = v;
  }
  double frequency() const { return 2 * std::numbers::pi * (count_ - 1) / (latest_ - first_); }

 private:
  double last_t_ = 0, last_v_ = 0, first_ = 0, latest_ = 0;
  int count_ = 0;
};

}  // namespace

BarMotion vibrate(mpm::ShapeFunction shape, int cells, int side) {
  const auto& exact = vibrating_bar;
  const double cell = exact.length / cells, share = cell / side, end = 2 * exact.period();
  const int rows = 2;
  const auto solid = exact::NeoHookean::of(exact.density, exact.youngs_modulus, 0);
  NeoHookeanBody bar(solid, {0, 0}, cell, cells + 4);
  for (int j = 0; j < rows * side; ++j)
    for (int i = 0; i < cells * side; ++i) {
      const double x = (i + 0.5) * share;
      bar.add({x, (j + 0.5) * share}, {exact.initial_velocity(x), 0}, share * share, share / 2);
    }
  const int steps = static_cast<int>(std::ceil(end * solid.longitudinal_speed() / (0.3 * cell)));
  return with_shape(shape, [&]<class Shape>() {
    bar.begin<Shape>({.ceiling = rows});
    const double mass = bar.mass();
    double square = 0;
    Turns turns;
    for (int k = 0; k < steps; ++k) {
      bar.step(end / steps);
      const double t = bar.time() - end / steps / 2;  // velocities belong to the middle of the step
      const double v = bar.momentum().x() / mass;
      square += std::pow((v - exact.mean_velocity(t)) / exact.largest_mean_velocity(), 2);
      turns.add(t, v);
    }
    return BarMotion{turns.frequency(), std::sqrt(square / steps)};
  });
}

Collision collide(mpm::ShapeFunction shape, int cells, int side) {
  constexpr double radius = 0.2, speed = 0.05, end = 5;
  const double cell = 1.0 / cells, share = cell / side, lift = cells / 4 * cell;
  const auto solid = exact::NeoHookean::of(1, 1, 0.3);
  NeoHookeanBody disks(solid, {0, -lift}, cell, cells);
  std::vector<double> way;
  for (int j = 0; j < cells * side; ++j)
    for (int i = 0; i < cells * side; ++i) {
      const mpm::Vec2 x((i + 0.5) * share, (j + 0.5) * share);
      for (const double w : {1.0, -1.0})
        if ((x - mpm::Vec2(0.5 - w * 0.2, 0.5 - w * 0.2)).norm() < radius) {
          disks.add(x, w * speed * mpm::Vec2(1, 1), share * share, share / 2);
          way.push_back(w);
        }
    }
  const double dt = 0.3 * cell / solid.longitudinal_speed();
  return with_shape(shape, [&]<class Shape>() {
    disks.begin<Shape>({});
    const double before = disks.kinetic_energy(), mass = disks.mass();
    Collision c{0, 0, 0, 1, 0};
    while (disks.time() < end) {
      disks.step(dt);
      const double kinetic = disks.kinetic_energy();
      c.least_kinetic = std::min(c.least_kinetic, kinetic / before);
      c.momentum_error = std::max(c.momentum_error, disks.momentum().norm() / std::sqrt(before * mass));
      c.energy_error = std::max(c.energy_error, std::abs((kinetic + disks.internal_energy()) / before - 1));
    }
    c.loss = 1 - (disks.kinetic_energy() + disks.strain_energy()) / before;
    const mpm::Particles& ps = disks.particles();
    for (std::size_t p = 0; p < way.size(); ++p)
      c.rebound -= way[p] * ps.mass[p] * ps.velocity[p].x() / speed / mass;
    return c;
  });
}

}  // namespace mpm::verification
