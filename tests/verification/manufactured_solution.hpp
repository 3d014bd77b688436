#pragma once
#include <algorithm>
#include <limits>
#include <numbers>

#include "tests/verification/neo_hookean_body.hpp"

/// Two manufactured solutions. Each returns the largest error of the displacement over the run (root mean
/// square over the particles), relative to the amplitude; infinite where a particle left the grid. Cell
/// 1/cells; side^2 particles a cell.
namespace manufactured {

inline constexpr double young = 1, poisson = 0.3, pi = std::numbers::pi;
inline constexpr double mu = young / (2 * (1 + poisson));
inline constexpr double lambda = young * poisson / ((1 + poisson) * (1 - 2 * poisson));

struct Settings {
  int cells = 16, side = 2;
  double cfl = 0.4, amplitude = 0.05;
};

/// Root mean square over the particles of |x - exact|; infinite if one of them is lost.
template <class Exact>
double error_of(const NeoHookeanBody& body, const Exact& exact) {
  const mpm::Grid& g = body.state.grid;
  double sum = 0;
  for (std::size_t p = 0; p < body.initial.size(); ++p) {
    const mpm::Vec2& x = body.state.particles.position[p];
    const mpm::Vec2 cells = (x - g.origin()).cwiseProduct(g.inverse_cell());
    if (!(cells.minCoeff() >= 0 && cells.maxCoeff() <= g.columns()))
      return std::numeric_limits<double>::infinity();
    sum += (x - exact(body.initial[p], body.state.time)).squaredNorm();
  }
  return std::sqrt(sum / static_cast<double>(body.initial.size()));
}

/// Axis-aligned: u_x = A sin(pi X) sin(c pi t), u_y = A sin(pi Y) sin(c pi t + pi) in the unit square between
/// four mirrors, c = sqrt(E/rho); over one period of 2/c.
///   b_i = pi^2 u_i (lambda (1 - ln J)/F_ii^2 + mu (1 + 1/F_ii^2) - E) / rho,   J = F_xx F_yy
template <class Shape>
double axis_aligned(const Settings& s) {
  const double cell = 1.0 / s.cells, c = std::sqrt(young), end = 2 / c, a = s.amplitude;
  NeoHookeanBody body(lambda, mu, {0, 0}, cell, s.cells);
  const int n = s.cells * s.side;
  for (int j = 0; j < n; ++j)
    for (int i = 0; i < n; ++i) {
      const mpm::Vec2 x((i + 0.5) / n, (j + 0.5) / n);
      body.add(x, a * c * pi * mpm::Vec2(std::sin(pi * x.x()), -std::sin(pi * x.y())), 1.0 / (n * n),
               0.5 / n);
    }
  const auto displacement = [&](const mpm::Vec2& x, double t) {
    return mpm::Vec2(a * std::sin(c * pi * t) * mpm::Vec2(std::sin(pi * x.x()), -std::sin(pi * x.y())));
  };
  const auto force = [&](const mpm::Vec2& x, const mpm::Vec2&, double t) {
    const mpm::Vec2 u = displacement(x, t);
    const double sine = a * pi * std::sin(c * pi * t);
    const mpm::Vec2 f(1 + sine * std::cos(pi * x.x()), 1 - sine * std::cos(pi * x.y()));
    const double log_jacobian = std::log(f.x() * f.y());
    mpm::Vec2 b;
    for (int i = 0; i < 2; ++i)
      b[i] = pi * pi * u[i] *
             (lambda * (1 - log_jacobian) / (f[i] * f[i]) + mu * (1 + 1 / (f[i] * f[i])) - young);
    return b;
  };
  const int steps = static_cast<int>(std::ceil(end * body.sound_speed() / (s.cfl * cell)));
  const auto position = [&](const mpm::Vec2& x, double t) { return mpm::Vec2(x + displacement(x, t)); };
  double error = 0;
  for (int k = 0; k < steps && std::isfinite(error); ++k) {
    body.step<Shape>(end / steps, s.cells, true, force);
    error = std::max(error, error_of(body, position));
  }
  return error / a;
}

/// Generalised vortex: a ring turns by alpha = g(t) h(R), g = A (1 - cos 2 pi t)/2,
/// h = 1 - 32 (R-1)^2 + 256 (R-1)^4 on 3/4 < R < 5/4; J = 1. Over one period. In the current polar basis
///   b_r = -R alpha_t^2 + mu R alpha_R^2,   b_theta = R alpha_tt - mu (R alpha_RR + 3 alpha_R)      (rho = 1)
template <class Shape>
double vortex(const Settings& s) {
  const double cell = 1.0 / s.cells, end = 1, a = s.amplitude;
  const int half = static_cast<int>(std::ceil(1.5 * s.cells));
  NeoHookeanBody body(lambda, mu, mpm::Vec2(-half * cell, -half * cell), cell, 2 * half);
  struct Twist {
    double value, slope, bend;  ///< h, h', h''
  };
  const auto twist = [](double r) -> Twist {
    const double d = r - 1;
    if (std::abs(d) >= 0.25) return {0, 0, 0};
    return {1 - 32 * d * d + 256 * d * d * d * d, -64 * d + 1024 * d * d * d, -64 + 3072 * d * d};
  };
  const auto g = [&](double t) { return a * (1 - std::cos(2 * pi * t)) / 2; };
  const auto g_t = [&](double t) { return a * pi * std::sin(2 * pi * t); };
  const auto g_tt = [&](double t) { return 2 * a * pi * pi * std::cos(2 * pi * t); };
  const int steps = static_cast<int>(std::ceil(end * body.sound_speed() / (s.cfl * cell)));
  const double dt = end / steps;
  const int n = 2 * half * s.side;
  const double share = cell / s.side;
  for (int j = 0; j < n; ++j)
    for (int i = 0; i < n; ++i) {
      const mpm::Vec2 x =
          mpm::Vec2((i + 0.5) * share, (j + 0.5) * share) - mpm::Vec2(half * cell, half * cell);
      const double r = x.norm();
      if (r < 0.6 || r > 1.4) continue;
      // velocities belong to half a step before
      const double rate = g_t(-dt / 2) * twist(r).value;
      body.add(x, rate * mpm::Vec2(-x.y(), x.x()), share * share, share / 2);
    }
  const auto position = [&](const mpm::Vec2& x, double t) {
    const double alpha = g(t) * twist(x.norm()).value, co = std::cos(alpha), si = std::sin(alpha);
    return mpm::Vec2(co * x.x() - si * x.y(), si * x.x() + co * x.y());
  };
  const auto force = [&](const mpm::Vec2& x, const mpm::Vec2&, double t) {
    const double r = x.norm();
    const Twist h = twist(r);
    const double alpha_t = g_t(t) * h.value, alpha_r = g(t) * h.slope;
    const double radial = -r * alpha_t * alpha_t + mu * r * alpha_r * alpha_r;
    const double around = r * g_tt(t) * h.value - mu * (r * g(t) * h.bend + 3 * alpha_r);
    const mpm::Vec2 e = position(x, t) / r;
    return mpm::Vec2(radial * e + around * mpm::Vec2(-e.y(), e.x()));
  };
  double error = 0;
  for (int k = 0; k < steps && std::isfinite(error); ++k) {
    body.step<Shape>(dt, 2 * half, false, force);
    error = std::max(error, error_of(body, position));
  }
  return error / a;
}

}  // namespace manufactured
