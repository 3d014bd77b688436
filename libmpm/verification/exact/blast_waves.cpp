#include "libmpm/verification/exact/blast_waves.hpp"

#include <cmath>
#include <numbers>
#include <stdexcept>

#include "libmpm/verification/exact/powers.hpp"

namespace mpm::verification::exact {
namespace {

void check(const IdealGas& gas, int n) {
  if (n != 2 && n != 3) throw std::invalid_argument("a shock wave of a cylinder or a sphere: n = 2 or 3");
  if (!(gas.gamma > 1 && gas.density > 0))
    throw std::invalid_argument("an ideal gas: gamma above 1, density above 0");
}

/// Change with ln(radius) of a self-similar blast. With w = velocity - radius and c^2 = gamma P / G:
///   mass      w G' + G (U' + (n - 1) U / x) = 0
///   momentum  w U' + P' / G = n U / 2              (D falls as R^(-n/2))
///   entropy   w (P' / P - gamma G' / G) = n
BlastPoint slope(double gamma, int n, const BlastPoint& at) {
  const double x = at.radius, u = at.velocity, g = at.density, p = at.pressure;
  const double w = u - x, sound = gamma * p / g, spread = (n - 1) * u / x;
  const double du = (n * u * w / 2 - n * p / g + sound * spread) / (w * w - sound);
  const double dg = -g * (du + spread) / w;
  const double dp = p * (n / w + gamma * dg / g);
  return {x, x * du, x * dg, x * dp};
}

BlastPoint moved(const BlastPoint& a, const BlastPoint& k, double h) {
  return {a.radius + h * k.radius, a.velocity + h * k.velocity, a.density + h * k.density,
          a.pressure + h * k.pressure};
}

BlastPoint step(double gamma, int n, const BlastPoint& at, double h) {
  const BlastPoint k1 = slope(gamma, n, at), k2 = slope(gamma, n, moved(at, k1, h / 2));
  const BlastPoint k3 = slope(gamma, n, moved(at, k2, h / 2)), k4 = slope(gamma, n, moved(at, k3, h));
  return moved(moved(moved(moved(at, k1, h / 6), k2, h / 3), k3, h / 3), k4, h / 6);
}

}  // namespace

NohShock noh_shock(const IdealGas& gas, int n, double inward_speed) {
  check(gas, n);
  if (!(inward_speed > 0)) throw std::invalid_argument("a flow inwards: speed above 0");
  const double density = gas.density * std::pow((gas.gamma + 1) / (gas.gamma - 1), n);
  return {(gas.gamma - 1) / 2 * inward_speed, density, (gas.gamma - 1) * density * square(inward_speed) / 2};
}

SedovBlast::SedovBlast(const IdealGas& gas, int n) : gas_(gas), n_(n) {
  check(gas, n);
  const double strong = 2 / (gas.gamma + 1);
  BlastPoint at{1, strong, (gas.gamma + 1) / (gas.gamma - 1), strong};
  // of the energy: kinetic and internal, over rho0 D^2 R^n and the angle
  const auto energy = [&](const BlastPoint& b) {
    return (b.density * square(b.velocity) / 2 + b.pressure / (gas.gamma - 1)) * std::pow(b.radius, n);
  };
  constexpr int steps = 40000;
  const double h = std::log(1e-3) / steps;
  double sum = 0;
  for (int k = 0; k < steps; ++k) {  // Simpson
    const BlastPoint middle = step(gas.gamma, n, at, h / 2), end = step(gas.gamma, n, middle, h / 2);
    sum -= h / 6 * (energy(at) + 4 * energy(middle) + energy(end));
    at = end;
  }
  sum += energy(at) / n;  // the rest is at rest, at one pressure
  const double angle = (n == 2 ? 2 : 4) * std::numbers::pi;
  alpha_ = square(2.0 / (n + 2)) * angle * sum;
}

double SedovBlast::shock_radius(double energy, double time) const {
  return std::pow(energy * square(time) / (alpha_ * gas_.density), 1.0 / (n_ + 2));
}
double SedovBlast::shock_speed(double energy, double time) const {
  return 2 * shock_radius(energy, time) / ((n_ + 2) * time);
}
double SedovBlast::peak_pressure(double energy, double time) const {
  return 2 / (gas_.gamma + 1) * gas_.density * square(shock_speed(energy, time));
}

}  // namespace mpm::verification::exact
