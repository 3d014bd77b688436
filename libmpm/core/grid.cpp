#include "libmpm/core/grid.hpp"

#include <algorithm>

namespace mpm {

template <int axes>
BasicGrid<axes>::BasicGrid(Vector origin, Vector cell, int columns) requires(axes == 2)
    : origin_(origin),
      cell_(cell),
      inverse_cell_(cell.cwiseInverse()),
      columns_(columns),
      stride_(columns + 1 + 2 * ghosts) {}

template <int axes>
BasicGrid<axes>::BasicGrid(Vector origin, Vector cell, int columns, int slices) requires(axes == 3)
    : origin_(origin),
      cell_(cell),
      inverse_cell_(cell.cwiseInverse()),
      columns_(columns),
      stride_(columns + 1 + 2 * ghosts),
      slices_(slices),
      layers_(slices + 1 + 2 * ghosts) {}

template <int axes>
bool BasicGrid<axes>::holds(const Vector& x) const {
  const Vector low = origin_ - 0.5 * cell_;
  const double right = origin_.x() + (columns_ + 0.5) * cell_.x();
  bool inside = x.x() > low.x() && x.x() < right && x.y() > low.y();
  if constexpr (axes == 3) inside &= x.z() > low.z() && x.z() < origin_.z() + (slices_ + 0.5) * cell_.z();
  return inside;
}

template <int axes>
void BasicGrid<axes>::grow_to_row(int top) {
  if (top + 2 <= rows_) return;
  rows_ = top + 2 + top / 4;  // room for a body on the move
  const std::size_t row = static_cast<std::size_t>(stride_) * static_cast<std::size_t>(layers_);
  nodes_.resize(static_cast<std::size_t>(rows_ + ghosts - 1) * row);
}

template <int axes>
void BasicGrid<axes>::clear() {
  std::fill(nodes_.begin(), nodes_.end(), NodeType{});
}

template class BasicGrid<2>;
template class BasicGrid<3>;

}  // namespace mpm
