// A block with a cavity falls onto a rigid wall.
#include "libmpm/scene/kinds/cavity.hpp"

namespace mpm {
namespace {

template <int axes>
BasicBody<axes> body(const Scene& s, const BasicLattice<axes>& l) {
  const double u = s.impact_speed;
  return {everywhere<axes>() - ball<axes>(Vec<axes>::Zero(), s.cavity_radius),
          [u](const Vec<axes>&) { return with_block::velocity<axes>(-u); }, l.center};
}

template <int axes>
double size(const Scene& s, const BasicLattice<axes>& l) {
  return with_block::size(s, l) - with_cavity::hole(s, l);
}

template <int axes>
BasicMeasurements<axes> measurements(const Scene& s, const BasicState<axes>& state) {
  return with_cavity::measurements(s, state, false);
}

template <int axes>
constexpr KindIn<axes> in_axes{with_block::lattice<axes>, body<axes>, size<axes>, measurements<axes>};

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
    .floor = with_block::floor,
    .fastest = with_block::fastest,
    .coarsest_cell = with_cavity::coarsest_cell,
    .parts = with_cavity::parts,
    .shock_pressure = with_block::shock_pressure,
    .of_two_axes = in_axes<2>,
    .of_three_axes = in_axes<3>,
};

}  // namespace mpm
