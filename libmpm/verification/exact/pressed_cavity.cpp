#include "libmpm/verification/exact/pressed_cavity.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "libmpm/verification/exact/powers.hpp"
#include "libmpm/verification/exact/root.hpp"

namespace mpm::verification::exact {
namespace {

struct Motion {
  double radius, speed;
};

Motion rate(const PressedCavity& c, double pressure, const Motion& m) {
  const double drive = (holding_pressure(c, std::min(m.radius, c.radius)) - pressure) / c.density;
  return {m.speed, (drive - 1.5 * square(m.speed)) / m.radius};
}

Motion step(const PressedCavity& c, double pressure, const Motion& m, double h) {
  const auto moved = [&](const Motion& k, double f) {
    return Motion{m.radius + f * k.radius, m.speed + f * k.speed};
  };
  const Motion k1 = rate(c, pressure, m), k2 = rate(c, pressure, moved(k1, h / 2));
  const Motion k3 = rate(c, pressure, moved(k2, h / 2)), k4 = rate(c, pressure, moved(k3, h));
  return {m.radius + h / 6 * (k1.radius + 2 * k2.radius + 2 * k3.radius + k4.radius),
          m.speed + h / 6 * (k1.speed + 2 * k2.speed + 2 * k3.speed + k4.speed)};
}

/// Up to a turn, or to that radius.
CavityStop follow(const PressedCavity& c, double pressure, double to) {
  const double slowest = std::sqrt(c.density / pressure) * c.radius;
  // the cavity yields after a way of Y / (6 G) of its radius: the first steps resolve it
  const double first = std::sqrt(c.yield_stress / c.shear_modulus) * slowest;
  Motion m{c.radius, 0};
  double time = 0;
  while (m.radius > to) {
    const double fall = m.speed < 0 ? -m.radius / m.speed : first;
    const double h = std::min({fall, slowest, first + time}) / 1000;
    const Motion next = step(c, pressure, m, h);
    const auto part_where = [&](auto reached) {
      return bisect([&](double f) { return reached(step(c, pressure, m, f * h)) ? 1 : -1; }, 0, 1) * h;
    };
    if (time > 0 && next.speed >= 0) {
      const double part = part_where([](const Motion& at) { return at.speed >= 0; });
      return {false, step(c, pressure, m, part).radius, time + part};
    }
    if (next.radius <= to) {
      const double part = part_where([&](const Motion& at) { return at.radius <= to; });
      return {true, to, time + part};
    }
    m = next;
    time += h;
  }
  return {true, m.radius, time};
}

}  // namespace

double holding_pressure(const PressedCavity& c, double radius) {
  const double w = cube(c.radius / radius) - 1, yields = c.yield_stress / (2 * c.shear_modulus);
  if (w <= yields) return 4.0 / 3 * c.shear_modulus * w;
  return 2.0 / 3 * c.yield_stress * (1 + std::log(w / yields));
}

double closing_pressure(const PressedCavity& c) {
  return 2.0 / 3 * c.yield_stress * (1 + std::log(2 * c.shear_modulus / c.yield_stress));
}

CavityStop pressed_cavity_stop(const PressedCavity& c, double far_pressure) {
  return follow(c, far_pressure, c.radius / 1000);
}

double pressed_cavity_time(const PressedCavity& c, double far_pressure, double radius) {
  const CavityStop stop = follow(c, far_pressure, radius);
  return stop.closes ? stop.time : std::numeric_limits<double>::infinity();
}

}  // namespace mpm::verification::exact
