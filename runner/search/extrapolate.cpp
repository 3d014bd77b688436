#include "runner/search/extrapolate.hpp"

#include <algorithm>
#include <cmath>

namespace mpmstudy {

std::optional<Extrapolated> extrapolate(std::span<const CellBracket> cells) {
  if (cells.size() < 2) return std::nullopt;
  const CellBracket &fine = cells[cells.size() - 1], &coarse = cells[cells.size() - 2];
  const double slope = fine.cell / (coarse.cell - fine.cell);
  double way = (fine.middle() - coarse.middle()) * slope;
  double doubt = std::abs(way);
  if (cells.size() > 2) {
    const double before = std::abs(coarse.middle() - cells[cells.size() - 3].middle());
    const double last = std::abs(fine.middle() - coarse.middle());
    if (last > before) {  // they do not come closer: there is nothing to go on with
      way = 0;
      doubt = last;
    } else if (way == 0) {
      doubt = before;
    }
  }
  const double widths = fine.half_width() * (1 + slope) + coarse.half_width() * slope;
  return Extrapolated{fine.middle() + way, doubt + widths};
}

}  // namespace mpmstudy
