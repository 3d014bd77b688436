#pragma once
#include <optional>
#include <span>

namespace mpmstudy {

/// A critical value found on one cell.
struct CellBracket {
  double cell = 0;  ///< [m]
  double lower = 0, upper = 0;

  double middle() const { return 0.5 * (lower + upper); }
  double half_width() const { return 0.5 * (upper - lower); }
};

struct CriticalValue {
  double value = 0;
  double interval = 0;  ///< half width
};

/// The critical value for cells of size 0, first order in the cell from the two finest: separation comes a
/// cell early, which is an error of first order. The half width is the whole way of the extrapolation plus
/// what the widths of the brackets leave open, with three cells at least half of the difference before the
/// last. Where three cells do not come closer, the value is that of the finest and the half width the last
/// difference; where they turn, the larger difference. Empty for less than two cells. `cells`: coarse first.
std::optional<CriticalValue> critical_value_at_cell_0(std::span<const CellBracket> cells);

}  // namespace mpmstudy
