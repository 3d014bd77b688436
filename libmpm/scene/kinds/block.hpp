#pragma once
/// What those kinds of scene share in which a block falls onto y = 0: v_y = -impact_speed.
#include "libmpm/scene/kinds/kind.hpp"

namespace mpm::with_block {

// clang-format off
inline constexpr Quantity impact_speed{
    "impact_speed", "m/s", "u", "impact_speed_m_s", "speed of the block onto the rigid wall; of two bodies: of each, towards the other",
    Section::parameters, Range::positive, true, "", get<&Scene::impact_speed>, set<&Scene::impact_speed>};
inline constexpr Quantity width{
    "block_width", "m", "W", "block_width_m", "full width of the block, between its mirrors",
    Section::parameters, Range::positive, true, "", get<&Scene::block_width>, set<&Scene::block_width>};
inline constexpr Quantity height{
    "block_height", "m", "H", "block_height_m", "height of the block; of two bodies: of each",
    Section::parameters, Range::positive, true, "", get<&Scene::block_height>, set<&Scene::block_height>};
// clang-format on

void check(const Scene&, Report&);
Extent extent(const Scene&);
/// Cells are stretched by less than half a cell in all so that walls and free surface lie on nodes.
template <int axes>
BasicLattice<axes> lattice(const Scene&);
Floor floor(const Scene&);
template <int axes>
double size(const Scene&, const BasicLattice<axes>&);
/// Along the impact.
template <int axes>
Vec<axes> velocity(double upwards) {
  Vec<axes> v = Vec<axes>::Zero();
  v.y() = upwards;
  return v;
}
double fastest(const Scene&);
/// On the Hugoniot at impact_speed [Pa].
double shock_pressure(const Scene&);

}  // namespace mpm::with_block
