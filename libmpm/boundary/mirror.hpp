#pragma once
/// Walls as mirrors. What lies behind a mirror is the image of the body: nodes behind it hold the image of
/// those before it, and shape functions keep partition of unity and linear reproduction up to the wall.
#include "libmpm/core/grid.hpp"

namespace mpm {

/// Rigid, frictionless, two-sided mirrors at x = origin and x = origin + width: a periodic row of images.
/// Call after p2g, before forces become accelerations. Normal momentum and force on the wall's nodes vanish.
void reflect_sides(Grid&, int top_row);

/// What the line y = origin is.
enum class Floor {
  impact_wall,  ///< rigid, frictionless, one-sided
  mirror        ///< two-sided: what lies below is the image of what lies above
};

/// The floor. An impact wall pushes and does not pull: it is a mirror in every column where the body's own
/// motion would take it through the wall by the end of the step, nothing elsewhere. Call after reflect_sides,
/// which makes the decision of image columns that of their originals.
void reflect_floor(Grid&, Floor, double time_step);

}  // namespace mpm
