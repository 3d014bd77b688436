#include "runner/finish/fields.hpp"

#include <cmath>
#include <stdexcept>

#include "libmpm/io/fields.hpp"
#include "libmpm/scene/build.hpp"

namespace mpmstudy {
namespace {

/// Edge of a particle's section [m].
double edge_of(const mpm::Snapshot& s, std::size_t p) {
  const double volume = s.mass[p] / s.density[p];
  return s.has_depth() ? std::cbrt(volume) : std::sqrt(volume);
}

}  // namespace

/// Of three axes the particles that are nearest to z = 0: less than their own edge away.
analysis::ParticleSquares particles_of(const mpm::Snapshot& s, const std::string& field,
                                       const std::vector<int>& materials) {
  const mpm::Field* row = mpm::find_field(field);
  if (!row) throw std::runtime_error("a snapshot has no field " + field);
  const std::vector<double>& values = s.*row->values;
  if (values.size() != s.x.size()) throw std::runtime_error("a snapshot of two axes has no field " + field);
  const bool several = materials.size() == s.x.size();
  analysis::ParticleSquares particles;
  for (std::size_t p = 0; p < s.x.size(); ++p) {
    const double edge = edge_of(s, p);
    if (s.has_depth() && !(std::abs(s.z[p]) < edge)) continue;
    particles.x.push_back(s.x[p]), particles.y.push_back(s.y[p]);
    particles.size.push_back(edge), particles.value.push_back(values[p]);
    if (several) particles.material.push_back(materials[p]);
  }
  return particles;
}

std::vector<int> materials_of(const mpm::Scene& scene) {
  std::vector<int> numbers;
  if (mpm::material_count(scene) < 2) return numbers;
  const auto ends = mpm::axes_of(scene.space) == 2 ? mpm::build_state<2>(scene).particles.material_ends
                                                   : mpm::build_state<3>(scene).particles.material_ends;
  for (std::size_t m = 0; m < ends.size(); ++m) numbers.resize(ends[m], static_cast<int>(m));
  return numbers;
}

}  // namespace mpmstudy
