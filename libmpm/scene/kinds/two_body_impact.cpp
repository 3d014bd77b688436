// A block with a cavity meets one of the same size without, which comes towards it; they meet at y = 0.
#include <algorithm>
#include <cmath>

#include "libmpm/scene/kinds/cavity.hpp"

namespace mpm {
namespace {

/// With the struck block, and below it the way that its rear face goes after the shock, at most at
/// impact_speed.
template <int axes>
BasicLattice<axes> lattice(const Scene& s) {
  BasicLattice<axes> l = with_block::lattice<axes>(s);
  const int room = static_cast<int>(std::ceil(s.impact_speed * s.end_time / l.cell.y())) + 4;
  l.empty_rows = room;
  l.origin.y() = -(l.rows + room) * l.cell.y();
  l.rows += l.rows + room;
  return l;
}

void check(const Scene& s, Report& report) {
  constexpr double most_cells = 1e9;
  const double h = s.numerics.cell_size;
  const double depth = s.space == Space::three_d ? s.block_width / h : 1;
  const double cells = depth * s.block_width / h * ((2 * s.block_height + s.impact_speed * s.end_time) / h);
  report.require(
      cells <= most_cells, "end_time",
      "short enough for at most 1e9 cells of the way that the bodies go at impact_speed (these would be " +
          text_of(cells) + ")");
  with_cavity::check(s, report);
}

Extent extent(const Scene& s) { return {s.block_width, 2 * s.block_height, s.block_width}; }

template <int axes>
BasicBody<axes> body(const Scene& s, const BasicLattice<axes>& l) {
  const double u = s.impact_speed, face = -l.center.y();  // y = 0, from the cavity's centre
  return {everywhere<axes>() - ball<axes>(Vec<axes>::Zero(), s.cavity_radius),
          [=](const Vec<axes>& x) { return with_block::velocity<axes>(x.y() < face ? u : -u); }, l.center};
}

template <int axes>
double size(const Scene& s, const BasicLattice<axes>& l) {
  return with_block::size(s, l) * 2 - with_cavity::hole(s, l);
}

/// Once the shock has run to the free rear of each body and the release has come back.
double parting_time(const Scene& s) {
  const Material& m = s.material;
  const double u = s.impact_speed, shock = shock_speed(m, u);
  const double release = sound_speed_at_rest(m) + 2 * m.hugoniot_slope * u;
  return s.block_height / shock + s.block_height * std::max(0.0, 1 - u / shock) / release;
}

template <int axes>
BasicMeasurements<axes> measurements(const Scene& s, const BasicState<axes>& state) {
  return with_cavity::measurements(s, state, true);
}

template <int axes>
constexpr KindIn<axes> in_axes{lattice<axes>, body<axes>, size<axes>, measurements<axes>};

}  // namespace

extern constinit const Kind two_body_impact{
    .kind = SceneKind::two_body_impact,
    .name = "two-body-impact",
    .quantities = with_cavity::rows,
    .choices = with_cavity::choices,
    .results = with_cavity::measured,
    .headline = "collapsibility",
    .outcomes = with_cavity::outcomes,
    .has_area_history = true,
    .set_default_numerics = with_cavity::set_default_numerics,
    .check = check,
    .extent = extent,
    .floor = with_block::floor,
    .fastest = with_block::fastest,
    .coarsest_cell = with_cavity::coarsest_cell,
    .parts = with_cavity::parts,
    .shock_pressure = with_block::shock_pressure,
    .parting_time = parting_time,
    .of_two_axes = in_axes<2>,
    .of_three_axes = in_axes<3>,
};

}  // namespace mpm
