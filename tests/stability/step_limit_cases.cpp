#include <Eigen/Eigenvalues>
#include <algorithm>
#include <cmath>
#include <random>

#include "libmpm/measure/health.hpp"
#include "libmpm/mpm.hpp"
#include "libmpm/scene/parameters.hpp"
#include "tests/stability/bodies.hpp"

namespace stability {
namespace {

using mpm::ShapeFunction;
using mpm::Vec2;

// ------------------------------------------------------------------ theory

double hat(double x) { return std::max(1 - std::abs(x), 0.0); }
/// Integral of the hat from the left.
double hat_integral(double x) {
  if (x < 0) return 0.5 * std::pow(std::max(1 + x, 0.0), 2);
  return 1 - 0.5 * std::pow(std::max(1 - x, 0.0), 2);
}
double parabolas(double x) {
  const double d = std::abs(x);
  return d < 0.5 ? 0.75 - d * d : 0.5 * std::pow(std::max(1.5 - d, 0.0), 2);
}
double cubics(double x) {
  const double d = std::abs(x);
  return d < 1 ? 2.0 / 3 - d * d + 0.5 * d * d * d : std::pow(std::max(2 - d, 0.0), 3) / 6;
}

/// Weight and slope at distance x from a node [cells], of a particle with that half size.
struct Weight {
  double value, slope;
};
Weight weight(ShapeFunction shape, double x, double half) {
  const double slope_of_domain = (hat(x + half) - hat(x - half)) / (2 * half);
  switch (shape) {
    case ShapeFunction::gimp:
      return {(hat_integral(x + half) - hat_integral(x - half)) / (2 * half), slope_of_domain};
    case ShapeFunction::cpdi:
      return {0.5 * (hat(x + half) + hat(x - half)), slope_of_domain};
    case ShapeFunction::bspline2:
      return {parabolas(x), hat(x + 0.5) - hat(x - 0.5)};
    case ShapeFunction::bspline3:
      return {cubics(x), parabolas(x + 0.5) - parabolas(x - 0.5)};
    case ShapeFunction::linear:
      return {hat(x), x < -1 || x >= 1 ? 0.0 : x < 0 ? 1.0 : -1.0};
  }
  return {};
}

/// The linear step of a free bar of that many cells, in units of cell and sound speed, on (v_p, sigma_p):
/// p2g, forces, FLIP, stress. `shift`: of the particles against the lattice [cells].
Eigen::MatrixXd bar_step(ShapeFunction shape, int side, double shift, double dt) {
  constexpr int cells = 16, ghosts = 3, nodes = cells + 1 + 2 * ghosts;
  const int n = cells * side;
  Eigen::MatrixXd w(n, nodes), slope(n, nodes);
  for (int p = 0; p < n; ++p)
    for (int i = 0; i < nodes; ++i) {
      const Weight of = weight(shape, (p + 0.5) / side + shift - (i - ghosts), 0.5 / side);
      w(p, i) = of.value, slope(p, i) = of.slope;
    }
  const double mass = 1.0 / side;
  const Eigen::VectorXd nodal = mass * w.colwise().sum().transpose();
  const Eigen::MatrixXd to_nodes =
      nodal.unaryExpr([](double m) { return m > 0 ? 1 / m : 0; }).asDiagonal() * (mass * w.transpose());
  const Eigen::MatrixXd accelerate =
      nodal.unaryExpr([](double m) { return m > 0 ? 1 / m : 0; }).asDiagonal() * (-mass * slope.transpose());
  Eigen::MatrixXd step(2 * n, 2 * n);
  const auto one = Eigen::MatrixXd::Identity(n, n);
  step << one, dt * w * accelerate,                               // v_p += dt sum w a
      dt * slope * to_nodes, one + dt * dt * slope * accelerate;  // sigma_p += dt sum (v + dt a) slope
  return step;
}

/// The longest step for which the linear step has no growing mode [h/c].
double linear_limit(ShapeFunction shape, int side, double shift) {
  double holds = 0.1, breaks = 3;
  while (breaks > 1.002 * holds) {
    const double middle = std::sqrt(holds * breaks);
    const Eigen::EigenSolver<Eigen::MatrixXd> modes(bar_step(shape, side, shift, middle), false);
    (modes.eigenvalues().cwiseAbs().maxCoeff() > 1.002 ? breaks : holds) = middle;
  }
  return holds;
}

/// Particles on the lattice, and a hair beside it: then a node outside the free end has next to no mass, but
/// a slope to match, which shortens the step. A bar that shivers is now the one, now the other.
struct LinearLimits {
  double beside, on;
};
LinearLimits linear_limits(ShapeFunction shape, int side) {
  const double on = linear_limit(shape, side, 0), beside = linear_limit(shape, side, 1e-6);
  return {std::min(on, beside), std::max(on, beside)};
}

// ------------------------------------------------------------------ measured

struct Wave {
  mpm::Scene scene;
  int side;
  double drift;  ///< speed of the whole block [c]

