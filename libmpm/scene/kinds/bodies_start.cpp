// How the bodies of a composition move, and how hot they are, at time 0.
#include "libmpm/scene/kinds/bodies_start.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

#include "libmpm/scene/region_of.hpp"

namespace mpm {
namespace {

double speed_at(const RadialVelocity& v, double radius) {
  return v.speed * std::pow(radius / v.at, v.exponent);
}
template <int axes>
Vec<axes> radial_velocity(const RadialVelocity& v, const Vec<axes>& x) {
  const Vec<axes> arm = x - vector(v.about).head<axes>();
  const double radius = arm.norm();
  if (radius == 0) return Vec<axes>::Zero();  // the centre stays
  return speed_at(v, radius) / radius * arm;
}

/// How near a body comes to a point, and how far it goes from there at most [m].
template <int axes>
std::pair<double, double> distances(const Composition& all, const ComposedBody& b, const Triple& point) {
  const BasicRegion<axes> region = region_in<axes>(all, b);
  const Vec<axes> from = vector(point).head<axes>();
  const double far = (region.high - from).cwiseAbs().cwiseMax((region.low - from).cwiseAbs()).norm();
  double empty = 0, reached = far;  // balls about the point with nothing of the body, and with some of it
  while (reached - empty > 1e-12 * far) {
    const double middle = 0.5 * (empty + reached);
    (region.share_of_ball(from, middle) == Share::none ? empty : reached) = middle;
  }
  return {reached <= 2e-12 * far ? 0 : reached, far};
}
std::pair<double, double> distances(const Scene& s, const ComposedBody& b, const Triple& point) {
  return axes_of(s.space) == 2 ? distances<2>(s.composition, b, point)
                               : distances<3>(s.composition, b, point);
}

void check_radial(const Scene& s, const ComposedBody& b, Report& report) {
  const RadialVelocity& v = b.radial;
  const std::string what = "body " + b.name + ", radial_velocity";
  if (v.speed == 0) return;
  if (!(v.at > 0)) report.add_other(what, "at = " + text_of(v.at) + " m", "at a radius above 0");
  if (s.space == Space::axisymmetric && v.about[0] != 0)
    report.add_other(what, "about " + vector_text(v.about, 2, "m"),
                     "about a point of the axis, x = 0, when space is \"axisymmetric\"");
  if (v.exponent < 0 && distances(s, b, v.about).first == 0)
    report.add_other(what, "exponent = " + text_of(v.exponent),
                     "0 or more where the body holds the point that it moves to: the speed there has no end");
}

void check_energy(const Scene& s, const ComposedBody& b, Report& report) {
  if (b.energy == 0 || b.material >= material_count(s)) return;
  const std::string what = "body " + b.name + ", specific_internal_energy",
                    value = text_of(b.energy) + " J/kg";
  const Material& m = material_of(s, b.material);
  const double pressure = pressure_per_energy(m) * b.energy;
  if (!(b.energy > 0)) report.add_other(what, value, "0 or more, that of the material at rest");
  if (pressure == 0) report.add_other(what, value, "0 in a material whose pressure knows no heat");
  if (!(pressure <= m.pressure_limit))
    report.add_other(what, value,
                     "such that the pressure, " + text_of(pressure) + " Pa, is at most pressure_limit (" +
                         text_of(m.pressure_limit) + " Pa)");
}

double fastest_radial(const Scene& s, const ComposedBody& b) {
  if (b.radial.speed == 0) return 0;
  const auto [near, far] = distances(s, b, b.radial.about);
  const double speed = std::abs(speed_at(b.radial, b.radial.exponent < 0 ? near : far));
  // parts that meet in the centre feel the viscosity of their relative speed
  return near == 0 && b.radial.exponent < 1 ? 3 * speed : speed;
}

/// All of its energy turned into motion.
double fastest_expansion(const ComposedBody& b) { return std::sqrt(2 * std::max(b.energy, 0.0)); }

}  // namespace

template <int axes>
BasicRegion<axes> region_in(const Composition& all, const ComposedBody& b) {
  const Vec<axes> low = vector(all.low).head<axes>(), high = vector(all.high).head<axes>();
  return region_of<axes>(b.shape) & block<axes>(low, high);
}

template <int axes>
std::function<Vec<axes>(const Vec<axes>& x)> velocity_at_start(const ComposedBody& b) {
  return [v = vector(b.velocity), spin = b.spin, about = vector(b.about),
          radial = b.radial](const Vec<axes>& x) {
    const Vec2 arm = x.template head<2>() - about.head<2>();
    Vec3 here = v;
    here.head<2>() += spin * Vec2(-arm.y(), arm.x());
    if (radial.speed != 0) here.head<axes>() += radial_velocity<axes>(radial, x);
    return Vec<axes>(here.head<axes>());
  };
}

double fastest_at_start(const Scene& s) {
  const double across = (vector(s.composition.high) - vector(s.composition.low)).head<2>().norm();
  double most = 0;
  for (const ComposedBody& b : s.composition.bodies)
    most = std::max(most, vector(b.velocity).norm() + std::abs(b.spin) * across + fastest_radial(s, b) +
                              fastest_expansion(b));
  return most;
}

void check_start(const Scene& s, const ComposedBody& b, Report& report) {
  check_radial(s, b, report);
  check_energy(s, b, report);
}

std::string vector_text(const Triple& v, int axes, const char* unit) {
  std::string text;
  for (int k = 0; k < axes; ++k) text += (k == 0 ? "" : ", ") + text_of(v[static_cast<std::size_t>(k)]);
  return "(" + text + ") " + unit;
}

template BasicRegion<2> region_in(const Composition&, const ComposedBody&);
template BasicRegion<3> region_in(const Composition&, const ComposedBody&);
template std::function<Vec2(const Vec2&)> velocity_at_start(const ComposedBody&);
template std::function<Vec3(const Vec3&)> velocity_at_start(const ComposedBody&);

}  // namespace mpm
