#include <algorithm>
#include <charconv>
#include <cmath>
#include <limits>
#include <numbers>

#include "libmpm/scene/build.hpp"
#include "libmpm/scene/parameters.hpp"
#include "libmpm/scene/scene.hpp"

namespace mpm {
namespace {

std::string number(double v) {
  char text[32];
  const auto end = std::to_chars(text, text + sizeof text, v).ptr;
  return {text, end};
}

/// Collects problems; values and units come from the table of parameters.
class Report {
 public:
  explicit Report(const Scene& scene) : scene_(scene) {}

  void add(std::string_view name, std::string allowed) {
    const Quantity* q = find_quantity(name);
    std::string value = number(q->get(scene_));
    if (q->unit != "1") value.append(" ").append(q->unit);
    problems_.push_back({std::string(name), std::move(value), std::move(allowed)});
  }
  void add_other(std::string what, std::string value, std::string allowed) {
    problems_.push_back({std::move(what), std::move(value), std::move(allowed)});
  }
  void add_choice(std::string_view name, std::string allowed) {
    const Choice* c = find_choice(name);
    problems_.push_back({std::string(name), std::string(c->allowed[c->get(scene_)]), std::move(allowed)});
  }
  void require(bool fine, std::string_view name, std::string allowed) {
    if (!fine) add(name, std::move(allowed));
  }
  bool empty() const { return problems_.empty(); }
  std::vector<Problem> take() { return std::move(problems_); }

