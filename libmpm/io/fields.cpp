#include "libmpm/io/fields.hpp"

namespace mpm {
namespace {

/// Of a column of the material; 0 where its model has none of that name.
template <int axes>
double number_of(const BasicState<axes>& s, std::string_view column, std::size_t p) {
  const std::span<const double> values = s.particles.own_values(column);
  return values.empty() ? 0 : values[p];
}

#define OF [](const auto& s, std::size_t p, [[maybe_unused]] const Temperature& temperature) -> double
#define OF_THREE_AXES [](const BasicState<3>& s, std::size_t p, const Temperature&) -> double
// clang-format off
/// Stress is without artificial viscosity, as the pressure is.
constexpr Field table[] = {
    {"velocity_x", "m/s", "", "Velocity along x", "", &Snapshot::velocity_x,
     OF { return s.particles.velocity[p].x(); }},
    {"velocity_y", "m/s", "", "Velocity along y", "", &Snapshot::velocity_y,
     OF { return s.particles.velocity[p].y(); }},
    {"velocity_z", "m/s", "", "Velocity along z", "", &Snapshot::velocity_z,
     OF_THREE_AXES { return s.particles.velocity[p].z(); }},
    {"density", "kg/m^3", "ρ", "", "Density", &Snapshot::density,
     OF { return s.particles.density(p); }},
    {"pressure", "Pa", "P", "", "Pressure", &Snapshot::pressure,
     OF { return s.particles.pressure[p]; }},
    {"von_mises", "Pa", "q", "Von Mises stress", "VonMises", &Snapshot::von_mises,
     OF { return von_mises(s.particles.deviator[p]); }},
    {"stress_xx", "Pa", "", "", "StressXX", &Snapshot::stress_xx,
     OF { return s.particles.deviator[p].xx - s.particles.pressure[p]; }},
    {"stress_yy", "Pa", "", "", "StressYY", &Snapshot::stress_yy,
     OF { return s.particles.deviator[p].yy - s.particles.pressure[p]; }},
    {"stress_xy", "Pa", "", "Shear stress xy", "StressXY", &Snapshot::stress_xy,
     OF { return s.particles.deviator[p].xy; }},
    {"stress_zz", "Pa", "", "", "StressZZ", &Snapshot::stress_zz,
     OF { return s.particles.deviator[p].zz - s.particles.pressure[p]; }},
    {"stress_xz", "Pa", "", "Shear stress xz", "StressXZ", &Snapshot::stress_xz,
     OF_THREE_AXES { return s.particles.deviator[p].xz; }},
    {"stress_yz", "Pa", "", "Shear stress yz", "StressYZ", &Snapshot::stress_yz,
     OF_THREE_AXES { return s.particles.deviator[p].yz; }},
    {"equivalent_plastic_strain", "1", "", "", "PlasticStrain", &Snapshot::equivalent_plastic_strain,
     OF { return number_of(s, "plastic_strain", p); }},
    {"plastic_work", "J/m^3", "", "", "PlasticWork", &Snapshot::plastic_work,
     OF { return number_of(s, "plastic_work", p) * s.particles.density(p); }},
    {"specific_internal_energy", "J/kg", "e", "", "InternalEnergy", &Snapshot::specific_internal_energy,
     OF { return s.particles.energy[p]; }},
    {"temperature", "K", "T", "", "Temperature", &Snapshot::temperature,
     OF { return temperature(s.particles.dilation[p], s.particles.energy[p]); }},
    {"mass", "kg/m", "", "", "Mass", &Snapshot::mass,
     OF { return s.space == Space::axisymmetric ? s.particles.density(p) * filled(s, p) : s.particles.mass[p]; }, "kg"},
};
// clang-format on
#undef OF
#undef OF_THREE_AXES

// Beside time and step: x, y, z, and a row for each other column.
static_assert(sizeof(Snapshot) == sizeof(Snapshot::time) + sizeof(Snapshot::step) +
                                      (3 + std::size(table)) * sizeof(std::vector<double>),
              "a column of Snapshot has no row in the table of fields");

}  // namespace

std::span<const Field> fields() { return table; }

const Field* find_field(std::string_view name) {
  for (const Field& field : table)
    if (field.name == name) return &field;
  return nullptr;
}

}  // namespace mpm
