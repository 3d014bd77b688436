#include "libmpm/verification/exact/standing_waves.hpp"

#include <cmath>
#include <cstddef>
#include <numbers>

namespace mpm::verification::exact {
namespace {

constexpr double pi_ = std::numbers::pi;
constexpr std::array<double, 3> cube_weights = {1, -1, 0.5};
constexpr std::array<double, 2> cylinder_weights = {1, -1};

double bar_speed(const NeoHookean& solid) { return std::sqrt(solid.youngs_modulus() / solid.density); }
double phase(const NeoHookean& solid, double t) { return bar_speed(solid) * pi_ * t; }

template <std::size_t axes>
std::array<double, axes> moved(const std::array<double, axes>& x, const std::array<double, axes>& weights,
                               double amplitude) {
  std::array<double, axes> moved = x;
  for (std::size_t i = 0; i < axes; ++i) moved[i] += weights[i] * amplitude * std::sin(pi_ * x[i]);
  return moved;
}
/// Less where it was.
template <std::size_t axes>
std::array<double, axes> wave(const std::array<double, axes>& x, const std::array<double, axes>& weights,
                              double amplitude) {
  std::array<double, axes> wave;
  for (std::size_t i = 0; i < axes; ++i) wave[i] = weights[i] * amplitude * std::sin(pi_ * x[i]);
  return wave;
}

/// dP/dX along an axis where u = a sin(pi X), apart from what other stretches do to ln J.
double slope_of_stress(const NeoHookean& s, double u, double f, double log_jacobian) {
  return -pi_ * pi_ * u * (s.lambda * (1 - log_jacobian) / (f * f) + s.mu * (1 + 1 / (f * f)));
}
double stress(const NeoHookean& s, double f, double log_jacobian) {
  return s.lambda * log_jacobian / f + s.mu * (f - 1 / f);
}

}  // namespace

double CubeWaves::period() const { return 2 / bar_speed(solid); }
double CylinderWaves::period() const { return 2 / bar_speed(solid); }

CubeWaves::Point CubeWaves::position(const Point& initial, double t) const {
  return moved(initial, cube_weights, amplitude * std::sin(phase(solid, t)));
}
CylinderWaves::Point CylinderWaves::position(const Point& initial, double t) const {
  return moved(initial, cylinder_weights, amplitude * std::sin(phase(solid, t)));
}

CubeWaves::Point CubeWaves::velocity(const Point& initial, double t) const {
  return wave(initial, cube_weights, amplitude * bar_speed(solid) * pi_ * std::cos(phase(solid, t)));
}
CylinderWaves::Point CylinderWaves::velocity(const Point& initial, double t) const {
  return wave(initial, cylinder_weights, amplitude * bar_speed(solid) * pi_ * std::cos(phase(solid, t)));
}

CubeWaves::Point CubeWaves::body_force(const Point& initial, double t) const {
  const double a = amplitude * std::sin(phase(solid, t));
  const Point u = wave(initial, cube_weights, a);
  Point f, force;
  double log_jacobian = 0;
  for (std::size_t i = 0; i < 3; ++i) {
    f[i] = 1 + cube_weights[i] * a * pi_ * std::cos(pi_ * initial[i]);
    log_jacobian += std::log(f[i]);
  }
  for (std::size_t i = 0; i < 3; ++i)
    force[i] =
        (-pi_ * pi_ * solid.youngs_modulus() * u[i] - slope_of_stress(solid, u[i], f[i], log_jacobian)) /
        solid.density;
  return force;
}

CylinderWaves::Point CylinderWaves::body_force(const Point& initial, double t) const {
  const double a = amplitude * std::sin(phase(solid, t)), radius = initial[0];
  const Point u = wave(initial, cylinder_weights, a);
  const double radial = 1 + a * pi_ * std::cos(pi_ * radius), hoop = 1 + u[0] / radius;
  const double axial = 1 - a * pi_ * std::cos(pi_ * initial[1]);
  const double log_jacobian = std::log(radial * hoop * axial);
  const double hoop_slope = (radial - hoop) / radius;  // of 1 + u/R
  const double radial_force =
      slope_of_stress(solid, u[0], radial, log_jacobian) + solid.lambda * hoop_slope / (hoop * radial) +
      (stress(solid, radial, log_jacobian) - stress(solid, hoop, log_jacobian)) / radius;
  const double inertia = -pi_ * pi_ * solid.youngs_modulus();
  return {(inertia * u[0] - radial_force) / solid.density,
          (inertia * u[1] - slope_of_stress(solid, u[1], axial, log_jacobian)) / solid.density};
}

}  // namespace mpm::verification::exact
