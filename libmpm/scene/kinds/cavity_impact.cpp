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

extern constinit const Kind cavity_impact{SceneKind::cavity_impact,
                                          "cavity-impact",
                                          with_cavity::rows,
                                          with_cavity::choices,
                                          "collapsibility",
                                          with_cavity::set_default_numerics,
                                          with_cavity::check,
                                          with_block::extent,
                                          with_block::lattice,
                                          with_block::floor,
                                          body,
                                          area,
                                          with_block::fastest,
                                          with_cavity::coarsest_cell,
                                          measurements};

}  // namespace mpm
