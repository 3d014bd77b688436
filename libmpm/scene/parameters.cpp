#include "libmpm/scene/parameters.hpp"

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>
#include <limits>

namespace mpm {
namespace {

bool every(SceneKind) { return true; }
bool block(SceneKind k) { return k != SceneKind::imploding_shell; }
bool cavity(SceneKind k) { return has_cavity(k); }
bool shell(SceneKind k) { return k == SceneKind::imploding_shell; }

/// a - b - c, which has the rounding of its terms: of the numbers that it may stand for, the one with the
/// fewest digits. A wall that was written as 1 um is 1e-06, not 9.999999999999995e-07.
double rounded_difference(double a, double b, double c) {
  const double difference = a - b - c;
  const double doubt =
      2 * std::numeric_limits<double>::epsilon() * std::max({std::abs(a), std::abs(b), std::abs(c)});
  if (std::abs(difference) <= doubt) return 0;
  for (int digits = 0; digits < std::numeric_limits<double>::max_digits10; ++digits) {
    char text[32];
    const auto end =
        std::to_chars(text, text + sizeof text, difference, std::chars_format::scientific, digits).ptr;
    double rounded = difference;
    std::from_chars(text, end, rounded);
    if (std::abs(rounded - difference) <= doubt) return rounded;
  }
  return difference;  // not finite
}

using S = Scene;
constexpr auto P = Section::parameters;
constexpr auto M = Section::material;
constexpr auto N = Section::numerics;
constexpr auto positive = Range::positive;
constexpr auto non_negative = Range::non_negative;
constexpr bool required = true;
constexpr bool optional = false;
constexpr bool derived = true;

#define FIELD(member) [](const S& s) -> double { return s.member; }, [](S& s, double v) { s.member = v; }

// wall_thickness stands behind the three lengths that it is made of: rows are applied from the top.
// clang-format off
const Quantity quantity_table[] = {
    {"impact_speed", "m/s", "impact_speed_m_s", "speed of the block onto the rigid wall; of two bodies: of each, towards the other",
     P, positive, required, "", block, FIELD(impact_speed)},
    {"block_width", "m", "block_width_m", "full width of the block, between its mirrors",
     P, positive, required, "", block, FIELD(block_width)},
    {"block_height", "m", "block_height_m", "height of the block; of two bodies: of each",
     P, positive, required, "", block, FIELD(block_height)},
    {"cavity_radius", "m", "cavity_radius_m", "radius of the cavity",
     P, positive, required, "", cavity, FIELD(cavity_radius)},
    {"cavity_center_height", "m", "cavity_center_height_m", "height of the cavity's centre above the impact face",
     P, positive, required, "wall_thickness", cavity, FIELD(cavity_center_height)},
    {"wall_thickness", "m", "wall_thickness_m", "downstream wall: block_height - cavity_center_height - cavity_radius",
     P, non_negative, required, "cavity_center_height", cavity,
     [](const S& s) { return rounded_difference(s.block_height, s.cavity_center_height, s.cavity_radius); },
     [](S& s, double d) { s.cavity_center_height = s.block_height - d - s.cavity_radius; }, derived},
    {"inner_radius", "m", "inner_radius_m", "inner radius of the shell",
     P, positive, required, "", shell, FIELD(inner_radius)},
    {"outer_radius", "m", "outer_radius_m", "outer radius of the shell",
     P, positive, required, "", shell, FIELD(outer_radius)},
    {"inner_speed", "m/s", "inner_speed_m_s", "speed, inwards, of the shell's inner surface: v(r) = -inner_speed inner_radius / r",
     P, positive, required, "", shell, FIELD(inner_speed)},
    {"end_time", "s", "end_time_s", "time at which a run ends",
     P, positive, required, "", every, FIELD(end_time)},
    {"yield_stress", "Pa", "yield_stress_Pa", "initial yield stress; infinite: elastic",
     P, Range::non_negative_or_infinite, optional, "", every, FIELD(material.yield_stress)},

    {"reference_density", "kg/m3", "reference_density_kg_m3", "density at rest",
     M, positive, optional, "", every, FIELD(material.reference_density)},
    {"youngs_modulus", "Pa", "youngs_modulus_Pa", "Young's modulus of the deviator",
     M, positive, optional, "", every, FIELD(material.youngs_modulus)},
    {"poissons_ratio", "1", "poissons_ratio", "Poisson's ratio of the deviator",
     M, non_negative, optional, "", every, FIELD(material.poissons_ratio)},
    {"hardening_modulus", "Pa", "hardening_modulus_Pa", "hardening modulus, in the measure of hardening_measure",
     M, non_negative, optional, "", every, FIELD(material.hardening_modulus)},
    {"kinematic_fraction", "1", "kinematic_fraction", "share of the hardening that is kinematic",
     M, non_negative, optional, "", every, FIELD(material.kinematic_fraction)},
    {"bulk_sound_speed", "m/s", "bulk_sound_speed_m_s", "c0 of Us = c0 + lambda Up",
     M, positive, optional, "", every, FIELD(material.bulk_sound_speed)},
    {"hugoniot_slope", "1", "hugoniot_slope", "lambda of Us = c0 + lambda Up",
     M, non_negative, optional, "", every, FIELD(material.hugoniot_slope)},
    {"gruneisen_gamma", "1", "gruneisen_gamma", "Grueneisen coefficient at rest",
     M, non_negative, optional, "", every, FIELD(material.gruneisen_gamma)},
    {"pressure_limit", "Pa", "pressure_limit_Pa", "pressure up to which the equation of state is valid",
     M, positive, optional, "", every, FIELD(material.pressure_limit)},
    {"specific_heat", "J/kg/K", "specific_heat_J_kg_K", "specific heat at constant volume",
     M, positive, optional, "", every, FIELD(material.specific_heat)},
    {"initial_temperature", "K", "initial_temperature_K", "temperature at rest",
     M, non_negative, optional, "", every, FIELD(material.initial_temperature)},
    {"spall_strength", "Pa", "spall_strength_Pa", "tension at which pressure is cut off (tension = \"cutoff\")",
     M, non_negative, optional, "", every, FIELD(material.spall_strength)},

    {"cell_size", "m", "cell_size_m", "edge of a grid cell",
     N, positive, required, "", every, FIELD(numerics.cell_size)},
    {"particles_per_cell", "1", "particles_per_cell", "particles a cell: 1, 4, 9 or 16",
     N, Range::count, optional, "", every,
     [](const S& s) -> double { return s.numerics.particles_per_cell; },
     [](S& s, double v) { s.numerics.particles_per_cell = static_cast<int>(v); }},
    {"cfl", "1", "cfl", "share of the stability limit that a time step takes",
     N, positive, optional, "", every, FIELD(numerics.cfl)},
    {"pic_fraction", "1", "pic_fraction", "share of PIC in the FLIP transfer, a step; damps what the grid cannot see",
     N, non_negative, optional, "", every, FIELD(numerics.pic_fraction)},
    {"linear_viscosity", "1", "linear_viscosity", "linear coefficient of the artificial viscosity",
     N, non_negative, optional, "", every, FIELD(numerics.linear_viscosity)},
    {"quadratic_viscosity", "1", "quadratic_viscosity", "quadratic coefficient of the artificial viscosity",
     N, non_negative, optional, "", every, FIELD(numerics.quadratic_viscosity)},

    {"area_every", "s", "area_every_s", "period of the area history",
     Section::measure, positive, optional, "", every, FIELD(measures.area_every)},
    {"detached_for", "s", "detached_for_s", "how long a part must have been off the body to count as ejected",
     Section::measure, non_negative, optional, "", cavity, FIELD(measures.detached_for)},
};
// clang-format on
#undef FIELD

constexpr std::string_view tension_names[] = {"polynomial", "linear", "cutoff"};
constexpr std::string_view hardening_names[] = {"norm", "equivalent", "tangent"};
constexpr std::string_view scheme_names[] = {"gimp", "bspline2", "cpdi", "bspline3"};
constexpr std::string_view transfer_names[] = {"flip", "apic"};
constexpr std::string_view symmetry_names[] = {"half", "full"};
constexpr std::string_view kernel_names[] = {"fast", "reference"};
constexpr std::string_view precision_names[] = {"double", "float"};
constexpr std::string_view decides_names[] = {"collapse", "ejection"};
constexpr std::string_view stop_names[] = {"end-time", "decided"};
constexpr std::string_view kind_names[] = {"cavity-impact", "planar-impact", "two-body-impact",
                                           "imploding-shell"};

#define CHOICE(member)                                           \
  [](const S& s) { return static_cast<std::size_t>(s.member); }, \
      [](S& s, std::size_t i) { s.member = static_cast<decltype(s.member)>(i); }

const Choice choice_table[] = {
    {"tension", "tension", "pressure of expanded material", M, tension_names, every,
     CHOICE(material.tension)},
    {"hardening_measure", "hardening_measure", "measure of strain of hardening_modulus", M, hardening_names,
     every, CHOICE(material.hardening_measure)},
    {"scheme", "scheme", "shape functions", N, scheme_names, every, CHOICE(numerics.scheme)},
    {"transfer", "transfer",
     "how particles and grid exchange velocities: acceleration, or velocity and gradient", N, transfer_names,
     every, CHOICE(numerics.transfer), "flip"},
    {"symmetry", "symmetry", "model half of the scene (a quarter of a shell) or all of it", N, symmetry_names,
     every, CHOICE(numerics.symmetry)},
    {"kernel", "kernel", "code that takes the steps: the fast one, or the plain one that it is held against",
     N, kernel_names, every, CHOICE(numerics.kernel)},
    {"precision", "precision", "numbers of the fast step; the reference step has double only", N,
     precision_names, every, CHOICE(numerics.precision)},
    {"decides", "decides", "what the outcome of a run says: is the cavity gone, or is material ejected",
     Section::measure, decides_names, cavity, CHOICE(measures.decides)},
    {"stop", "stop", "when a run ends: at end_time, or as soon as its ejection is decided", Section::measure,
     stop_names, cavity, CHOICE(measures.stop)},
};
#undef CHOICE

template <class Rows>
auto find_row(const Rows& rows, std::string_view name) -> decltype(&rows[0]) {
  for (const auto& row : rows)
    if (row.name == name) return &row;
  return nullptr;
}

}  // namespace

std::span<const Quantity> quantities() { return quantity_table; }
std::span<const Choice> choices() { return choice_table; }
const Quantity* find_quantity(std::string_view name) { return find_row(quantity_table, name); }
const Choice* find_choice(std::string_view name) { return find_row(choice_table, name); }

std::span<const std::string_view> scene_kind_names() { return kind_names; }
std::string_view to_string(SceneKind kind) { return kind_names[static_cast<std::size_t>(kind)]; }
std::optional<SceneKind> scene_kind_from(std::string_view name) {
  for (std::size_t i = 0; i < std::size(kind_names); ++i)
    if (kind_names[i] == name) return static_cast<SceneKind>(i);
  return std::nullopt;
}

}  // namespace mpm
