#pragma once
/// What a shape function must offer. All of ours are products of one-dimensional functions that reach three
/// nodes per axis.
#include <array>
#include <concepts>

#include "libmpm/core/grid.hpp"
#include "libmpm/core/particles.hpp"
#include "libmpm/space/space.hpp"

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

/// The node nearest to xi (cells, xi > -3/2). A conversion, since std::floor is a call on plain x86-64.
inline int nearest_node(double xi) { return static_cast<int>(xi + 1.5) - 1; }

/// The weights of one particle on its N x N nodes.
template <int N>
struct ProductStencil {
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

/// With the weights of the hoop, see HoopShape.
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

/// A product of one-dimensional functions. evaluate(xi, half): xi position, half half-size of the particle's
/// domain, both in cells.
template <class T>
concept ProductShape = requires(double xi, double half) {
  T::evaluate(xi, half).value;
};

template <ProductShape Shape>
auto stencil_at(const Grid& grid, const Vec2& position, const Vec2& half_size) {
  const Vec2 xi = (position - grid.origin()).cwiseProduct(grid.inverse_cell());
  const Vec2 half = half_size.cwiseProduct(grid.inverse_cell());
  const auto x = Shape::evaluate(xi.x(), half.x());
  return ProductStencil<decltype(x)::nodes>{x, Shape::evaluate(xi.y(), half.y())};
}

/// A shape function S that can be used in axisymmetry. With the particle's extent r_p - l ... r_p + l
/// (cells), the hoop weights h make radial slope and hoop together an integral over the particle's own
/// extent,
///   S'(r_p) r_p + h = (1 / 2l) integral d(r S)/dr dr,
/// so that the forces of a uniform pressure add up to nothing at every node, the axis included, as long as
/// the extents fill the body. hoop(xi, half) as evaluate().
template <class T>
concept HoopShape = ProductShape<T> && requires(double xi, double half) {
  { T::hoop(xi, half) } -> std::same_as<std::array<double, 3>>;
};

/// The stencil of a particle with any shape function.
template <class Shape, class Space = space::PlaneStrain>
auto stencil_of(const Grid& grid, const Particles& particles, std::size_t p) {
  if constexpr (Space::has_hoop) {
    static_assert(HoopShape<Shape>);
    const double inverse = grid.inverse_cell().x();
    const double xi = (particles.position[p].x() - grid.origin().x()) * inverse;
    return AxialStencil{stencil_at<Shape>(grid, particles.position[p], particles.half_size[p]),
                        Shape::hoop(xi, particles.half_size[p].x() * inverse)};
  } else if constexpr (ProductShape<Shape>)
    return stencil_at<Shape>(grid, particles.position[p], particles.half_size[p]);
  else
    return Shape::stencil(grid, particles, p);
}

template <class T>
concept ShapeFunctions = requires(const Grid& grid, Particles& particles, const Mat2& growth) {
  { T::reach } -> std::convertible_to<int>;
  stencil_of<T>(grid, particles, 0);
  T::follow(grid, particles, 0, growth);
};

}  // namespace mpm
