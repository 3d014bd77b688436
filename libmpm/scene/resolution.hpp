#pragma once
/// Parts of a body that are thinner than the grid shows.
#include <string_view>
#include <vector>

#include "libmpm/scene/scene.hpp"

namespace mpm {

/// Below so many cells across, what becomes of a part says nothing about the part: neighbouring cells share
/// every node of it, and a wall tears or a gap closes where the grid says so.
inline constexpr double least_cells_across = 2;

struct Part {
  std::string_view part;       ///< for people: "the wall above the cavity"
  std::string_view parameter;  ///< of the table of parameters, that decides its size
  double size;                 ///< across [m]
};

struct ThinPart : Part {
  double cells;  ///< size / cell_size
};

/// All parts below least_cells_across, in a scene without problems (find_problems).
std::vector<ThinPart> thin_parts(const Scene&);

}  // namespace mpm
