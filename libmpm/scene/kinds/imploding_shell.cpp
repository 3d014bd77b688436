// A ring that nothing touches moves inwards: v(r) = -inner_speed inner_radius / r; in axisymmetry and of
// three axes a sphere, v(r) = -inner_speed (inner_radius / r)^2.
#include <algorithm>
#include <cmath>
#include <numbers>

#include "libmpm/measure/shell.hpp"
#include "libmpm/scene/kinds/kind.hpp"

namespace mpm {
namespace {

// clang-format off
constexpr Quantity rows[] = {
    {"inner_radius", "m", "a", "inner_radius_m", "inner radius of the shell",
     Section::parameters, Range::positive, true, "", get<&Scene::inner_radius>, set<&Scene::inner_radius>},
    {"outer_radius", "m", "b", "outer_radius_m", "outer radius of the shell",
     Section::parameters, Range::positive, true, "", get<&Scene::outer_radius>, set<&Scene::outer_radius>},
    {"inner_speed", "m/s", "u", "inner_speed_m_s", "speed, inwards, of the shell's inner surface: v(r) = -inner_speed inner_radius / r, of a sphere (inner_radius / r)^2",
     Section::parameters, Range::positive, true, "", get<&Scene::inner_speed>, set<&Scene::inner_speed>},
};
// clang-format on

/// Whether the quarter, of three axes the octant, is modelled.
bool part_of(const Scene& s) { return s.numerics.symmetry == Symmetry::half; }

/// An imploding shell hardly compresses, so viscosity only damps the ringing that its start and its stop
/// excite: from 0 to 1 it moves the stop radius by 0.1 %; with less than 0.5 the ringing is left, with GIMP
/// the edge is rough. Measured by tests/verification.
void set_default_numerics(Numerics& n) {
  n.scheme = ShapeFunction::bspline2;
  n.particles_per_cell = 4;
  n.linear_viscosity = 0.5;
}

void check(const Scene& s, Report& report) {
  const double h = s.numerics.cell_size, a = s.inner_radius, b = s.outer_radius;
  report.require(b > a, "outer_radius", "more than inner_radius (" + text_of(a) + " m)");
  report.require(h <= a, "cell_size",
                 "at most inner_radius (" + text_of(a) + " m): the hole is smaller than a cell");
  if (b > a)
    report.require(h <= (b - a) / 4, "cell_size",
                   "at most a quarter of outer_radius - inner_radius (" + text_of((b - a) / 4) + " m)");
}

Extent extent(const Scene& s) { return {2 * s.outer_radius, 2 * s.outer_radius, 2 * s.outer_radius}; }

/// A square or a cube with two cells to spare, so that neither the right mirror nor, where all of the shell
/// is modelled, the impact wall ever feels it.
template <int axes>
BasicLattice<axes> lattice(const Scene& s) {
  using Vector = Vec<axes>;
  const double h = s.numerics.cell_size;
  const bool part = part_of(s);
  const int cells = static_cast<int>(std::ceil(s.outer_radius / h)) + 2;
  const int across = part ? cells : 2 * cells;
  BasicLattice<axes> l{Vector::Zero(), Vector::Constant(h), Vector::Zero(), across * h, across, across, 0};
  if (axes == 3) l.slices = across;
  if (part) return l;
  l.origin.setConstant(-cells * h);
  l.origin.y() = 0;
  l.center.y() = cells * h;
  return l;
}

Floor floor(const Scene& s) { return part_of(s) ? Floor::mirror : Floor::impact_wall; }

template <int axes>
BasicBody<axes> body(const Scene& s, const BasicLattice<axes>& l) {
  using Vector = Vec<axes>;
  const double u = s.inner_speed, a = s.inner_radius;
  const auto shell = ball<axes>(Vector::Zero(), s.outer_radius) - ball<axes>(Vector::Zero(), a);
  if (s.space == Space::plane_strain)
    return {shell, [=](const Vector& x) { return Vector(-u * a / x.squaredNorm() * x); }, l.center};
  return {shell, [=](const Vector& x) { return Vector(-u * (a * a) / (x.squaredNorm() * x.norm()) * x); },
          l.center};
}

template <int axes>
double size(const Scene& s, const BasicLattice<axes>&) {
  const double a = s.inner_radius, b = s.outer_radius;
  const double whole =
      axes == 2 ? std::numbers::pi * (b * b - a * a) : 4 * std::numbers::pi / 3 * (b * b * b - a * a * a);
  return part_of(s) ? whole / (1 << axes) : whole;
}

double fastest(const Scene& s) { return s.inner_speed; }

double coarsest_cell(const Scene& s) { return std::min(s.inner_radius, s.outer_radius - s.inner_radius) / 4; }

std::vector<Part> parts(const Scene& s) {
  return {{"the wall of the shell", "outer_radius", s.outer_radius - s.inner_radius},
          {"the hole of the shell", "inner_radius", 2 * s.inner_radius}};
}

constexpr std::string_view outcomes[] = {"arrested"};
constexpr Results measured[] = {Shell::results};

template <int axes>
BasicMeasurements<axes> measurements(const Scene& s, const BasicState<axes>& state) {
  BasicMeasurements<axes> all;
  all.push_back(std::make_unique<BasicShell<axes>>(s, state));
  return all;
}

template <int axes>
constexpr KindIn<axes> in_axes{lattice<axes>, body<axes>, size<axes>, measurements<axes>};

}  // namespace

extern constinit const Kind imploding_shell{
    .kind = SceneKind::imploding_shell,
    .name = "imploding-shell",
    .quantities = rows,
    .results = measured,
    .headline = "stop_radius_m",
    .outcomes = outcomes,
    .set_default_numerics = set_default_numerics,
    .check = check,
    .extent = extent,
    .floor = floor,
    .fastest = fastest,
    .coarsest_cell = coarsest_cell,
    .parts = parts,
    .of_two_axes = in_axes<2>,
    .of_three_axes = in_axes<3>,
};

}  // namespace mpm
