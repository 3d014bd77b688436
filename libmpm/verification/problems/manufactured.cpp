#include "libmpm/verification/problems/manufactured.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>

#include "libmpm/verification/exact/axis_aligned.hpp"
#include "libmpm/verification/exact/vortex.hpp"
#include "libmpm/verification/problems/neo_hookean_body.hpp"
#include "libmpm/verification/problems/with_shape.hpp"

namespace mpm::verification {
namespace {

exact::Vector from(const mpm::Vec2& v) { return {v.x(), v.y()}; }
mpm::Vec2 to(const exact::Vector& v) { return {v.x, v.y}; }

/// Root mean square over the particles of |x - exact|; infinite if one of them is lost.
template <class Solution>
double error_now(NeoHookeanBody& body, const Solution& solution) {
  const mpm::Grid& g = body.grid();
  const mpm::Particles& ps = body.particles();
  const auto& initial = body.initial();
  double sum = 0;
  for (std::size_t p = 0; p < initial.size(); ++p) {
    const mpm::Vec2& x = ps.position[p];
    const mpm::Vec2 cells = (x - g.origin()).cwiseProduct(g.inverse_cell());
    if (!(cells.minCoeff() >= 0 && cells.maxCoeff() <= g.columns()))
      return std::numeric_limits<double>::infinity();
    sum += (x - to(solution.position(from(initial[p]), body.time()))).squaredNorm();
  }
  return std::sqrt(sum / static_cast<double>(initial.size()));
}

/// The square of `columns` cells from `origin`, with what `inside(X)` says of it, driven over `end` seconds.
template <class Solution, class Inside>
double drive(const Manufactured& m, const Solution& solution, double end, const mpm::Vec2& origin,
             int columns, std::optional<int> ceiling, const Inside& inside) {
  const double cell = 1.0 / m.cells, share = cell / m.side;
  const int steps = static_cast<int>(std::ceil(end * solution.solid.longitudinal_speed() / (m.cfl * cell)));
  const double dt = end / steps;
  NeoHookeanBody body(solution.solid, origin, cell, columns);
  for (int j = 0; j < columns * m.side; ++j)
    for (int i = 0; i < columns * m.side; ++i) {
      const mpm::Vec2 x = origin + share * mpm::Vec2(i + 0.5, j + 0.5);
      if (!inside(x)) continue;
      // velocities belong to half a step before
      body.add(x, to(solution.velocity(from(x), -dt / 2)), share * share, share / 2);
    }
  const int n = m.force_points;
  const auto force = [&](const mpm::Vec2& x, double t) {
    mpm::Vec2 sum(0, 0);
    for (int j = 0; j < n; ++j)
      for (int i = 0; i < n; ++i)
        sum +=
            to(solution.body_force(from(x + share * mpm::Vec2((i + 0.5) / n - 0.5, (j + 0.5) / n - 0.5)), t));
    return mpm::Vec2(sum / (n * n));
  };
  return with_shape(m.shape, [&]<class Shape>() {
    body.begin<Shape>({ceiling, force});
    double error = 0;
    for (int k = 0; k < steps && std::isfinite(error); ++k) {
      body.step(dt);
      error = std::max(error, error_now(body, solution));
    }
    return error / m.amplitude;
  });
}

}  // namespace

double axis_aligned_error(const Manufactured& m) {
  const exact::AxisAligned solution{exact::NeoHookean::of(1, 1, 0.3), m.amplitude};
  return drive(m, solution, solution.period(), {0, 0}, m.cells, m.cells,
               [](const mpm::Vec2&) { return true; });
}

double vortex_error(const Manufactured& m) {
  const exact::Vortex solution{exact::NeoHookean::of(1, 1, 0.3), m.amplitude};
  const int half = static_cast<int>(std::ceil(1.5 * m.cells));
  const double corner = -half / static_cast<double>(m.cells);
  return drive(m, solution, solution.period, {corner, corner}, 2 * half, std::nullopt,
               [](const mpm::Vec2& x) { return x.norm() >= 0.6 && x.norm() <= 1.4; });
}

}  // namespace mpm::verification
