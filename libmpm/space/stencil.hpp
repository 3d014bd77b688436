#pragma once
/// The nodes that a particle reaches, as the product of one-dimensional functions along the axes of a space.
#include <array>

#include "libmpm/core/grid.hpp"

namespace mpm {

/// Values and slopes at the N nodes first ... first + N - 1 of one axis.
template <int N>
struct WeightsOn {
  static constexpr int nodes = N;
  int first = 0;
  std::array<double, N> value{};
  std::array<double, N> slope{};  ///< per cell: divide by the cell size for a gradient
};
using Weights = WeightsOn<3>;

/// The weights of one particle on its N x N nodes, of three axes N x N x N.
template <int N, int axes = 2>
struct ProductStencil;

template <int N>
struct ProductStencil<N, 2> {
  WeightsOn<N> x, y;

  double weight(int i, int j) const { return x.value[i] * y.value[j]; }
  Vec2 gradient(int i, int j, const Vec2& inverse_cell) const {
    return {x.slope[i] * y.value[j] * inverse_cell.x(), x.value[i] * y.slope[j] * inverse_cell.y()};
  }
  /// Calls visit(node, weight, gradient) for every node, row by row. AnyGrid: Grid or const Grid.
  template <class AnyGrid, class Visit>
  void for_each(AnyGrid& grid, Visit visit) const {
    for (int j = 0; j < N; ++j) {
      auto* row = &grid.at(x.first, y.first + j);
      for (int i = 0; i < N; ++i) visit(row[i], weight(i, j), gradient(i, j, grid.inverse_cell()));
    }
  }
};
using Stencil = ProductStencil<3>;

template <int N>
struct ProductStencil<N, 3> {
  WeightsOn<N> x, y, z;

  /// Calls visit(node, weight, gradient) for every node, in the order of memory.
  template <class AnyGrid, class Visit>
  void for_each(AnyGrid& grid, Visit visit) const {
    const Vec3& inverse = grid.inverse_cell();
    for (int j = 0; j < N; ++j)
      for (int k = 0; k < N; ++k) {
        const double yz = y.value[j] * z.value[k];
        const double y_slope = y.slope[j] * z.value[k] * inverse.y();
        const double z_slope = y.value[j] * z.slope[k] * inverse.z();
        auto* row = &grid.at(x.first, y.first + j, z.first + k);
        for (int i = 0; i < N; ++i)
          visit(row[i], x.value[i] * yz,
                Vec3(x.slope[i] * inverse.x() * yz, x.value[i] * y_slope, x.value[i] * z_slope));
      }
  }
};

/// With the weights of the hoop, see HoopShape in shape/shape.hpp.
struct AxialStencil : Stencil {
  std::array<double, 3> hoop{};

  /// Calls visit(node, weight, gradient, hoop weight) for every node, row by row.
  template <class AnyGrid, class Visit>
  void for_each(AnyGrid& grid, Visit visit) const {
    for (int j = 0; j < 3; ++j) {
      auto* row = &grid.at(x.first, y.first + j);
      for (int i = 0; i < 3; ++i)
        visit(row[i], weight(i, j), gradient(i, j, grid.inverse_cell()), hoop[i] * y.value[j]);
    }
  }
};

/// The product of the one-dimensional functions of Shape, for a particle there.
template <class Shape, int axes>
auto product_stencil(const BasicGrid<axes>& grid, const Vec<axes>& position, const Vec<axes>& half_size) {
  const Vec<axes> xi = (position - grid.origin()).cwiseProduct(grid.inverse_cell());
  const Vec<axes> half = half_size.cwiseProduct(grid.inverse_cell());
  const auto x = Shape::evaluate(xi.x(), half.x());
  using Stencil = ProductStencil<decltype(x)::nodes, axes>;
  if constexpr (axes == 2)
    return Stencil{x, Shape::evaluate(xi.y(), half.y())};
  else
    return Stencil{x, Shape::evaluate(xi.y(), half.y()), Shape::evaluate(xi.z(), half.z())};
}

}  // namespace mpm
