#include "libmpm/verification/exact/blast_waves.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <utility>
#include <vector>

#include "libmpm/verification/problems/problems.hpp"
#include "libmpm/verification/problems/scenes.hpp"
#include "libmpm/verification/problems/with_options.hpp"

namespace mpm::verification {
namespace {

constexpr double density = 1;
constexpr double noh_gamma = 5.0 / 3, noh_speed = 1, noh_radius = 1;

mpm::Material ideal_gas(double gamma) {
  mpm::Material m;
  m.name = "ideal gas";
  m.eos = mpm::EquationOfState::stiffened_gas;
  m.strength = mpm::StrengthModel::none;
  m.reference_density = density;
  m.adiabatic_index = gamma;
  m.specific_heat = 1000;
  m.pressure_limit = std::numeric_limits<double>::max();
  return m;
}

int dimension(mpm::Space space) { return space == mpm::Space::plane_strain ? 2 : 3; }

/// A quarter of the plane, in axisymmetry the half of the sphere's meridian that lies above, in a square of
/// `edge` [m].
mpm::Scene gas_scene(mpm::Space space, double gamma, double edge, double cell, double end_time) {
  mpm::Scene s;
  s.kind = mpm::SceneKind::bodies;
  s.space = space;
  s.material = ideal_gas(gamma);
  s.numerics = mpm::default_numerics(s.kind, space);
  s.numerics.cell_size = cell;
  s.composition.high = {edge, edge, edge};
  const auto face = [&](mpm::Side side) -> mpm::Face& {
    return s.composition.faces[static_cast<std::size_t>(side)];
  };
  face(mpm::Side::left) = face(mpm::Side::bottom) = mpm::Face::mirror;
  s.end_time = end_time;
  s.measures.area_every = end_time / 10;
  return s;
}

mpm::Shape ball(double radius) { return {mpm::Shape::Form::ball, {0, 0, 0, radius}, {}}; }

/// Means over the particles of rings or shells of the thickness of a cell, by their mass.
struct Profile {
  double thickness;
  std::vector<double> pressure, density;

  Profile(const mpm::Particles& ps, double cell, double edge) : thickness(cell) {
    const auto count = static_cast<std::size_t>(std::ceil(edge / cell));
    std::vector<double> mass(count), volume(count);
    pressure.resize(count), density.resize(count);
    for (std::size_t p = 0; p < ps.size(); ++p) {
      const auto k = static_cast<std::size_t>(ps.position[p].norm() / cell);
      if (k >= count) continue;
      mass[k] += ps.mass[p], volume[k] += ps.volume(p), pressure[k] += ps.mass[p] * ps.pressure[p];
    }
    for (std::size_t k = 0; k < count; ++k)
      if (mass[k] > 0) pressure[k] /= mass[k], density[k] = mass[k] / volume[k];
  }

  /// Where the pressure falls to half of its largest value, from outside [m].
  double front() const {
    const double half = 0.5 * *std::ranges::max_element(pressure);
    for (std::size_t k = pressure.size() - 1; k > 0; --k)
      if (pressure[k - 1] >= half)
        return thickness * (k + 0.5 - (half - pressure[k]) / (pressure[k - 1] - pressure[k]));
    return 0;
  }
  /// From 0.4 to 0.8 of a radius [kg/m^3], where neither the centre nor the front is felt.
  double plateau(double radius) const {
    double sum = 0;
    int count = 0;
    for (std::size_t k = 0; k < density.size(); ++k)
      if (const double r = (static_cast<double>(k) + 0.5) * thickness; r > 0.4 * radius && r < 0.8 * radius)
        sum += density[k], ++count;
    return sum / count;
  }
};

struct Run {
  mpm::RunResult result;
  Profile profile;
};
Run solved(const mpm::Scene& scene) {
  mpm::Simulation simulation(scene);
  mpm::RunResult result = simulation.run();
  return {std::move(result),
          Profile(simulation.state().particles, scene.numerics.cell_size, scene.composition.high[0])};
}

}  // namespace

/// The inflow on cells of this size, up to this time.
static Run inflow(mpm::Space space, double cell, double time, const ExactOptions& options) {
  mpm::Scene s = with_options(gas_scene(space, noh_gamma, noh_radius, cell, time), options);
  s.composition.bodies = {{.name = "gas", .shape = ball(noh_radius), .radial = {.speed = -noh_speed}}};
  return solved(s);
}

/// Viscosity heats the gas that flows together before the shock comes, so that it is less dense behind it and
/// the front is ahead, both by an error of first order: numbers are taken to cells of no size from two sizes.
/// The speed of the front is that between two times.
ExactNumbers noh_numbers(mpm::Space space, const ExactOptions& options) {
  constexpr double time = 0.6;
  const double cell = 0.01 * options.cells;
  const exact::NohShock exact = exact::noh_shock({noh_gamma, density}, dimension(space), noh_speed);
  const Run run = inflow(space, cell, time, options), coarse = inflow(space, 2 * cell, time, options);
  const double front = exact.shock_speed * time, at = run.profile.front();
  const double speed = (at - inflow(space, cell, time / 2, options).profile.front()) / (time / 2);
  const auto plateau = [&](const Run& one) { return one.profile.plateau(front); };
  // the sphere is squeezed to a 64th: on these cells its error is not yet of first order
  const double of_density = space == mpm::Space::plane_strain ? 0.05 : 0.3;
  return with_trouble({{"speed of the front", "m/s", exact.shock_speed, speed, 0.02},
                       {"front, taken to small cells", "m", front, 2 * at - coarse.profile.front(), 0.02},
                       {"density, taken to small cells", "kg/m3", exact.density,
                        2 * plateau(run) - plateau(coarse), of_density},
                       {"energy error", "1", 0, run.result.energy_error, 1e-11, Judged::absolute}},
                      run.result);
}

/// The energy is that of gas in some cells about the centre.
ExactNumbers sedov_numbers(mpm::Space space, const ExactOptions& options) {
  constexpr double gamma = 1.4, time = 1, front = 1, edge = 1.2;
  const int n = dimension(space);
  const exact::SedovBlast exact({gamma, density}, n);
  mpm::Scene s = with_options(gas_scene(space, gamma, edge, 0.02 * options.cells, time), options);
  const double hot = 3 * s.numerics.cell_size, pi = std::numbers::pi;
  const double filled = n == 2 ? pi * hot * hot : 4 * pi / 3 * hot * hot * hot;
  const mpm::Shape all{mpm::Shape::Form::block, {0, 0, 0, edge, edge, edge}, {}};
  s.composition.bodies = {
      {.name = "hot", .shape = ball(hot), .energy = exact.alpha() / (density * filled)},  // front = 1 at 1 s
      {.name = "cold", .shape = {mpm::Shape::Form::difference, {}, {all, ball(hot)}}}};
  const auto [result, profile] = solved(s);
  const double peak = *std::ranges::max_element(profile.pressure);
  return with_trouble({{"front", "m", front, profile.front(), 0.02},
                       {"peak of the pressure", "Pa", exact.peak_pressure(exact.alpha(), time), peak, 0.05},
                       {"energy error", "1", 0, result.energy_error, 1e-11, Judged::absolute}},
                      result);
}

}  // namespace mpm::verification
