#include "libmpm/scene/gauge.hpp"

#include <algorithm>
#include <array>

#include "libmpm/io/fields.hpp"

namespace mpm {
namespace {

constexpr std::string_view targets[] = {"point", "place", "beam", "body", "wall", "contact"};
constexpr std::string_view windows[] = {"mean", "max", "min"};

/// Of a particle, beside the fields of snapshots. Where it is, only a gauge that follows it says.
constexpr GaugeQuantity speed{.name = "speed", .meaning = "magnitude of the velocity", .unit = "m/s"};
constexpr GaugeQuantity positions[] = {
    {.name = "position_x", .meaning = "where it is along x", .unit = "m"},
    {.name = "position_y", .meaning = "where it is along y", .unit = "m"},
    {.name = "position_z", .meaning = "where it is along z", .unit = "m", .only_of_three_axes = true},
};

// clang-format off
constexpr GaugeQuantity of_bodies[] = {
    {.name = "mass", .meaning = "mass", .unit = "kg/m", .axisymmetric = "kg/rad", .three_d = "kg"},
    {.name = "center_x", .meaning = "centre of mass", .unit = "m"},
    {.name = "center_y", .meaning = "centre of mass", .unit = "m"},
    {.name = "center_z", .meaning = "centre of mass", .unit = "m", .only_of_three_axes = true},
    {.name = "velocity_x", .meaning = "velocity of the centre of mass", .unit = "m/s"},
    {.name = "velocity_y", .meaning = "velocity of the centre of mass", .unit = "m/s"},
    {.name = "velocity_z", .meaning = "velocity of the centre of mass", .unit = "m/s", .only_of_three_axes = true},
    {.name = "momentum_x", .meaning = "momentum", .unit = "kg/s", .axisymmetric = "kg m/s/rad", .three_d = "kg m/s"},
    {.name = "momentum_y", .meaning = "momentum", .unit = "kg/s", .axisymmetric = "kg m/s/rad", .three_d = "kg m/s"},
    {.name = "momentum_z", .meaning = "momentum", .unit = "kg/s", .axisymmetric = "kg m/s/rad", .three_d = "kg m/s", .only_of_three_axes = true},
    {.name = "spin", .meaning = "angular momentum about the z axis through the centre of mass over the moment of inertia about it",
     .unit = "rad/s", .not_axisymmetric = true},
    {.name = "kinetic_energy", .meaning = "kinetic energy", .unit = "J/m", .axisymmetric = "J/rad", .three_d = "J"},
    {.name = "internal_energy", .meaning = "internal energy", .unit = "J/m", .axisymmetric = "J/rad", .three_d = "J"},
    {.name = "lowest_x", .meaning = "least x of its particles' edges", .unit = "m"},
    {.name = "lowest_y", .meaning = "least y of its particles' edges", .unit = "m"},
    {.name = "lowest_z", .meaning = "least z of its particles' edges", .unit = "m", .only_of_three_axes = true},
    {.name = "highest_x", .meaning = "largest x of its particles' edges", .unit = "m"},
    {.name = "highest_y", .meaning = "largest y of its particles' edges", .unit = "m"},
    {.name = "highest_z", .meaning = "largest z of its particles' edges", .unit = "m", .only_of_three_axes = true},
    {.name = "length_x", .meaning = "highest_x - lowest_x", .unit = "m"},
    {.name = "length_y", .meaning = "highest_y - lowest_y", .unit = "m"},
    {.name = "length_z", .meaning = "highest_z - lowest_z", .unit = "m", .only_of_three_axes = true},
};

constexpr GaugeQuantity of_walls[] = {
    {.name = "force", .meaning = "push along the normal of the wall, positive away from it: mean since the sample before",
     .unit = "N/m", .axisymmetric = "N/rad", .three_d = "N"},
};

constexpr GaugeQuantity of_contacts[] = {
    {.name = "force_x", .meaning = "push on the first body: mean since the sample before", .unit = "N/m", .axisymmetric = "N/rad", .three_d = "N"},
    {.name = "force_y", .meaning = "push on the first body: mean since the sample before", .unit = "N/m", .axisymmetric = "N/rad", .three_d = "N"},
    {.name = "force_z", .meaning = "push on the first body: mean since the sample before", .unit = "N/m", .axisymmetric = "N/rad", .three_d = "N", .only_of_three_axes = true},
    {.name = "impulse_x", .meaning = "momentum that the first body was given so far", .unit = "kg/s", .axisymmetric = "kg m/s/rad", .three_d = "kg m/s"},
    {.name = "impulse_y", .meaning = "momentum that the first body was given so far", .unit = "kg/s", .axisymmetric = "kg m/s/rad", .three_d = "kg m/s"},
    {.name = "impulse_z", .meaning = "momentum that the first body was given so far", .unit = "kg/s", .axisymmetric = "kg m/s/rad", .three_d = "kg m/s", .only_of_three_axes = true},
};
// clang-format on

/// The fields of snapshots, but for the mass, which says how the grid was filled.
std::vector<GaugeQuantity> of_particles(bool with_position) {
  std::vector<GaugeQuantity> all;
  for (const Field& field : fields()) {
    if (field.name == "mass") continue;
    const std::string_view words = field.title.empty() ? field.name : field.title;
    all.push_back({.name = field.name, .meaning = words, .unit = field.unit});
    all.back().only_of_three_axes = field.only_of_three_axes();
  }
  all.push_back(speed);
  if (with_position) all.insert(all.end(), std::begin(positions), std::end(positions));
  return all;
}

}  // namespace

std::string_view GaugeQuantity::unit_in(Space space) const {
  return space == Space::axisymmetric ? axisymmetric : space == Space::three_d ? three_d : unit;
}
bool GaugeQuantity::is_in(Space space) const {
  return (space == Space::three_d || !only_of_three_axes) &&
         (space != Space::axisymmetric || !not_axisymmetric);
}

std::string_view to_string(GaugeTarget target) { return targets[static_cast<std::size_t>(target)]; }
std::string_view to_string(Window window) { return windows[static_cast<std::size_t>(window)]; }
std::optional<Window> window_from(std::string_view word) {
  const auto at = std::ranges::find(windows, word);
  if (at == std::end(windows)) return std::nullopt;
  return static_cast<Window>(at - std::begin(windows));
}

const std::vector<GaugeQuantity>& gauge_quantities(GaugeTarget target) {
  static const std::array<std::vector<GaugeQuantity>, std::size(targets)> tables = {
      of_particles(true),
      of_particles(false),
      of_particles(true),
      std::vector<GaugeQuantity>(std::begin(of_bodies), std::end(of_bodies)),
      std::vector<GaugeQuantity>(std::begin(of_walls), std::end(of_walls)),
      std::vector<GaugeQuantity>(std::begin(of_contacts), std::end(of_contacts))};
  return tables[static_cast<std::size_t>(target)];
}

const GaugeQuantity* find_gauge_quantity(GaugeTarget target, std::string_view name) {
  for (const GaugeQuantity& one : gauge_quantities(target))
    if (one.name == name) return &one;
  return nullptr;
}

bool is_kept_name(std::string_view name) {
  return name == stop_metric || std::ranges::find(gauge_metrics, name) != std::end(gauge_metrics);
}

std::vector<std::string> metrics_of(const Gauge& gauge) {
  std::vector<std::string> names;
  for (const std::string_view word : gauge_metrics) names.push_back(gauge.name + "." + std::string(word));
  for (const Reduction& one : gauge.reductions) names.push_back(gauge.name + "." + one.name);
  if (!gauge.stops.empty()) names.push_back(gauge.name + "." + std::string(stop_metric));
  return names;
}

std::string_view unit_of_metric(const Gauge& gauge, std::string_view metric, Space space) {
  if (metric == gauge.name + "." + std::string(stop_metric)) return "s";
  const GaugeQuantity* quantity = find_gauge_quantity(gauge.target, gauge.of);
  return quantity ? quantity->unit_in(space) : "1";
}

bool is_gauge_name(std::string_view name) {
  const auto plain = [](char c) {
    return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || (c >= '0' && c <= '9') || c == '-' || c == '_';
  };
  return !name.empty() && name.size() <= 60 && std::ranges::all_of(name, plain);
}

namespace {
constexpr std::string_view directions[] = {"+x", "-x", "+y", "-y", "+z", "-z"};
}

BeamDirection beam_direction(std::string_view word) {
  const auto at = std::ranges::find(directions, word);
  if (at == std::end(directions)) return {};
  const auto index = static_cast<int>(at - std::begin(directions));
  return {index / 2, index % 2 == 0 ? 1 : -1};
}
std::vector<std::string_view> beam_directions(int axes) { return {directions, directions + 2 * axes}; }

}  // namespace mpm
