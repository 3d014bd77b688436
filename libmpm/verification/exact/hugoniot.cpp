#include "libmpm/verification/exact/hugoniot.hpp"

#include <cmath>
#include <stdexcept>
#include <string>

#include "libmpm/verification/exact/root.hpp"

namespace mpm::verification::exact {
namespace {

constexpr int steps = 2000;  // of fourth order: nine digits are left of a smooth integrand

/// T at x = V0 - V on the Hugoniot, by classical Runge-Kutta from (0, T0).
double hugoniot_temperature(const MieGruneisenFluid& fluid, double end) {
  const double v0 = 1 / fluid.density;
  const auto rate = [&](double x, double t) {
    const double mu = x / (v0 - x);
    const double dmu_dx = v0 / ((v0 - x) * (v0 - x));
    const double p = fluid.hugoniot_pressure(mu);
    const double dp_dx = fluid.hugoniot_pressure_slope(mu) * dmu_dx;
    return (x * dp_dx - p) / (2 * fluid.specific_heat) + fluid.gamma * fluid.density * t;
  };
  const double h = end / steps;
  double t = fluid.temperature;
  for (int i = 0; i < steps; ++i) {
    const double x = i * h;
    const double k1 = rate(x, t), k2 = rate(x + h / 2, t + h / 2 * k1);
    const double k3 = rate(x + h / 2, t + h / 2 * k2), k4 = rate(x + h, t + h * k3);
    t += h / 6 * (k1 + 2 * k2 + 2 * k3 + k4);
  }
  return t;
}

/// A point of the release path: V is the variable, energy and speed follow.
struct Point {
  double volume, energy, speed;
};

Point release_step(const MieGruneisenFluid& fluid, const Point& at, double h) {
  struct Rate {
    double energy, speed;
  };
  const auto rate = [&](double v, double e) {
    const double p = fluid.pressure(1 / v, e);
    const double slope = fluid.pressure_slope(1 / v) - p * fluid.gamma * fluid.density;
    return Rate{-p, std::sqrt(-slope)};
  };
  const Rate k1 = rate(at.volume, at.energy);
  const Rate k2 = rate(at.volume + h / 2, at.energy + h / 2 * k1.energy);
  const Rate k3 = rate(at.volume + h / 2, at.energy + h / 2 * k2.energy);
  const Rate k4 = rate(at.volume + h, at.energy + h * k3.energy);
  return {at.volume + h, at.energy + h / 6 * (k1.energy + 2 * k2.energy + 2 * k3.energy + k4.energy),
          at.speed + h / 6 * (k1.speed + 2 * k2.speed + 2 * k3.speed + k4.speed)};
}

}  // namespace

double MieGruneisenFluid::hugoniot_pressure(double mu) const {
  const double c = density * sound_speed * sound_speed;
  return c * mu * (1 + mu * ((2 * slope - 1) + mu * (slope - 1) * (3 * slope - 1)));
}

double MieGruneisenFluid::hugoniot_pressure_slope(double mu) const {
  const double c = density * sound_speed * sound_speed;
  return c * (1 + mu * (2 * (2 * slope - 1) + 3 * mu * (slope - 1) * (3 * slope - 1)));
}

double MieGruneisenFluid::pressure(double density_now, double energy) const {
  const double mu = density_now / density - 1;
  const double eta = 1 - density / density_now;
  return hugoniot_pressure(mu) * (1 - gamma * eta / 2) + gamma * density * energy;
}

double MieGruneisenFluid::pressure_slope(double density_now) const {
  // dmu/dV = -rho^2 / rho0, deta/dV = -rho0
  const double mu = density_now / density - 1;
  const double eta = 1 - density / density_now;
  return -hugoniot_pressure_slope(mu) * (1 - gamma * eta / 2) * density_now * density_now / density +
         hugoniot_pressure(mu) * gamma * density / 2;
}

HugoniotState hugoniot(const MieGruneisenFluid& fluid, double particle_speed) {
  if (!(particle_speed > 0)) throw std::invalid_argument("hugoniot: particle speed must be positive");
  const double momentum = fluid.density * particle_speed * particle_speed;
  const auto excess = [&](double eta) { return fluid.hugoniot_pressure(eta / (1 - eta)) * eta - momentum; };
  const double eta = bisect(excess, 0, 1);
  if (!(fluid.gamma * eta < 2))
    throw std::invalid_argument("hugoniot: particle speed beyond the range of the EOS");
  HugoniotState state{};
  state.particle_speed = particle_speed;
  state.compression = eta / (1 - eta);
  state.density = fluid.density / (1 - eta);
  state.pressure = fluid.hugoniot_pressure(state.compression);
  state.shock_speed = particle_speed / eta;
  state.specific_energy = state.pressure * eta / (2 * fluid.density);
  state.temperature = hugoniot_temperature(fluid, eta / fluid.density);
  return state;
}

Release isentropic_release(const MieGruneisenFluid& fluid, const HugoniotState& shocked) {
  Point at{1 / shocked.density, shocked.specific_energy, shocked.particle_speed};
  const double h = (1 / fluid.density - at.volume) / steps;
  const auto tension = [&](const Point& p) { return -fluid.pressure(1 / p.volume, p.energy); };
  for (Point next = release_step(fluid, at, h); tension(next) < 0; next = release_step(fluid, at, h))
    at = next;
  const double last = bisect([&](double step) { return tension(release_step(fluid, at, step)); }, 0, h);
  at = release_step(fluid, at, last);
  return {at.speed, 1 / at.volume, at.energy};
}

}  // namespace mpm::verification::exact
