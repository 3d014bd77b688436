#include "libmpm/verification/exact/vortex.hpp"

#include <cmath>
#include <numbers>

namespace mpm::verification::exact {
namespace {

/// A function of one variable with its first two derivatives.
struct Curve {
  double value, slope, bend;
};

/// h(R)
Curve twist(double radius) {
  const double d = radius - 1;
  if (std::abs(d) >= 0.25) return {0, 0, 0};
  return {1 - 32 * d * d + 256 * d * d * d * d, -64 * d + 1024 * d * d * d, -64 + 3072 * d * d};
}

/// g(t)
Curve swing(const Vortex& vortex, double t) {
  const double w = 2 * std::numbers::pi / vortex.period, half = vortex.amplitude / 2;
  return {half * (1 - std::cos(w * t)), half * w * std::sin(w * t), half * w * w * std::cos(w * t)};
}

double radius_of(Vector x) { return std::hypot(x.x, x.y); }

}  // namespace

Vector Vortex::position(Vector initial, double t) const {
  const double alpha = swing(*this, t).value * twist(radius_of(initial)).value;
  const double c = std::cos(alpha), s = std::sin(alpha);
  return {c * initial.x - s * initial.y, s * initial.x + c * initial.y};
}

Vector Vortex::velocity(Vector initial, double t) const {
  const double rate = swing(*this, t).slope * twist(radius_of(initial)).value;
  const Vector x = position(initial, t);
  return {-rate * x.y, rate * x.x};
}

Vector Vortex::body_force(Vector initial, double t) const {
  const double r = radius_of(initial), stiffness = solid.mu / solid.density;
  const Curve h = twist(r), g = swing(*this, t);
  const double rate = g.slope * h.value, shear = g.value * h.slope;
  const double radial = -r * rate * rate + stiffness * r * shear * shear;
  const double around = r * g.bend * h.value - stiffness * (r * g.value * h.bend + 3 * shear);
  const Vector x = position(initial, t);
  return {(radial * x.x - around * x.y) / r, (radial * x.y + around * x.x) / r};
}

}  // namespace mpm::verification::exact
