#include "libmpm/verification/exact/axis_aligned.hpp"

#include <cmath>
#include <numbers>

namespace mpm::verification::exact {
namespace {
constexpr double pi = std::numbers::pi;
double wave_speed(const NeoHookean& solid) { return std::sqrt(solid.youngs_modulus() / solid.density); }
}  // namespace

double AxisAligned::period() const { return 2 / wave_speed(solid); }

Vector AxisAligned::position(Vector initial, double t) const {
  const double a = amplitude * std::sin(wave_speed(solid) * pi * t);
  return {initial.x + a * std::sin(pi * initial.x), initial.y - a * std::sin(pi * initial.y)};
}

Vector AxisAligned::velocity(Vector initial, double t) const {
  const double c = wave_speed(solid), rate = amplitude * c * pi * std::cos(c * pi * t);
  return {rate * std::sin(pi * initial.x), -rate * std::sin(pi * initial.y)};
}

Vector AxisAligned::body_force(Vector initial, double t) const {
  const double a = amplitude * std::sin(wave_speed(solid) * pi * t);
  const double fx = 1 + pi * a * std::cos(pi * initial.x), fy = 1 - pi * a * std::cos(pi * initial.y);
  const double log_jacobian = std::log(fx * fy), young = solid.youngs_modulus();
  const auto along = [&](double u, double f) {
    return pi * pi * u / solid.density *
           (solid.lambda * (1 - log_jacobian) / (f * f) + solid.mu * (1 + 1 / (f * f)) - young);
  };
  return {along(a * std::sin(pi * initial.x), fx), along(-a * std::sin(pi * initial.y), fy)};
}

}  // namespace mpm::verification::exact
