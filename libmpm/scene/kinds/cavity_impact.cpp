// A block with a cavity falls onto a rigid wall.
#include "libmpm/scene/kinds/cavity.hpp"

namespace mpm {
namespace {

Body body(const Scene& s, const Lattice& l) {
  const double u = s.impact_speed;
  return {everywhere() - disc({0, 0}, s.cavity_radius), [u](const Vec2&) { return Vec2(0, -u); }, l.center};
}

double area(const Scene& s, const Lattice& l) { return with_block::area(s, l) - with_cavity::hole(s, l); }

Measurements measurements(const Scene& s, const State& state) {
  return with_cavity::measurements(s, state, false);
}

}  // namespace

extern constinit const Kind cavity_impact{
    .kind = SceneKind::cavity_impact,
    .name = "cavity-impact",
    .quantities = with_cavity::rows,
    .choices = with_cavity::choices,
    .results = with_cavity::measured,
    .headline = "collapsibility",
    .outcomes = with_cavity::outcomes,
    .has_area_history = true,
    .set_default_numerics = with_cavity::set_default_numerics,
    .check = with_cavity::check,
    .extent = with_block::extent,
    .lattice = with_block::lattice,
    .floor = with_block::floor,
    .body = body,
    .area = area,
    .fastest = with_block::fastest,
    .coarsest_cell = with_cavity::coarsest_cell,
    .parts = with_cavity::parts,
    .shock_pressure = with_block::shock_pressure,
    .measurements = measurements,
};

}  // namespace mpm
