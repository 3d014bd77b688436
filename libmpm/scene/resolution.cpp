#include "libmpm/scene/resolution.hpp"

#include <algorithm>

#include "libmpm/scene/kinds/kind.hpp"

namespace mpm {

std::vector<ThinPart> thin_parts(const Scene& s) {
  // A wall of exactly two cells comes out of a difference, a few last digits less.
  constexpr double rounding = 1e-9;
  std::vector<ThinPart> thin;
  for (Part part : kind_of(s).parts(s)) {
    part.size = std::max(part.size, 0.0);
    const double cells = part.size / s.numerics.cell_size;
    if (cells < rounding) continue;  // a cavity that touches: there is no such part
    if (cells < least_cells_across - rounding) thin.push_back({part, cells});
  }
  return thin;
}

}  // namespace mpm
