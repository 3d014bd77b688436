#pragma once
/// What a shape function must offer. All of ours are products of one-dimensional functions that reach three
/// nodes an axis.
#include <array>
#include <concepts>

#include "libmpm/core/grid.hpp"

namespace mpm {

/// Values and slopes at the three nodes first, first + 1, first + 2 of one axis.
struct Weights {
  int first = 0;
  std::array<double, 3> value{};
  std::array<double, 3> slope{};  ///< per cell: divide by the cell size for a gradient
};

/// The node nearest to xi (cells, xi > -3/2). A conversion, since std::floor is a call on plain x86-64.
inline int nearest_node(double xi) { return static_cast<int>(xi + 1.5) - 1; }

/// evaluate(xi, half): xi position, half half-size of the particle's domain, both in cells.
template <class T>
concept ShapeFunctions = requires(double xi, double half) {
  { T::evaluate(xi, half) } -> std::same_as<Weights>;
  { T::domains_follow_stretch } -> std::convertible_to<bool>;
};

/// The weights of one particle on its 3 x 3 nodes.
struct Stencil {
  Weights x, y;

  double weight(int i, int j) const { return x.value[i] * y.value[j]; }
  Vec2 gradient(int i, int j, const Vec2& inverse_cell) const {
    return {x.slope[i] * y.value[j] * inverse_cell.x(), x.value[i] * y.slope[j] * inverse_cell.y()};
  }
};

template <ShapeFunctions Shape>
Stencil stencil_at(const Grid& grid, const Vec2& position, const Vec2& half_size) {
  const Vec2 xi = (position - grid.origin()).cwiseProduct(grid.inverse_cell());
  const Vec2 half = half_size.cwiseProduct(grid.inverse_cell());
  return {Shape::evaluate(xi.x(), half.x()), Shape::evaluate(xi.y(), half.y())};
}

}  // namespace mpm
