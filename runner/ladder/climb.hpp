#pragma once
/// When a ladder of cells is high enough. Pure.
#include <optional>
#include <span>
#include <string>

#include "analysis/extrapolation.hpp"
#include "runner/study/ladder_request.hpp"

namespace mpmstudy {

/// What a result can be at all.
analysis::Bounds bounds_of(const std::string& quantity);

/// What half widths are relative to. The absolute value; but of a share of the whole that may be close to
/// nothing (collapsibility, largest_collapsibility) no less than a tenth: 1 % of it is then 0.001.
double accuracy_scale(const std::string& quantity, double value);

/// The half width that a request with an accuracy wants of its quantity.
double wanted_error(const LadderRequest&, double value);

/// One rung of a ladder as far as it is known.
struct RungState {
  bool decided = false;                        ///< done or failed
  std::optional<analysis::LadderPoint> point;  ///< empty: not done, or it does not show the quantity
};

enum class NextStep {
  wait,     ///< a rung that was asked for is not decided
  climb,    ///< one more cell
  reached,  ///< the interval is inside
  missed    ///< it is not, and no finer cell is asked for: the ladder is at its limit, its finest rung failed
          ///< or does not show the quantity, or the measuring error alone is too large and finer cells do not
          ///< make it smaller (a ring-down that has not ended)
};

struct Climb {
  NextStep step;
  std::string reason;  ///< why it climbs, for people; else ""
};

/// rungs: those that were asked for, coarse to fine, first_cells or more. The request has an accuracy.
Climb next_step(const LadderRequest&, std::span<const RungState> rungs);

}  // namespace mpmstudy
