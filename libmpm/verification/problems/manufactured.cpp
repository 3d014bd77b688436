#include "libmpm/verification/problems/manufactured.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <optional>
#include <stdexcept>
#include <type_traits>
#include <utility>

#include "libmpm/verification/exact/axis_aligned.hpp"
#include "libmpm/verification/exact/standing_waves.hpp"
#include "libmpm/verification/exact/vortex.hpp"
#include "libmpm/verification/problems/neo_hookean_body.hpp"
#include "libmpm/verification/problems/with_shape.hpp"

namespace mpm::verification {
namespace {

mpm::Vec2 to(const exact::Vector& v) { return {v.x, v.y}; }
mpm::Vec2 to(const std::array<double, 2>& v) { return {v[0], v[1]}; }
mpm::Vec3 to(const std::array<double, 3>& v) { return {v[0], v[1], v[2]}; }
/// As the solution takes it.
template <class Point>
Point from(const mpm::Vec2& v) {
  return {v.x(), v.y()};
}
template <class Point>
Point from(const mpm::Vec3& v) {
  return {v.x(), v.y(), v.z()};
}

/// An exact solution with points as the grid has them.
template <class Solution, int axes>
struct OnGrid {
  using Vector = mpm::Vec<axes>;
  using Point = std::decay_t<decltype(std::declval<Solution>().position({}, 0))>;

  const Solution& exact;

  Vector position(const Vector& x, double t) const { return to(exact.position(from<Point>(x), t)); }
  Vector velocity(const Vector& x, double t) const { return to(exact.velocity(from<Point>(x), t)); }
  Vector body_force(const Vector& x, double t) const { return to(exact.body_force(from<Point>(x), t)); }
};

/// Calls use(x) for the places of a lattice of n points along each axis, in units of their distance.
template <int axes, class Use>
void each_place(int n, Use use) {
  int count = 1;
  for (int k = 0; k < axes; ++k) count *= n;
  for (int number = 0; number < count; ++number) {
    mpm::Vec<axes> x;
    for (int k = 0, rest = number; k < axes; ++k, rest /= n) x[k] = rest % n + 0.5;
    use(x);
  }
}

/// Root mean square over the particles of |x - exact|; infinite if one of them is lost.
template <class Body, class Solution>
double error_now(Body& body, const Solution& solution) {
  using Vector = typename Body::Vector;
  const auto& g = body.grid();
  const auto& ps = body.particles();
  const auto& initial = body.initial();
  double sum = 0;
  for (std::size_t p = 0; p < initial.size(); ++p) {
    const Vector& x = ps.position[p];
    const Vector cells = (x - g.origin()).cwiseProduct(g.inverse_cell());
    if (!(cells.minCoeff() >= 0 && cells.maxCoeff() <= g.columns()))
      return std::numeric_limits<double>::infinity();
    sum += (x - solution.position(initial[p], body.time())).squaredNorm();
  }
  return std::sqrt(sum / static_cast<double>(initial.size()));
}

/// The square or the cube of `columns` cells from `origin`, with what `inside(X)` says of it, driven over
/// `end` seconds.
template <class Space = mpm::space::PlaneStrain, class Solution, class Inside>
double drive(const Manufactured& m, const Solution& exact_solution, double end,
             const mpm::Vec<Space::axes>& origin, int columns, std::optional<int> ceiling,
             const Inside& inside) {
  constexpr int axes = Space::axes;
  using Vector = mpm::Vec<axes>;
  const OnGrid<Solution, axes> solution{exact_solution};
  const double cell = 1.0 / m.cells, share = cell / m.side;
  const int steps =
      static_cast<int>(std::ceil(end * exact_solution.solid.longitudinal_speed() / (m.cfl * cell)));
  const double dt = end / steps;
  NeoHookeanBodyIn<Space> body(exact_solution.solid, origin, cell, columns);
  each_place<axes>(columns * m.side, [&](const Vector& place) {
    const Vector x = origin + share * place;
    // velocities belong to half a step before
    if (inside(x)) body.add(x, solution.velocity(x, -dt / 2), Vector::Constant(share).prod(), share / 2);
  });
  const auto force = [&, n = m.force_points](const Vector& x, double t) {
    Vector sum = Vector::Zero();
    each_place<axes>(n, [&](const Vector& place) {
      sum += solution.body_force(x + share * (place / n - Vector::Constant(0.5)), t);
    });
    return Vector(sum / std::pow(n, axes));
  };
  return with_shape(m.shape, [&]<class Shape>() -> double {
    if constexpr (!mpm::ShapeIn<Shape, Space>) {
      throw std::logic_error("a shape function that this space does not have");
    } else {
      body.template begin<Shape>({ceiling, force});
      double error = 0;
      for (int k = 0; k < steps && std::isfinite(error); ++k) {
        body.step(dt);
        error = std::max(error, error_now(body, solution));
      }
      return error / m.amplitude;
    }
  });
}

constexpr auto everywhere_inside = [](const auto&) { return true; };

}  // namespace

double axis_aligned_error(const Manufactured& m) {
  const exact::AxisAligned solution{exact::NeoHookean::of(1, 1, 0.3), m.amplitude};
  return drive(m, solution, solution.period(), {0, 0}, m.cells, m.cells, everywhere_inside);
}

double cube_waves_error(const Manufactured& m) {
  const exact::CubeWaves solution{exact::NeoHookean::of(1, 1, 0.3), m.amplitude};
  return drive<mpm::space::ThreeD>(m, solution, solution.period(), {0, 0, 0}, m.cells, m.cells,
                                   everywhere_inside);
}

double cylinder_waves_error(const Manufactured& m) {
  const exact::CylinderWaves solution{exact::NeoHookean::of(1, 1, 0.3), m.amplitude};
  return drive<mpm::space::Axisymmetric>(m, solution, solution.period(), {0, 0}, m.cells, m.cells,
                                         everywhere_inside);
}

double vortex_error(const Manufactured& m) {
  const exact::Vortex solution{exact::NeoHookean::of(1, 1, 0.3), m.amplitude};
  const int half = static_cast<int>(std::ceil(1.5 * m.cells));
  const double corner = -half / static_cast<double>(m.cells);
  return drive(m, solution, solution.period, {corner, corner}, 2 * half, std::nullopt,
               [](const mpm::Vec2& x) { return x.norm() >= 0.6 && x.norm() <= 1.4; });
}

}  // namespace mpm::verification
