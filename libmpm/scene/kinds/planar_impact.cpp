// A block without a cavity falls onto a rigid wall: one planar shock.
#include <algorithm>

#include "libmpm/measure/planar_shock.hpp"
#include "libmpm/scene/kinds/block.hpp"

namespace mpm {
namespace {

constexpr Quantity rows[] = {with_block::impact_speed, with_block::width, with_block::height};

/// Behind a planar shock one particle per cell with a domain that tiles leaves the least noise, and the
/// deviator needs a linear viscosity of 1: measured by tests/verification.
void set_default_numerics(Numerics& n) {
  n.scheme = ShapeFunction::gimp;
  n.particles_per_cell = 1;
  n.linear_viscosity = 1;
}

template <int axes>
BasicBody<axes> body(const Scene& s, const BasicLattice<axes>& l) {
  const double u = s.impact_speed;
  return {everywhere<axes>(), [u](const Vec<axes>&) { return with_block::velocity<axes>(-u); }, l.center};
}

double coarsest_cell(const Scene& s) { return std::min(s.block_width / 8, s.block_height / 64); }

std::vector<Part> no_parts(const Scene&) { return {}; }

constexpr Results measured[] = {PlanarShock::results};

template <int axes>
BasicMeasurements<axes> measurements(const Scene& s, const BasicState<axes>& state) {
  BasicMeasurements<axes> all;
  all.push_back(std::make_unique<BasicPlanarShock<axes>>(s, state));
  return all;
}

template <int axes>
constexpr KindIn<axes> in_axes{with_block::lattice<axes>, body<axes>, with_block::size<axes>,
                               measurements<axes>};

}  // namespace

extern constinit const Kind planar_impact{
    .kind = SceneKind::planar_impact,
    .name = "planar-impact",
    .quantities = rows,
    .results = measured,
    .headline = "free_surface_speed_m_s",
    .set_default_numerics = set_default_numerics,
    .check = with_block::check,
    .extent = with_block::extent,
    .floor = with_block::floor,
    .fastest = with_block::fastest,
    .coarsest_cell = coarsest_cell,
    .parts = no_parts,
    .shock_pressure = with_block::shock_pressure,
    .of_two_axes = in_axes<2>,
    .of_three_axes = in_axes<3>,
};

}  // namespace mpm
