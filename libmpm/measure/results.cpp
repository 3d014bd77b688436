#include "libmpm/measure/results.hpp"

namespace mpm {
namespace {

constexpr double infinity = std::numeric_limits<double>::infinity();
constexpr bool with_interval = true;
constexpr bool without_interval = false;

bool every(SceneKind) { return true; }
bool cavity(SceneKind kind) { return has_cavity(kind); }
bool planar(SceneKind kind) { return kind == SceneKind::planar_impact; }
bool shell(SceneKind kind) { return kind == SceneKind::imploding_shell; }

// clang-format off
const ResultRow table[] = {
    {"collapsibility", "1", "Φ", "(initial - final) / initial area of the cavity",
     cavity, Needs::nothing, with_interval, -infinity, 1, 0.1},  // a torn cavity may be larger than it was
    {"final_area_m2", "m2", "A", "area of the cavity at the end", cavity, Needs::nothing, with_interval, 0},
    {"initial_area_m2", "m2", "A", "area of the cavity at the start", cavity, Needs::nothing, without_interval, 0},

    {"particles", "1", "", "particles of the run", every, Needs::nothing, without_interval, 0},
    {"steps", "1", "", "time steps of the run", every, Needs::nothing, without_interval, 0},
    {"wall_s", "s", "", "duration", every, Needs::nothing, without_interval, 0},
    {"cpu_s", "s", "", "time on a processor", every, Needs::nothing, without_interval, 0},

    {"energy_error", "1", "", "largest relative error of kinetic + internal energy",
     every, Needs::nothing, without_interval, 0},
    {"momentum_error", "1", "", "largest error of momentum against the impulse of the wall",
     every, Needs::nothing, without_interval, 0},
    {"transfer_heat_fraction", "1", "", "share of the initial energy that the transfer turned into heat",
     every, Needs::nothing, with_interval, 0},
    {"final_kinetic_fraction", "1", "", "kinetic energy at the end / initial energy",
     every, Needs::nothing, with_interval, 0},
    {"overpressed_mass_fraction", "1", "", "largest share of the mass beyond pressure_limit",
     every, Needs::nothing, without_interval, 0, 1},
    {"overstrained_mass_fraction", "1", "", "largest share of the mass whose rho0/rho left its range",
     every, Needs::nothing, without_interval, 0, 1},
    {"smallest_density_ratio", "1", "", "smallest rho/rho0 of a particle", every, Needs::nothing, without_interval, 0},
    {"largest_density_ratio", "1", "", "largest rho/rho0 of a particle", every, Needs::nothing, without_interval, 0},
    {"largest_cfl", "1", "", "largest CFL number of a step", every, Needs::nothing, without_interval, 0},
    {"hot_spot_work_J_m3", "J/m3", "", "99.9 percentile by mass of the plastic work per volume at the end",
     every, Needs::nothing, with_interval},
    {"hot_spot_temperature_K", "K", "", "99.9 percentile by mass of the temperature at the end",
     every, Needs::nothing, with_interval},
    {"hot_spot_x_m", "m", "", "mass centre of the hot spot, along x", every, Needs::nothing, with_interval},
    {"hot_spot_y_m", "m", "", "mass centre of the hot spot, along y", every, Needs::nothing, with_interval},

    {"aspect_ratio", "1", "", "width / height of the cavity at the end", cavity, Needs::nothing, with_interval},
    {"lower_upper_area_ratio", "1", "", "area of the cavity below / above its centre at the end",
     cavity, Needs::nothing, with_interval},
    {"centroid_shift_m", "m", "", "way of the cavity's centroid against the body's centre of mass",
     cavity, Needs::nothing, with_interval},
    {"final_void_area_m2", "m2", "A", "area of the empty region at the end",
     cavity, Needs::nothing, with_interval, 0},
    {"final_area_scatter_m2", "m2", "", "standard deviation of the area over the last quarter of the run",
     cavity, Needs::nothing, without_interval, 0},
    {"final_area_difference_m2", "m2", "", "mean difference between contour and empty region there",
     cavity, Needs::nothing, without_interval, 0},
    {"largest_collapsibility", "1", "", "(initial - smallest area) / initial area",
     cavity, Needs::nothing, with_interval, -infinity, 1, 0.1},
    {"cavity_closed_time_s", "s", "t", "when the empty region was first gone", cavity, Needs::nothing, with_interval},
    {"cavity_joined_outside_time_s", "s", "t", "when the empty region first met the outside",
     cavity, Needs::nothing, with_interval},
    {"contour_crossed_time_s", "s", "t", "when the contour of markers first crossed itself",
     cavity, Needs::nothing, with_interval},
    {"topology_changed_time_s", "s", "t", "when the cavity was first no longer one closed hole",
     cavity, Needs::nothing, with_interval},
    {"area_difference_m2", "m2", "", "most that contour and empty region differed by up to then",
     cavity, Needs::nothing, without_interval, 0},
    {"new_cavities", "1", "", "most closed empty regions at one time beside the cavity",
     cavity, Needs::nothing, with_interval},
    {"new_cavities_time_s", "s", "t", "when the first of them was seen", cavity, Needs::nothing, with_interval},
    {"cavities_at_end", "1", "", "closed empty regions at the end", cavity, Needs::nothing, with_interval},
    {"jet_speed_m_s", "m/s", "", "largest speed of the jet's tip up to its impact",
     cavity, Needs::nothing, with_interval},
    {"jet_lead_m", "m", "", "largest height of the jet's tip above the shock", cavity, Needs::nothing, with_interval},
    {"jet_impact_time_s", "s", "t", "when the jet's tip reached the far wall", cavity, Needs::nothing, with_interval},
    {"jet_overtake_time_s", "s", "t", "when the jet's tip passed the shock", cavity, Needs::nothing, with_interval},

    {"ejected_mass_kg_m", "kg/m", "", "mass that has been ejected, of the whole width",
     cavity, Needs::ejection, with_interval},
    {"ejecta_speed_m_s", "m/s", "", "mean speed of what is ejected against the wall",
     cavity, Needs::ejection, with_interval},
    {"decision_time_s", "s", "t", "when the outcome was decided", cavity, Needs::ejection, with_interval},
    {"decision_margin", "1", "", "deciding speed / impact speed - 1", cavity, Needs::ejection, with_interval},

    {"shock_normal_stress_Pa", "Pa", "", "normal stress behind the plastic front", planar, Needs::nothing, with_interval},
    {"shock_pressure_Pa", "Pa", "P", "pressure there", planar, Needs::nothing, with_interval},
    {"shock_von_mises_Pa", "Pa", "q", "von Mises stress there", planar, Needs::nothing, with_interval},
    {"plateau_noise", "1", "", "rms deviation of the normal stress there / its mean",
     planar, Needs::nothing, without_interval, 0},
    {"plastic_wave_speed_m_s", "m/s", "", "Lagrangian speed of the plastic front", planar, Needs::nothing, with_interval},
    {"elastic_wave_speed_m_s", "m/s", "", "Lagrangian speed of the elastic front", planar, Needs::nothing, with_interval},
    {"elastic_limit_stress_Pa", "Pa", "", "normal stress behind the elastic precursor",
     planar, Needs::nothing, with_interval},
    {"free_surface_speed_m_s", "m/s", "", "speed of the free surface after the shock",
     planar, Needs::nothing, with_interval},

    {"stop_radius_m", "m", "", "smallest inner radius of the shell", shell, Needs::nothing, with_interval},
    {"stop_time_s", "s", "t", "when the shell's inner surface stops", shell, Needs::nothing, with_interval},
    {"roundness", "1", "", "(largest - smallest) / mean inner radius at the stop",
     shell, Needs::nothing, with_interval, 0},
};
// clang-format on

}  // namespace

std::span<const ResultRow> results() { return table; }

std::span<const std::string_view> outcomes_of(SceneKind kind) {
  static constexpr std::string_view of_a_cavity[] = {"collapsed", "partial", "ejected", "arrested"};
  static constexpr std::string_view of_a_shell[] = {"arrested"};
  if (has_cavity(kind)) return of_a_cavity;
  if (shell(kind)) return of_a_shell;
  return {};
}

const ResultRow* find_result(std::string_view name) {
  for (const ResultRow& row : table)
    if (row.name == name) return &row;
  return nullptr;
}

}  // namespace mpm
