#include "runner/finish/fields.hpp"

#include <cmath>
#include <stdexcept>

#include "libmpm/io/fields.hpp"

namespace mpmstudy {
analysis::Particles particles_of(const mpm::Snapshot& s, const std::string& field) {
  const mpm::Field* row = mpm::find_field(field);
  if (!row) throw std::runtime_error("a snapshot has no field " + field);
  analysis::Particles particles{s.x, s.y, {}, s.*row->values};
  for (std::size_t p = 0; p < s.mass.size(); ++p)
    particles.size.push_back(std::sqrt(s.mass[p] / s.density[p]));
  return particles;
}

}  // namespace mpmstudy
