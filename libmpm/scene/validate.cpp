#include <algorithm>
#include <cmath>

#include "libmpm/contact/contacts.hpp"
#include "libmpm/measure/gauges.hpp"
#include "libmpm/scene/build.hpp"
#include "libmpm/scene/effect.hpp"
#include "libmpm/scene/kinds/kind.hpp"
#include "libmpm/scene/parameters.hpp"
#include "libmpm/scene/report.hpp"
#include "libmpm/scene/scene.hpp"

namespace mpm {
namespace {

template <class Wanted>
void check_ranges(const Scene& s, Report& report, const Wanted& wanted) {
  for (const Quantity& q : quantities()) {
    if (!wanted(q) || !q.alternative.empty()) continue;
    const double v = q.get(s);
    const bool may_be_infinite = q.range == Range::non_negative_or_infinite;
    const Condition* use = condition_of(q.name);
    // what nothing reads may be left at 0
    const bool may_be_zero = q.range == Range::non_negative || may_be_infinite || (use && !use->holds(s));
    if (!std::isfinite(v) && !(may_be_infinite && v > 0))
      report.add(q.name, "a finite number");
    else if (may_be_zero)
      report.require(v >= 0, q.name, "0 or more");
    else if (q.range == Range::positive)
      report.require(v > 0, q.name, "more than 0");
  }
}

void check_model(const Scene& s, Report& report) {
  if (!has_model(s.material)) {
    const Material& m = s.material;
    report.add_choice("strength", m.eos == EquationOfState::stiffened_gas
                                      ? "\"none\" with eos = \"stiffened-gas\", and tension not \"linear\""
                                  : m.eos == EquationOfState::tait
                                      ? "\"none\" with eos = \"tait\", and tension not \"linear\""
                                  : m.strength == StrengthModel::steinberg_guinan && m.fails()
                                      ? "another one with a failure_strain: \"steinberg-guinan\" has none"
                                      : "\"von-mises\", without failure_strain, when tension is \"linear\"");
  }
}

/// How the constants of a material go together.
void check_material(const Material& m, Report& report) {
  report.require(m.poissons_ratio < 0.5, "poissons_ratio", "0 or more, less than 0.5");
  if (m.law == MaterialLaw::solid && m.eos == EquationOfState::stiffened_gas)
    report.require(m.adiabatic_index > 1, "adiabatic_index", "more than 1 with eos = \"stiffened-gas\"");
  if (m.law == MaterialLaw::solid && m.strength == StrengthModel::johnson_cook) {
    report.require(m.rate_hardening == 0 || m.reference_strain_rate > 0, "reference_strain_rate",
                   "more than 0 with a rate_hardening");
    report.require(m.softening_exponent == 0 || m.melting_temperature > m.initial_temperature,
                   "melting_temperature", "above initial_temperature with a softening_exponent");
  }
  if (m.law == MaterialLaw::solid && m.eos == EquationOfState::tait) {
    report.require(m.tait_exponent > 1, "tait_exponent", "more than 1 with eos = \"tait\"");
    report.require(m.tait_pressure > 0, "tait_pressure", "more than 0 with eos = \"tait\"");
  }
  if (m.law == MaterialLaw::solid && m.strength == StrengthModel::steinberg_guinan) {
    report.require(m.yield_limit >= m.yield_stress, "yield_limit",
                   "at least yield_stress (" + text_of(m.yield_stress) + " Pa)");
    report.require(m.melting_temperature > m.initial_temperature, "melting_temperature",
                   "above initial_temperature with strength = \"steinberg-guinan\"");
  }
  report.require(m.kinematic_fraction <= 1, "kinematic_fraction", "from 0 to 1");
  report.require(m.hardening_measure != HardeningMeasure::tangent || m.hardening_modulus < m.youngs_modulus,
                 "hardening_modulus", "less than youngs_modulus when hardening_measure is \"tangent\"");
}

/// Whether the shape functions are there in the space.
bool space_has_scheme(const Scene& s) {
  const ShapeFunction scheme = s.numerics.scheme;
  switch (s.space) {
    case Space::plane_strain:
      return true;
    case Space::axisymmetric:
      return scheme == ShapeFunction::gimp || scheme == ShapeFunction::bspline2;
    case Space::three_d:
      return scheme != ShapeFunction::cpdi;
  }
  return false;
}

void check_numerics(const Scene& s, Report& report) {
  const Numerics& n = s.numerics;
  const int k = n.particles_per_cell;
  if (s.space == Space::three_d)
    report.require(k == 1 || k == 8 || k == 27, "particles_per_cell", "1, 8 or 27 when space is \"three-d\"");
  else
    report.require(k == 1 || k == 4 || k == 9 || k == 16, "particles_per_cell", "1, 4, 9 or 16");
  // Alone in its cell, a particle that moves on leaves nodes behind: steps of a CFL number of 0.27 are too
  // long (tests/stability, "step limit").
  if (n.scheme == ShapeFunction::linear)
    report.require(k > 1, "particles_per_cell", "more than 1 with scheme = \"linear\"");
  report.require(n.cfl <= 1, "cfl", "more than 0, at most 1");
  report.require(n.pic_fraction <= 1, "pic_fraction", "from 0 to 1");
  if (n.transfer == Transfer::apic)
    report.require(n.pic_fraction == 0, "pic_fraction", "0 with transfer = \"apic\"");
  const bool has_scheme = space_has_scheme(s);
  if (has_scheme && n.kernel == Kernel::fast && !fast_step_has(s))
    report.add_choice("kernel",
                      "\"reference\": the fast step has scheme = \"gimp\" and \"bspline2\", transfer = "
                      "\"flip\", pic_fraction = 0, and neither gravity nor contact");
  if (n.wall_gap == WallGap::tracked && has_contact(s))
    report.add_choice("wall_gap", "\"unseen\" where bodies are in contact");
  if (s.space == Space::axisymmetric) {
    if (!has_scheme) report.add_choice("scheme", "\"gimp\" or \"bspline2\" when space is \"axisymmetric\"");
    if (n.scheme == ShapeFunction::bspline2)
      report.require(k == 4 || k == 16, "particles_per_cell",
                     "4 or 16 with scheme = \"bspline2\" when space is \"axisymmetric\"");
    if (n.symmetry != Symmetry::half)
      report.add_choice("symmetry", "\"half\" when space is \"axisymmetric\": the axis is a mirror");
  }
  if (s.space == Space::three_d && !has_scheme)
    report.add_choice("scheme",
                      "\"gimp\", \"bspline2\", \"bspline3\" or \"linear\" when space is \"three-d\"");
  check_material(s.material, report);
}

/// What is wrong with the materials beside the first.
void check_other_materials(const Scene& s, Report& report) {
  for (const Material& m : s.other_materials) {
    Scene alone = s;
    alone.material = m;
    Report of_material(alone);
    check_ranges(alone, of_material, is_of_material);
    check_model(alone, of_material);
    check_material(m, of_material);
    for (const Problem& problem : of_material.take())
      report.add_other(problem.parameter + " of " + m.name, problem.value, problem.allowed);
  }
}

/// Words that exclude each other.
void check_choices(const Scene& s, Report& report) {
  const Numerics& n = s.numerics;
  if (n.kernel == Kernel::reference && n.precision != Precision::double_precision)
    report.add_choice("precision", "double when kernel is \"reference\"");
}

/// More particles than a machine holds most likely come from a wrong unit. In floating point, before any
/// count of cells becomes an integer.
void check_size(const Scene& s, Report& report) {
  constexpr double most_particles = 1e9;
  const auto [width, height, depth] = kind_of(s).extent(s);
  const double h = s.numerics.cell_size;
  const double slices = s.space == Space::three_d ? depth / h : 1;
  const double particles = width / h * (height / h) * slices * s.numerics.particles_per_cell;
  report.require(particles <= most_particles, "cell_size",
                 "large enough for at most 1e9 particles (these would be " + text_of(particles) + ")");
  // The fast step counts the numbers of its nodes in 32 bits, up to 8 of a node. Room for the block to
  // double.
  if (s.numerics.kernel == Kernel::fast && particles <= most_particles)
    report.require(width / h * (height / h) * slices <= 1e8, "cell_size",
                   "large enough for at most 1e8 cells when kernel is \"fast\"");
}

void check_length(const Scene& s, Report& report) {
  constexpr double most_steps = 1e9, most_samples = 1e6;
  const double steps =
      s.end_time * largest_of(s, sound_speed_at_rest) / (s.numerics.cfl * s.numerics.cell_size);
  report.require(steps <= most_steps, "end_time",
                 "short enough for at most 1e9 steps (these would be " + text_of(steps) + " or more)");
  report.require(s.measures.area_every * most_samples >= s.end_time, "area_every",
                 "at least a millionth of end_time (" + text_of(s.end_time / most_samples) + " s)");
}

}  // namespace

Numerics default_numerics(SceneKind kind, Space space) {
  Numerics n;
  kind_of(kind).set_default_numerics(n);
  if (space == Space::three_d)
    n.particles_per_cell = static_cast<int>(std::lround(std::pow(n.particles_per_cell, 1.5)));
  n.quadratic_viscosity = 1.5;
  n.cfl = 0.4;
  return n;
}

std::vector<Problem> find_problems(const Scene& s) {
  Report report(s);
  check_ranges(s, report, [&](const Quantity& q) { return q.belongs_to(s.kind); });
  check_model(s, report);
  check_other_materials(s, report);
  if (!report.empty()) return report.take();  // what follows compares numbers that have to be numbers
  if (s.space == Space::three_d && !kind_of(s).of_three_axes.is_there())
    report.add_choice("space", "\"plane-strain\" or \"axisymmetric\": " + std::string(kind_of(s).name) +
                                   " is not there in three dimensions");
  if (!report.empty()) return report.take();
  check_numerics(s, report);
  check_choices(s, report);
  check_size(s, report);
  check_length(s, report);
  kind_of(s).check(s, report);
  if (report.empty()) check_gauges(s, report);
  return report.take();
}

namespace {

bool of_all_kinds(const Quantity& q) {
  return std::ranges::all_of(scene_kind_names(),
                             [&](std::string_view name) { return q.belongs_to(*scene_kind_from(name)); });
}

template <int axes>
void check_body(const Scene& s, const BasicState<axes>& body, Report& report) {
  const auto& ps = body.particles;
  const std::size_t n = ps.size();
  const auto require = [&](bool fine, std::string value, std::string allowed) {
    if (!fine) report.add_other("body", std::move(value), std::move(allowed));
  };
  require(n > 0, "nothing", "a body of at least one particle");
  require(!body.ceiling || s.numerics.kernel == Kernel::reference, "a mirror above it",
          "one without, or kernel = \"reference\": the fast step has no mirror there");
  for (const std::size_t size :
       {ps.velocity.size(), ps.mass.size(), ps.initial_volume.size(), ps.dilation.size(), ps.energy.size(),
        ps.pressure.size(), ps.viscous_pressure.size(), ps.deviator.size(), ps.half_size.size(),
        body.velocity_gradient.size()})
    if (size != n)
      return report.add_other("body", text_of(static_cast<double>(size)) + " values in a column",
                              "one value for each of its " + text_of(static_cast<double>(n)) + " particles");
  const std::vector<std::size_t>& ends = ps.material_ends;
  require(ends.size() <= material_count(s), text_of(static_cast<double>(ends.size())) + " materials",
          "of the materials of the scene, which are " + text_of(static_cast<double>(material_count(s))));
  require(ends.empty() || (ends.back() == n && std::ranges::is_sorted(ends)), "material_ends",
          "ascending, the last one the number of particles");
  const auto& grid = body.grid;
  for (std::size_t p = 0; p < n; ++p) {
    const Vec<axes>& x = ps.position[p];
    const bool inside =
        grid.holds(x) && std::isfinite(x.y()) && (s.space != Space::axisymmetric || x.x() > 0);
    const bool material = ps.mass[p] > 0 && ps.volume(p) > 0 && ps.velocity[p].allFinite();
    if (inside && material) continue;
    return report.add_other("body",
                            "particle " + text_of(static_cast<double>(p)) + " at x = " + text_of(x.x()) +
                                " m, y = " + text_of(x.y()) + " m" +
                                (axes == 3 ? ", z = " + text_of(x[axes - 1]) + " m" : ""),
                            inside ? "of positive mass and volume, with a finite velocity"
                                   : "in the grid, above its floor and between its sides");
  }
  // With fewer, the images behind both mirrors share nodes.
  constexpr int fewest_cells = 3;
  require(grid.columns() >= fewest_cells, "a grid of " + std::to_string(grid.columns()) + " cells across",
          "in a grid of at least 3 cells between its mirrors");
  if constexpr (axes == 3)
    require(grid.slices() >= fewest_cells, "a grid of " + std::to_string(grid.slices()) + " cells along z",
            "in a grid of at least 3 cells between its mirrors");
  const double ratio = s.numerics.cell_size / grid.cell().minCoeff();
  report.require(ratio > 0.5 && ratio < 2, "cell_size",
                 "about the smaller edge of the grid's cells (" + text_of(grid.cell().minCoeff()) + " m)");
}

}  // namespace

template <int axes>
std::vector<Problem> find_problems(const Scene& s, const BasicState<axes>& body) {
  Report report(s);
  check_ranges(s, report, of_all_kinds);
  check_model(s, report);
  check_other_materials(s, report);
  if (!report.empty()) return report.take();
  check_numerics(s, report);
  check_choices(s, report);
  check_length(s, report);
  check_body(s, body, report);
  if (report.empty()) check_gauges(s, body, report);
  return report.take();
}

template std::vector<Problem> find_problems(const Scene&, const State&);
template std::vector<Problem> find_problems(const Scene&, const BasicState<3>&);

/// The largest int64_t below 2^63 for what is larger, 0 for what is no number: a speed of 1e300 m/s has steps
/// that no integer counts.
static std::int64_t whole_number(double value) {
  constexpr double most = 9.2e18;
  return value > 0 ? static_cast<std::int64_t>(std::min(value, most)) : 0;
}

namespace {

/// What an estimate asks of the lattice.
struct Lattices {
  double particles, smallest_cell;
};
template <int axes>
Lattices lattice_numbers(const Scene& s) {
  const BasicLattice<axes> lattice = lattice_of<axes>(s);
  const double per_cell = static_cast<double>(s.numerics.particles_per_cell) / lattice.cell.prod();
  return {kind_of(s).in<axes>().size(s, lattice) * per_cell, lattice.cell.minCoeff()};
}

}  // namespace

/// Of a particle in a step, in that of the fast step in plane strain: quadratic B-splines, double, 4 or 8
/// particles per cell (mpmstudy bench kernel).
double update_cost(Space space, Kernel kernel) {
  switch (space) {
    case Space::plane_strain:
      return kernel == Kernel::fast ? 1 : 8;
    case Space::axisymmetric:
      return kernel == Kernel::fast ? 1.2 : 13;
    case Space::three_d:
      return kernel == Kernel::fast ? 4.3 : 26;
  }
  return 1;
}

Estimate estimate(const Scene& s) {
  const Lattices lattice = axes_of(s.space) == 2 ? lattice_numbers<2>(s) : lattice_numbers<3>(s);
  const double sound = largest_of(s, sound_speed_at_rest);
  const double slope = largest_of(s, [](const Material& m) { return m.hugoniot_slope; });
  // Behind the shock sound is faster by about 2 lambda u, and the body moves. Some material is always being
  // compressed, so that the viscous signal Q + sqrt(Q^2 + c^2), Q = q1 c, decides the step.
  const double q = s.numerics.linear_viscosity;
  const double signal =
      (q + std::sqrt(q * q + 1)) * (sound + 2 * slope * initial_speed(s)) + initial_speed(s);
  const double step = s.numerics.cfl * lattice.smallest_cell / signal;
  // Samples are hit exactly, by a whole number of steps from one to the next.
  const double samples = s.end_time / s.measures.area_every;
  const double per_sample = std::ceil(s.measures.area_every / step);
  return {whole_number(lattice.particles), whole_number(per_sample * samples),
          update_cost(s.space, s.numerics.kernel)};
}

}  // namespace mpm
