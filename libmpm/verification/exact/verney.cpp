#include "libmpm/verification/exact/verney.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <stdexcept>

#include "libmpm/verification/exact/powers.hpp"
#include "libmpm/verification/exact/root.hpp"

namespace mpm::verification::exact {
namespace {

constexpr double sqrt3 = std::numbers::sqrt3;

void check(const ImplodingShell& shell) {
  if (!(shell.inner_radius > 0 && shell.outer_radius > shell.inner_radius))
    throw std::invalid_argument("imploding shell: radii must be 0 < inner < outer");
  if (!(shell.density > 0 && shell.yield_stress >= 0 && shell.hardening >= 0))
    throw std::invalid_argument(
        "imploding shell: density must be positive, yield stress and hardening not negative");
}

/// x ln x, continued by its limit at 0. Here x = (r/a0)^2: F is the same in any unit of length, times a0^2.
double x_log_x(double x) { return x > 0 ? x * std::log(x) : 0; }

/// integral_a^b f(r) dr / r, by 8-point Gauss-Legendre on panels in ln r.
template <class Function>
double logarithmic_integral(double a, double b, Function f) {
  static constexpr std::array<double, 4> node = {0.1834346424956498, 0.5255324099163290, 0.7966664774136267,
                                                 0.9602898564975363};
  static constexpr std::array<double, 4> weight = {0.3626837833783620, 0.3137066458778873, 0.2223810344533745,
                                                   0.1012285362903763};
  const double length = std::log(b / a);
  const int panels = 1 + static_cast<int>(length);
  const double half = length / (2 * panels);
  double sum = 0;
  for (int p = 0; p < panels; ++p) {
    const double middle = (2 * p + 1) * half;
    for (std::size_t i = 0; i < node.size(); ++i)
      for (const double s : {-half * node[i], half * node[i]})
        sum += half * weight[i] * f(a * std::exp(middle + s));
  }
  return sum;
}

struct Motion {
  double radius;  ///< a [m]
  double flux;    ///< A = a da/dt [m^2/s], of a sphere a^2 da/dt [m^3/s]
};

Motion rate(const ImplodingShell& shell, const Motion& m) {
  const double b = outer_radius(shell, m.radius), flux_square = square(m.flux);
  if (shell.spherical) {
    const double c = cube(shell.inner_radius) - cube(m.radius);
    const double strains =
        logarithmic_integral(m.radius, b, [=](double r) { return 2.0 / 3 * std::log1p(c / cube(r)); });
    const double resistance = 2 * (shell.yield_stress * std::log(b / m.radius) + shell.hardening * strains);
    const double inertia = flux_square / 2 * (1 / square(square(m.radius)) - 1 / square(square(b)));
    return {m.flux / square(m.radius), (resistance / shell.density + inertia) / (1 / m.radius - 1 / b)};
  }
  const double c = square(shell.inner_radius) - square(m.radius);
  const double strains =
      logarithmic_integral(m.radius, b, [=](double r) { return std::log1p(c / square(r)); });
  const double thickness = std::log(b / m.radius);
  const double resistance = 2 / sqrt3 * (shell.yield_stress * thickness + shell.hardening / sqrt3 * strains);
  const double inertia = flux_square / 2 * (1 / square(m.radius) - 1 / square(b));
  return {m.flux / m.radius, (resistance / shell.density + inertia) / thickness};
}

Motion step(const ImplodingShell& shell, const Motion& m, double h) {
  const auto moved = [&](const Motion& k, double f) {
    return Motion{m.radius + f * k.radius, m.flux + f * k.flux};
  };
  const Motion k1 = rate(shell, m), k2 = rate(shell, moved(k1, h / 2));
  const Motion k3 = rate(shell, moved(k2, h / 2)), k4 = rate(shell, moved(k3, h));
  return {m.radius + h / 6 * (k1.radius + 2 * k2.radius + 2 * k3.radius + k4.radius),
          m.flux + h / 6 * (k1.flux + 2 * k2.flux + 2 * k3.flux + k4.flux)};
}

}  // namespace

double outer_radius(const ImplodingShell& shell, double inner_radius) {
  if (shell.spherical)
    return std::cbrt(cube(shell.outer_radius) - cube(shell.inner_radius) + cube(inner_radius));
  return std::sqrt(square(shell.outer_radius) - square(shell.inner_radius) + square(inner_radius));
}

double verney_speed(const ImplodingShell& shell, double stop_radius) {
  check(shell);
  if (shell.hardening != 0) throw std::invalid_argument("verney_speed: exact without hardening only");
  if (!(stop_radius >= 0 && stop_radius <= shell.inner_radius))
    throw std::invalid_argument("verney_speed: stop radius must lie within the initial inner radius");
  if (shell.spherical) {
    const double q = shell.outer_radius / shell.inner_radius, c = cube(q) - 1;
    // below the thousandth part of the first radius nothing is left to be added
    const double from = std::max(stop_radius / shell.inner_radius, 1e-3);
    const double f =
        logarithmic_integral(from, 1, [=](double x) { return cube(x) * std::log1p(c / cube(x)); });
    return std::sqrt(4.0 / 3 * shell.yield_stress * q * f / (shell.density * (q - 1)));
  }
  const double a = square(stop_radius / shell.inner_radius);
  const double b0 = square(shell.outer_radius / shell.inner_radius);
  const double f = x_log_x(b0) - x_log_x(b0 - 1 + a) + x_log_x(a);
  return std::sqrt(shell.yield_stress / sqrt3 * f / (shell.density * std::log(b0) / 2));
}

double verney_stop_radius(const ImplodingShell& shell, double inner_speed) {
  if (verney_speed(shell, 0) <= inner_speed) return 0;
  const auto slower = [&](double a) { return inner_speed - verney_speed(shell, a); };
  return bisect(slower, 0, shell.inner_radius);
}

ShellStop verney_stop(const ImplodingShell& shell, double inner_speed) {
  check(shell);
  if (!(inner_speed > 0)) throw std::invalid_argument("verney_stop: speed must be positive");
  const double a0 = shell.inner_radius;
  Motion m{a0, -inner_speed * (shell.spherical ? square(a0) : a0)};
  double time = 0;
  // A step moves the radius, or what is left of the flux, by a thousandth at most.
  while (m.radius > shell.inner_radius / 1000) {
    const double h = std::min(-m.radius / rate(shell, m).radius, a0 / inner_speed) / 1000;
    const Motion next = step(shell, m, h);
    if (next.flux >= 0) {
      const double part = bisect([&](double f) { return step(shell, m, f * h).flux; }, 0, 1);
      return {false, step(shell, m, part * h).radius, time + part * h};
    }
    m = next;
    time += h;
  }
  return {true, m.radius, time};
}

double pore_collapse_pressure(double yield_stress, double area_fraction) {
  if (!(area_fraction > 0 && area_fraction < 1))
    throw std::invalid_argument("pore_collapse_pressure: area fraction must be between 0 and 1");
  return yield_stress / sqrt3 * -std::log(area_fraction);
}

double lone_pore_collapse_pressure(double yield_stress, double shear_modulus) {
  return yield_stress / sqrt3 * (1 + std::log(sqrt3 * shear_modulus / yield_stress));
}

double pore_first_yield_pressure(double yield_stress) { return yield_stress / sqrt3; }

}  // namespace mpm::verification::exact
