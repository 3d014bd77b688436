#pragma once
/// What those kinds of scene share whose block has a cavity.
#include "libmpm/core/enumerators.hpp"
#include "libmpm/measure/cavity.hpp"
#include "libmpm/measure/ejection.hpp"
#include "libmpm/scene/kinds/block.hpp"

namespace mpm::with_cavity {

double wall_thickness(const Scene&);  ///< between cavity and rear face [m]

// clang-format off
inline constexpr Quantity radius{
    "cavity_radius", "m", "R", "cavity_radius_m", "radius of the cavity",
    Section::parameters, Range::positive, true, "", get<&Scene::cavity_radius>, set<&Scene::cavity_radius>};
inline constexpr Quantity center_height{
    "cavity_center_height", "m", "y", "cavity_center_height_m", "height of the cavity's centre above the impact face",
    Section::parameters, Range::positive, true, "wall_thickness",
    get<&Scene::cavity_center_height>, set<&Scene::cavity_center_height>,
    {}, false, {}, "Height of the cavity centre"};
/// Stands behind the three lengths that it is made of: rows are applied from the top.
inline constexpr Quantity wall{
    "wall_thickness", "m", "d", "wall_thickness_m", "downstream wall: block_height - cavity_center_height - cavity_radius",
    Section::parameters, Range::non_negative, true, "cavity_center_height", wall_thickness,
    [](Scene& s, double d) { s.cavity_center_height = s.block_height - d - s.cavity_radius; }, {}, true, {},
    "Downstream wall thickness"};
inline constexpr Quantity detached_for{
    "detached_for", "s", "", "detached_for_s", "how long a part must have been off the body to count as ejected",
    Section::measure, Range::non_negative, false, "",
    [](const Scene& s) { return s.measures.detached_for; },
    [](Scene& s, double v) { s.measures.detached_for = v; }};
inline constexpr Quantity rows[] = {with_block::impact_speed, with_block::width, with_block::height,
                                    radius, center_height, wall, detached_for};
// clang-format on

inline constexpr auto decides_words =
    words<Decides>({{Decides::collapse, "collapse"}, {Decides::ejection, "ejection"}});
inline constexpr auto stop_words = words<Stop>({{Stop::end_time, "end-time"}, {Stop::decided, "decided"}});

inline constexpr Choice choices[] = {
    {"decides", "decides", "what the outcome of a run says: is the cavity gone, or is material ejected",
     Section::measure, decides_words,
     [](const Scene& s) { return static_cast<std::size_t>(s.measures.decides); },
     [](Scene& s, std::size_t i) { s.measures.decides = static_cast<Decides>(i); }},
    {"stop", "stop", "when a run ends: at end_time, or as soon as its ejection is decided", Section::measure,
     stop_words, [](const Scene& s) { return static_cast<std::size_t>(s.measures.stop); },
     [](Scene& s, std::size_t i) { s.measures.stop = static_cast<Stop>(i); }},
};

void set_default_numerics(Numerics&);
void check(const Scene&, Report&);
/// Of the cavity, as much of it as is modelled [m^2], of three axes [m^3].
template <int axes>
double hole(const Scene&, const BasicLattice<axes>&);
double coarsest_cell(const Scene&);
std::vector<Part> parts(const Scene&);
inline constexpr std::string_view outcomes[] = {"collapsed", "partial", "ejected", "arrested"};
/// Of what measurements() makes.
inline constexpr Results measured[] = {Cavity::results, Jet::results, Ejection::results};
/// `open_below`: there is no wall, so that what reaches the lowest row of the grid is the outside.
template <int axes>
BasicMeasurements<axes> measurements(const Scene&, const BasicState<axes>&, bool open_below);

}  // namespace mpm::with_cavity
