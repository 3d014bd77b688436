#include "libmpm/core/grid.hpp"

#include <algorithm>

namespace mpm {

Grid::Grid(Vec2 origin, Vec2 cell, int columns)
    : origin_(origin),
      cell_(cell),
      inverse_cell_(1 / cell.x(), 1 / cell.y()),
      columns_(columns),
      stride_(columns + 1 + 2 * ghosts) {}

void Grid::grow_to_row(int top) {
  if (top + 2 <= rows_) return;
  rows_ = top + 2 + top / 4;  // room for a body on the move
  nodes_.resize(static_cast<std::size_t>(rows_ + ghosts - 1) * static_cast<std::size_t>(stride_));
}

void Grid::clear() { std::fill(nodes_.begin(), nodes_.end(), Node{}); }

}  // namespace mpm
