#include "runner/finish/fields.hpp"

#include <cmath>
#include <stdexcept>

namespace mpmstudy {
namespace {

/// The column of a snapshot that a study calls by this name.
const std::vector<double>& field_of(const mpm::Snapshot& s, const std::string& name) {
  const std::pair<const char*, const std::vector<double>*> columns[] = {
      {"velocity_x", &s.velocity_x},     {"velocity_y", &s.velocity_y},
      {"density", &s.density},           {"pressure", &s.pressure},
      {"stress_xx", &s.stress_xx},       {"stress_yy", &s.stress_yy},
      {"stress_xy", &s.stress_xy},       {"stress_zz", &s.stress_zz},
      {"von_mises", &s.von_mises},       {"equivalent_plastic_strain", &s.equivalent_plastic_strain},
      {"plastic_work", &s.plastic_work}, {"specific_internal_energy", &s.specific_internal_energy},
      {"temperature", &s.temperature}};
  for (const auto& [known, column] : columns)
    if (name == known) return *column;
  throw std::runtime_error("a snapshot has no field " + name);
}

}  // namespace

analysis::Particles particles_of(const mpm::Snapshot& s, const std::string& field) {
  analysis::Particles particles{s.x, s.y, {}, field_of(s, field)};
  for (std::size_t p = 0; p < s.mass.size(); ++p)
    particles.size.push_back(std::sqrt(s.mass[p] / s.density[p]));
  return particles;
}

}  // namespace mpmstudy
