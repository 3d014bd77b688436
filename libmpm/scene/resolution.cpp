#include "libmpm/scene/resolution.hpp"

#include <algorithm>

namespace mpm {

std::vector<ThinPart> thin_parts(const Scene& s) {
  std::vector<ThinPart> parts;
  const double h = s.numerics.cell_size;
  // A wall of exactly two cells comes out of a difference, a few last digits less.
  constexpr double rounding = 1e-9;
  const auto look = [&](std::string_view part, std::string_view parameter, double size) {
    const double cells = std::max(size, 0.0) / h;
    if (cells < rounding) return;  // a cavity that touches: there is no such part
    if (cells < least_cells_across - rounding) parts.push_back({part, parameter, std::max(size, 0.0), cells});
  };
  const double r = s.cavity_radius, y = s.cavity_center_height;
  if (has_cavity(s.kind)) {
    look("the wall above the cavity", "wall_thickness", s.block_height - y - r);
    look("the wall below the cavity", "cavity_center_height", y - r);
    look("the wall between the cavity and its mirror image", "block_width", s.block_width - 2 * r);
    look("the cavity", "cavity_radius", 2 * r);
  }
  if (s.kind == SceneKind::imploding_shell) {
    look("the wall of the shell", "outer_radius", s.outer_radius - s.inner_radius);
    look("the hole of the shell", "inner_radius", 2 * s.inner_radius);
  }
  return parts;
}

}  // namespace mpm