 private:
  const Scene& scene_;
  std::vector<Problem> problems_;
};

template <class Wanted>
void check_ranges(const Scene& s, Report& report, const Wanted& wanted) {
  for (const Quantity& q : quantities()) {
    if (!wanted(q) || !q.alternative.empty()) continue;
    const double v = q.get(s);
    const bool may_be_infinite = q.range == Range::non_negative_or_infinite;
    if (!std::isfinite(v) && !(may_be_infinite && v > 0))
      report.add(q.name, "a finite number");
    else if (q.range == Range::positive)
      report.require(v > 0, q.name, "more than 0");
    else if (q.range == Range::non_negative || may_be_infinite)
      report.require(v >= 0, q.name, "0 or more");
  }
}

void check_numerics(const Scene& s, Report& report) {
  const Numerics& n = s.numerics;
  const int k = n.particles_per_cell;
  report.require(k == 1 || k == 4 || k == 9 || k == 16, "particles_per_cell", "1, 4, 9 or 16");
  report.require(n.cfl <= 1, "cfl", "more than 0, at most 1");
  report.require(n.pic_fraction <= 1, "pic_fraction", "from 0 to 1");
  if (n.transfer == Transfer::apic)
    report.require(n.pic_fraction == 0, "pic_fraction", "0 with transfer = \"apic\"");
  if (n.kernel == Kernel::fast && !fast_step_has(n))
    report.add_choice("kernel",
                      "\"reference\": the fast step has scheme = \"gimp\" and \"bspline2\", transfer = "
                      "\"flip\", pic_fraction = 0");
  const Material& m = s.material;
  report.require(m.poissons_ratio < 0.5, "poissons_ratio", "0 or more, less than 0.5");
  report.require(m.kinematic_fraction <= 1, "kinematic_fraction", "from 0 to 1");
  report.require(m.hardening_measure != HardeningMeasure::tangent || m.hardening_modulus < m.youngs_modulus,
                 "hardening_modulus", "less than youngs_modulus when hardening_measure is \"tangent\"");
}

/// Words that exclude each other.
void check_choices(const Scene& s, Report& report) {
  const Numerics& n = s.numerics;
  if (n.kernel == Kernel::reference && n.precision != Precision::double_precision)
    report.add_choice("precision", "double when kernel is \"reference\"");
}

void check_block(const Scene& s, Report& report) {
  report.require(s.numerics.cell_size <= s.block_width / 8, "cell_size",
                 "at most an eighth of block_width (" + number(s.block_width / 8) + " m)");
  report.require(s.numerics.cell_size <= s.block_height / 4, "cell_size",
                 "at most a quarter of block_height (" + number(s.block_height / 4) + " m)");
}

void check_shell(const Scene& s, Report& report) {
  const double h = s.numerics.cell_size, a = s.inner_radius, b = s.outer_radius;
  report.require(b > a, "outer_radius", "more than inner_radius (" + number(a) + " m)");
  report.require(h <= a, "cell_size",
                 "at most inner_radius (" + number(a) + " m): the hole is smaller than a cell");
  if (b > a)
    report.require(h <= (b - a) / 4, "cell_size",
                   "at most a quarter of outer_radius - inner_radius (" + number((b - a) / 4) + " m)");
}

void check_cavity(const Scene& s, Report& report) {
  const double r = s.cavity_radius, y = s.cavity_center_height;
  report.require(2 * r < s.block_width, "cavity_radius",
                 "less than half of block_width (" + number(s.block_width / 2) +
                     " m): the cavity is as wide as the block");
  report.require(s.numerics.cell_size <= r, "cell_size",
                 "at most cavity_radius (" + number(r) + " m): the cavity is smaller than a cell");
  // A hair of rounding is allowed: a centre that is computed from a wall thickness may miss tangency by it.
  const double slack = 4 * std::numeric_limits<double>::epsilon() * s.block_height;
  report.require(y - r >= -slack, "cavity_center_height",
                 "at least cavity_radius (" + number(r) + " m): the cavity leaves the block below");
  report.require(y + r <= s.block_height + slack, "cavity_center_height",
                 "at most block_height - cavity_radius (" + number(s.block_height - r) +
                     " m): the cavity leaves the block above");
}

/// More than a machine holds, or than anyone waits for, is a slip of the unit. In floating point, before any
/// count of cells becomes an integer.
void check_size(const Scene& s, Report& report) {
  constexpr double most_particles = 1e9;
  const bool shell = s.kind == SceneKind::imploding_shell;
  const double width = shell ? 2 * s.outer_radius : s.block_width;
  const double bodies = s.kind == SceneKind::two_body_impact ? 2 : 1;
  const double height = shell ? width : bodies * s.block_height;
  const double h = s.numerics.cell_size;
  const double particles = width / h * (height / h) * s.numerics.particles_per_cell;
  report.require(particles <= most_particles, "cell_size",
                 "large enough for at most 1e9 particles (these would be " + number(particles) + ")");
  // The fast step keeps the number of a particle's node beside its position. Room for the block to double.
  if (s.numerics.precision == Precision::single_precision)
    report.require(width / h * (height / h) <= 0x1p23, "cell_size",
                   "large enough for at most 2^23 cells when precision is \"float\"");
  // Two bodies have empty rows for the way that the struck one goes.
  if (s.kind == SceneKind::two_body_impact) {
    constexpr double most_cells = 1e9;
    const double cells = width / h * ((height + s.impact_speed * s.end_time) / h);
    report.require(
        cells <= most_cells, "end_time",
        "short enough for at most 1e9 cells of the way that the bodies go at impact_speed (these would be " +
            number(cells) + ")");
  }
}

void check_length(const Scene& s, Report& report) {
  constexpr double most_steps = 1e9, most_samples = 1e6;
  const double steps = s.end_time * s.material.bulk_sound_speed / (s.numerics.cfl * s.numerics.cell_size);
  report.require(steps <= most_steps, "end_time",
                 "short enough for at most 1e9 steps (these would be " + number(steps) + " or more)");
  report.require(s.measures.area_every * most_samples >= s.end_time, "area_every",
                 "at least a millionth of end_time (" + number(s.end_time / most_samples) + " s)");
}

}  // namespace

/// tests/verification measures what these rest on: behind a planar shock one particle a cell
/// with a domain that tiles leaves the least noise, and the deviator needs a linear viscosity of 1. A
/// cavity's edge needs more particles, and there the smaller viscosity moves the collapse less. An imploding
/// shell hardly compresses, so viscosity only damps the ringing that its start and its stop excite: from 0 to
/// 1 it moves the stop radius by 0.1 %; with less than 0.5 the ringing is left, with GIMP the edge is rough.
Numerics default_numerics(SceneKind kind) {
  Numerics n;
  switch (kind) {
    case SceneKind::planar_impact:
      n.scheme = ShapeFunction::gimp;
      n.particles_per_cell = 1;
      n.linear_viscosity = 1;
      break;
    case SceneKind::imploding_shell:
    case SceneKind::cavity_impact:
    case SceneKind::two_body_impact:
      n.scheme = ShapeFunction::bspline2;
      n.particles_per_cell = 4;
      n.linear_viscosity = 0.5;
      break;
  }
  n.quadratic_viscosity = 1.5;
  n.cfl = 0.4;
  return n;
}

std::vector<Problem> find_problems(const Scene& s) {
  Report report(s);
  check_ranges(s, report, [&](const Quantity& q) { return q.belongs_to(s.kind); });
  if (!report.empty()) return report.take();  // what follows compares numbers that have to be numbers
  check_numerics(s, report);
  check_choices(s, report);
  check_size(s, report);
  check_length(s, report);
  if (s.kind == SceneKind::imploding_shell) {
    check_shell(s, report);
    return report.take();
  }
  check_block(s, report);
  if (has_cavity(s.kind)) check_cavity(s, report);
  return report.take();
}

namespace {

bool of_all_kinds(const Quantity& q) {
  return std::ranges::all_of(scene_kind_names(),
                             [&](std::string_view name) { return q.belongs_to(*scene_kind_from(name)); });
}

void check_body(const Scene& s, const State& body, Report& report) {
  const Particles& ps = body.particles;
  const std::size_t n = ps.size();
  const auto require = [&](bool fine, std::string value, std::string allowed) {
    if (!fine) report.add_other("body", std::move(value), std::move(allowed));
  };
  require(n > 0, "nothing", "a body of at least one particle");
  for (const std::size_t size :
       {ps.velocity.size(), ps.mass.size(), ps.initial_volume.size(), ps.dilation.size(), ps.energy.size(),
        ps.pressure.size(), ps.viscous_pressure.size(), ps.deviator.size(), ps.plastic_strain.size(),
        ps.plastic_work.size(), ps.half_size.size(), body.velocity_gradient.size(),
        s.material.kinematic_fraction > 0 ? ps.back_stress.size() : n})
    if (size != n)
      return report.add_other("body", number(static_cast<double>(size)) + " values in a column",
                              "one value for each of its " + number(static_cast<double>(n)) + " particles");
  const Grid& grid = body.grid;
  const Vec2 low = grid.origin() - 0.5 * grid.cell();
  const double right = grid.origin().x() + (grid.columns() + 0.5) * grid.cell().x();
  for (std::size_t p = 0; p < n; ++p) {
    const Vec2& x = ps.position[p];
    const bool inside = x.x() > low.x() && x.x() < right && x.y() > low.y() && std::isfinite(x.y());
    const bool material = ps.mass[p] > 0 && ps.volume(p) > 0 && ps.velocity[p].allFinite();
    if (inside && material) continue;
    return report.add_other("body",
                            "particle " + number(static_cast<double>(p)) + " at x = " + number(x.x()) +
                                " m, y = " + number(x.y()) + " m",
                            inside ? "of positive mass and volume, with a finite velocity"
                                   : "in the grid, above its floor and between its sides");
  }
  const double ratio = s.numerics.cell_size / grid.cell().minCoeff();
  report.require(ratio > 0.5 && ratio < 2, "cell_size",
                 "about the smaller edge of the grid's cells (" + number(grid.cell().minCoeff()) + " m)");
}

}  // namespace

std::vector<Problem> find_problems(const Scene& s, const State& body) {
  Report report(s);
  check_ranges(s, report, of_all_kinds);
  if (!report.empty()) return report.take();
  check_numerics(s, report);
  check_choices(s, report);
  check_length(s, report);
  check_body(s, body, report);
  return report.take();
}

/// Of the modelled part of the body [m^2].
static double area_of(const Scene& s, const Lattice& lattice) {
  constexpr double pi = std::numbers::pi;
  if (s.kind == SceneKind::imploding_shell) {
    const double ring = pi * (s.outer_radius * s.outer_radius - s.inner_radius * s.inner_radius);
    return s.numerics.symmetry == Symmetry::half ? ring / 4 : ring;
  }
  double area = lattice.width * s.block_height;
  if (s.kind == SceneKind::two_body_impact) area *= 2;
  if (has_cavity(s.kind)) area -= pi * s.cavity_radius * s.cavity_radius * (lattice.width / s.block_width);
  return area;
}

/// The largest int64_t below 2^63 for what is larger, 0 for what is no number: a speed of 1e300 m/s has steps
/// that no integer counts.
static std::int64_t whole_number(double value) {
  constexpr double most = 9.2e18;
  return value > 0 ? static_cast<std::int64_t>(std::min(value, most)) : 0;
}

Estimate estimate(const Scene& s) {
  const Lattice lattice = lattice_of(s);
  const double area = area_of(s, lattice);
  const double per_cell =
      static_cast<double>(s.numerics.particles_per_cell) / (lattice.cell.x() * lattice.cell.y());
  const Material& m = s.material;
  const double sound =
      std::sqrt(m.bulk_sound_speed * m.bulk_sound_speed + 4 * m.shear_modulus() / (3 * m.reference_density));
  // Behind the shock sound is faster by about 2 lambda u, and the body moves. Some material is always being
  // compressed, so that the viscous signal Q + sqrt(Q^2 + c^2), Q = q1 c, decides the step.
  const double q = s.numerics.linear_viscosity;
  const double signal =
      (q + std::sqrt(q * q + 1)) * (sound + 2 * m.hugoniot_slope * initial_speed(s)) + initial_speed(s);
  const double step = s.numerics.cfl * std::min(lattice.cell.x(), lattice.cell.y()) / signal;
  // Samples are hit exactly, by a whole number of steps from one to the next.
  const double samples = s.end_time / s.measures.area_every;
  const double per_sample = std::ceil(s.measures.area_every / step);
  return {whole_number(area * per_cell), whole_number(per_sample * samples)};
}

}  // namespace mpm
