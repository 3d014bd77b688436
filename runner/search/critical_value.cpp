#include "runner/search/critical_value.hpp"

#include <algorithm>
#include <cmath>

namespace mpmstudy {

std::optional<CriticalValue> critical_value_at_cell_0(std::span<const CellBracket> cells) {
  if (cells.size() < 2) return std::nullopt;
  const CellBracket &fine = cells[cells.size() - 1], &coarse = cells[cells.size() - 2];
  const double slope = fine.cell / (coarse.cell - fine.cell);
  double way = (fine.middle() - coarse.middle()) * slope;
  double doubt = std::abs(way);
  if (cells.size() > 2) {
    const double before = coarse.middle() - cells[cells.size() - 3].middle();
    const double last = fine.middle() - coarse.middle();
    if (last * before < 0) {  // they turn: there is no line to go on with
      way = 0;
      doubt = std::max(std::abs(last), std::abs(before));
    } else if (std::abs(last) > std::abs(before)) {  // they do not come closer
      way = 0;
      doubt = std::abs(last);
    } else if (way == 0) {
      doubt = std::abs(before);
    } else {  // closer than first order on halved cells may be chance
      doubt = std::max(doubt, 0.5 * std::abs(before));
    }
  }
  const double widths = fine.half_width() * (1 + slope) + coarse.half_width() * slope;
  return CriticalValue{fine.middle() + way, doubt + widths};
}

}  // namespace mpmstudy
