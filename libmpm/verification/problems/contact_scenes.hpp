#pragma once
#include <cmath>
#include <string>

#include "libmpm/scene/build.hpp"
#include "libmpm/simulation.hpp"

/// Small scenes of bodies in contact, for problems and tests.
namespace mpm::verification::contact_scenes {

inline mpm::Material elastic(double youngs_modulus = 1e9, double poissons_ratio = 0.3,
                             double density = 1000) {
  mpm::Material m;
  m.name = "elastic";
  m.law = mpm::MaterialLaw::neo_hookean;
  m.youngs_modulus = youngs_modulus;
  m.poissons_ratio = poissons_ratio;
  m.reference_density = density;
  m.pressure_limit = 1e12;
  m.specific_heat = 1000;
  m.initial_temperature = 300;
  return m;
}
inline mpm::Shape block(const mpm::Triple& low, const mpm::Triple& high) {
  return {mpm::Shape::Form::block, {low[0], low[1], low[2], high[0], high[1], high[2]}, {}};
}
inline mpm::Shape ball(const mpm::Triple& c, double r) {
  return {mpm::Shape::Form::ball, {c[0], c[1], c[2], r}, {}};
}
/// What lies below the plane through the origin that is turned by `angle` about z.
inline mpm::ComposedBody rigid_plane(double angle) {
  return {.name = "plane",
          .shape = {mpm::Shape::Form::half_space, {0, 0, 0, std::sin(angle), std::cos(angle), 0}, {}},
          .rigid = true};
}
inline mpm::ContactRule frictionless() { return {{}, {}, mpm::ContactLaw::frictionless}; }
inline mpm::ContactRule coulomb(double friction) { return {{}, {}, mpm::ContactLaw::coulomb, friction}; }
inline mpm::Face& face(mpm::Scene& s, mpm::Side side) {
  return s.composition.faces[static_cast<std::size_t>(side)];
}
inline void add_gauge(mpm::Scene& s, const char* name, const char* of, const char* body) {
  s.measures.gauges.push_back({.name = name, .of = of, .target = mpm::GaugeTarget::body, .body = body});
}
inline void add_contact_gauge(mpm::Scene& s, const char* name, const char* of, const char* first,
                              const char* second) {
  s.measures.gauges.push_back(
      {.name = name, .of = of, .target = mpm::GaugeTarget::contact, .first = first, .second = second});
}
inline double metric(const mpm::RunResult& r, const std::string& name) {
  const mpm::Metric* found = r.find(name);
  return found ? found->value : std::nan("");
}

/// An empty box, on the plain step.
inline mpm::Scene box(mpm::Space space, double cell, const mpm::Triple& low, const mpm::Triple& high) {
  mpm::Scene s;
  s.kind = mpm::SceneKind::bodies;
  s.material = elastic();
  s.space = space;
  s.numerics = mpm::default_numerics(s.kind, space);
  s.numerics.kernel = mpm::Kernel::reference;
  s.numerics.cell_size = cell;
  s.composition.low = low, s.composition.high = high;
  if (space == mpm::Space::axisymmetric) face(s, mpm::Side::left) = mpm::Face::mirror;
  return s;
}

/// Two blocks in a channel that come together at 10 m/s each, three cells apart.
inline mpm::Scene two_blocks(mpm::Space space) {
  constexpr double h = 1e-3, width = 4 * h;
  mpm::Scene s = box(space, h, {0, 0, 0}, {width, 24 * h, width});
  for (const mpm::Side side : {mpm::Side::left, mpm::Side::right, mpm::Side::front, mpm::Side::back})
    face(s, side) = mpm::Face::mirror;
  s.composition.bodies = {
      {.name = "low", .shape = block({0, 4 * h, 0}, {width, 9 * h, width}), .velocity = {0, 10, 0}},
      {.name = "high", .shape = block({0, 12 * h, 0}, {width, 17 * h, width}), .velocity = {0, -10, 0}}};
  s.composition.contacts = {frictionless()};
  s.end_time = 0.2e-3;
  s.measures.area_every = 2e-6;
  add_gauge(s, "v_low", "velocity_y", "low"), add_gauge(s, "v_high", "velocity_y", "high");
  add_gauge(s, "top", "highest_y", "low"), add_gauge(s, "bottom", "lowest_y", "high");
  add_contact_gauge(s, "force", "force_y", "low", "high");
  add_contact_gauge(s, "given", "impulse_y", "high", "low");
  return s;
}

}  // namespace mpm::verification::contact_scenes