  double sound() const {
    const mpm::Material& m = scene.material;
    return std::sqrt(m.bulk_sound_speed * m.bulk_sound_speed +
                     4 * m.shear_modulus() / (3 * m.reference_density));
  }
  /// An elastic block, away from the wall, that shivers.
  mpm::State state() const {
    const double h = scene.numerics.cell_size;
    mpm::State s = nothing({0, 0}, {h, h}, 6);
    std::mt19937 engine(1);
    const auto random = [&] { return 1e-3 * (static_cast<double>(engine()) / 0x1p31 - 1); };
    fill(s, scene, {0, 4 * h}, {6 * h, 24 * h}, side, everywhere,
         [&](const Vec2&) { return Vec2(random(), random() + drift * sound()); });
    return s;
  }
  /// The kinetic energy of the shiver grows without end in 600 steps of this length [h/c].
  bool grows(double step) const {
    mpm::Simulation simulation(scene, state());
    const auto shiver = [&] {
      double sum = 0;
      for (const Vec2& v : simulation.state().particles.velocity)
        sum += (v - Vec2(0, drift * sound())).squaredNorm();
      return sum;
    };
    const double before = shiver();
    for (int k = 0; k < 600; ++k) {
      const auto report = simulation.step(step * scene.numerics.cell_size / sound());
      if (!std::isfinite(report.largest_signal) || k % 20 == 19)
        if (!(shiver() < 10 * before)) return true;
    }
    return false;
  }
  /// To a per cent [h/c].
  double limit() const {
    double holds = 0.1, breaks = 3;
    while (breaks > 1.01 * holds) {
      const double middle = std::sqrt(holds * breaks);
      (grows(middle) ? breaks : holds) = middle;
    }
    return holds;
  }
};

Wave wave(ShapeFunction shape, int side, double viscosity, double drift) {
  Wave w{frame(1, 0.2 * um, 1 * ns), side, drift};
  w.scene.material.yield_stress = std::numeric_limits<double>::infinity();
  w.scene.numerics.scheme = shape;
  w.scene.numerics.particles_per_cell = side * side;
  w.scene.numerics.linear_viscosity = viscosity;
  if (!mpm::fast_step_has(w.scene)) w.scene.numerics.kernel = mpm::Kernel::reference;
  return w;
}

/// Without viscosity the limit lies where the linear step has it, and the default CFL number keeps clear of
/// it.
Outcome limit(ShapeFunction shape, int side, double viscosity, double drift) {
  const Wave w = wave(shape, side, viscosity, drift);
  const double measured = w.limit();
  const LinearLimits theory = linear_limits(shape, side);
  // what the signal of a run makes of it
  const double in_cfl = measured * (drift + viscosity + std::sqrt(1 + viscosity * viscosity));
  Outcome o;
  o.verdict = "held";
  o.largest_cfl = in_cfl;
  const bool near =
      viscosity > 0 || drift > 0 || (measured > 0.97 * theory.beside && measured < 1.03 * theory.on);
  o.as_expected = near && in_cfl > 1.5 * w.scene.numerics.cfl;
  std::string note = text("longest stable step [h/c]:", measured);
  if (viscosity == 0 && drift == 0)
    note += text(", of the linear step", theory.beside) + text(" to", theory.on);
  return also(o, true, note);
}

/// Steps of one and a half times the limit are caught by the health of a run within ten of them. Scenes with
/// a CFL number above 1 are refused, so that the steps are taken one by one.
Outcome beyond(ShapeFunction shape, int side) {
  const Wave w = wave(shape, side, 0, 0);
  const double dt = 1.5 * linear_limits(shape, side).beside * w.scene.numerics.cell_size / w.sound();
  mpm::Simulation simulation(w.scene, w.state());
  mpm::Health health(w.scene, simulation.state(), 1e-3);
  Outcome o;
  o.verdict = "held";
  for (o.steps = 0; o.steps < 10;) {
    const mpm::StepReport report = simulation.step(dt);
    ++o.steps;
    const mpm::State& s = simulation.state();
    health.after_step(s, report, dt);
    const auto trouble = health.trouble(0);
    if (trouble == mpm::Health::Trouble::none) continue;
    o.verdict = "broke";
    o.note = health.describe(trouble, s, 0);
    o.largest_cfl = report.largest_signal * dt / w.scene.numerics.cell_size;
    break;
  }
  o.particles = static_cast<std::int64_t>(simulation.state().particles.size());
  o.as_expected = o.verdict == "broke";
  return o;
}

}  // namespace

std::vector<Case> step_limit_cases() {
  std::vector<Case> cases;
  const mpm::Choice& schemes = *mpm::find_choice("scheme");
  for (std::size_t k = 0; k < schemes.allowed.size(); ++k) {
    mpm::Scene scene = frame(1, um, ns);
    schemes.set(scene, k);
    const ShapeFunction shape = scene.numerics.scheme;
    const std::string name(schemes.allowed[k]);
    for (const int side : {1, 2}) {
      if (shape == ShapeFunction::linear && side == 1) continue;  // which a study cannot ask for
      const std::string which = name + ", " + std::to_string(side * side) + " per cell";
      const double cost = 600.0 * 144 * side * side * 15;
      cases.push_back({"step limit", which, "holds", "the limit of an explicit step depends on the scheme",
                       cost, [=] { return limit(shape, side, 0, 0); }});
      cases.push_back({"step limit", which + ", viscosity 1", "holds", "viscosity shortens the step", cost,
                       [=] { return limit(shape, side, 1, 0); }});
      cases.push_back({"step limit", which + ", moving at c/2", "holds", "material crosses the cells", cost,
                       [=] { return limit(shape, side, 0, 0.5); }});
      cases.push_back({"step limit", which + ", 1.5 times the limit", "breaks",
                       "must be caught within ten steps", 1e4, [=] { return beyond(shape, side); }});
    }
  }
  return cases;
}

}  // namespace stability
