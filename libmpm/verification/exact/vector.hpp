#pragma once

namespace mpm::verification::exact {

/// A point or a vector of the plane: (x, y).
struct Vector {
  double x, y;
};

}  // namespace mpm::verification::exact
