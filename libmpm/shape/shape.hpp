#pragma once
/// What a shape function must offer. Most of ours are products of one-dimensional functions; what the product
/// is belongs to the space, see space/stencil.hpp.
#include <array>
#include <concepts>
#include <type_traits>

#include "libmpm/core/grid.hpp"
#include "libmpm/core/particles.hpp"
#include "libmpm/space/space.hpp"
#include "libmpm/space/stencil.hpp"

namespace mpm {

/// The node nearest to xi (cells, xi > -3/2). A conversion, since std::floor is a call on plain x86-64.
inline int nearest_node(double xi) { return static_cast<int>(xi + 1.5) - 1; }

/// A product of one-dimensional functions. evaluate(xi, half): xi position, half half-size of the particle's
/// domain, both in cells.
template <class T>
concept ProductShape = requires(double xi, double half) {
  T::evaluate(xi, half).value;
};

template <ProductShape Shape, int axes>
auto stencil_at(const BasicGrid<axes>& grid, const std::type_identity_t<Vec<axes>>& position,
                const std::type_identity_t<Vec<axes>>& half_size) {
  return product_stencil<Shape, axes>(grid, position, half_size);
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
auto stencil_of(const BasicGrid<Space::axes>& grid, const BasicParticles<Space::axes>& particles,
                std::size_t p) {
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

/// follow(grid, particles, p, growth): the particle's domain follows dt L.
template <class T>
concept ShapeFunctions = requires(const Grid& grid, Particles& particles, const Mat2& growth) {
  { T::reach } -> std::convertible_to<int>;
  stencil_of<T>(grid, particles, 0);
  T::follow(grid, particles, 0, growth);
};

/// A shape function that can be used in a space.
template <class T, class Space>
concept ShapeIn = ShapeFunctions<T> &&
    (!Space::has_hoop || HoopShape<T>)&&(Space::axes == 2 || ProductShape<T>);

}  // namespace mpm
