// Bodies of any shape and material in a box, as the scene's composition says.
#include <algorithm>
#include <cmath>
#include <optional>
#include <set>
#include <string>

#include "libmpm/contact/contacts.hpp"
#include "libmpm/core/errors.hpp"
#include "libmpm/measure/works.hpp"
#include "libmpm/scene/kinds/bodies_start.hpp"
#include "libmpm/scene/kinds/kind.hpp"
#include "libmpm/scene/region_of.hpp"

namespace mpm {
namespace {

/// Between an open face of the box and the mirror that stands for it. Wide enough for the support of a
/// particle in the box.
constexpr int spare_cells = 3;
/// Two mirrors with fewer between them share nodes.
constexpr int fewest_cells = 3;
/// What is looked at before a run starts is looked at on no more cells than these along an edge.
constexpr double look_cells(int axes) { return axes == 2 ? 96 : 32; }

double at(const Triple& t, int axis) { return t[static_cast<std::size_t>(axis)]; }
Vec3 edges(const Composition& all) { return vector(all.high) - vector(all.low); }

bool is_open(const Scene& s, Side side) { return s.composition.face(side) == Face::open; }

/// How a box is cut along one axis.
struct Cut {
  double cell;
  int before, within, behind;  ///< cells; before and behind: those beyond open faces
  int all() const { return before + within + behind; }
};
Cut cut(const Scene& s, int axis, Side low, Side high) {
  const double length = at(s.composition.high, axis) - at(s.composition.low, axis);
  const int within = std::max(1, static_cast<int>(std::lround(length / s.numerics.cell_size)));
  return {length / within, is_open(s, low) ? spare_cells : 0, within, is_open(s, high) ? spare_cells : 0};
}
Cut across(const Scene& s) { return cut(s, 0, Side::left, Side::right); }
Cut deep(const Scene& s) { return cut(s, 2, Side::front, Side::back); }
/// The grid has as many rows above the box as its bodies ask for.
Cut upwards(const Scene& s) {
  Cut c = cut(s, 1, Side::bottom, Side::top);
  c.behind = 0;
  return c;
}

template <int axes>
BasicLattice<axes> lattice(const Scene& s) {
  const Composition& all = s.composition;
  const Cut x = across(s), y = upwards(s);
  BasicLattice<axes> l;
  l.cell.template head<2>() = Vec2(x.cell, y.cell);
  l.origin = vector(all.low).head<axes>();
  l.origin.x() -= x.before * x.cell, l.origin.y() -= y.before * y.cell;
  l.columns = x.all(), l.rows = y.all();
  l.empty_rows = y.before;
  l.width = edges(all).x();
  l.center = 0.5 * (vector(all.low) + vector(all.high)).head<axes>();
  if constexpr (axes == 3) {
    const Cut z = deep(s);
    l.cell.z() = z.cell, l.slices = z.all();
    l.origin.z() -= z.before * z.cell;
  }
  return l;
}

Floor floor(const Scene& s) {
  switch (s.composition.face(Side::bottom)) {
    case Face::mirror:
      return Floor::mirror;
    case Face::wall:
      return Floor::impact_wall;
    case Face::open:
      break;
  }
  return Floor::open;
}

template <int axes>
BasicState<axes> without_bodies(const Scene& s) {
  const BasicLattice<axes> l = lattice<axes>(s);
  BasicState<axes> state = empty_state_of<axes>(s, l);
  state.open = {is_open(s, Side::left), is_open(s, Side::right), is_open(s, Side::front),
                is_open(s, Side::back)};
  if (s.composition.face(Side::top) == Face::mirror) state.ceiling = l.rows;
  state.gravity = vector(s.composition.gravity).head<axes>();
  state.gravity_rise = s.composition.gravity_rise;
  return state;
}

template <int axes>
void add_body(BasicState<axes>& state, const Scene& s, const ComposedBody& b) {
  auto& ps = state.particles;
  const std::size_t first = ps.size();
  if (b.rigid)
    state.has_rigid_bodies = true;
  else
    fill(state, {region_in<axes>(s.composition, b), velocity_at_start<axes>(b)}, s, b.material);
  const double pressure = pressure_per_energy(material_of(s, b.material)) * b.energy;
  for (std::size_t p = first; p < ps.size(); ++p) ps.energy[p] = b.energy, ps.pressure[p] = pressure;
  ps.body_ends.push_back(ps.size());
}

template <int axes>
BasicState<axes> state(const Scene& s) {
  BasicState<axes> state = without_bodies<axes>(s);
  for (const ComposedBody& b : s.composition.bodies) add_body(state, s, b);
  return state;
}

/// The scene on cells that are few enough to be filled when it is only looked at.
Scene coarse(Scene s) {
  const Composition& all = s.composition;
  const double largest = edges(all).maxCoeff();
  s.numerics.cell_size = std::max(s.numerics.cell_size, largest / look_cells(axes_of(s.space)));
  return s;
}

template <int axes>
double size(const Scene& s, const BasicLattice<axes>&) {
  const BasicState<axes> looked_at = state<axes>(coarse(s));
  double sum = 0;
  for (std::size_t p = 0; p < looked_at.particles.size(); ++p) sum += filled(looked_at, p);
  return sum;
}

/// The forms that a space has not, in the words of study files.
std::string refusal_of_form(const Shape& shape, Space space) {
  if (shape.form == Shape::Form::cylinder && space != Space::three_d)
    return space == Space::axisymmetric ? "a block from x = 0 on, which is a cylinder about the axis"
                                        : "a ball, which is a cylinder along z in plane strain";
  for (const Shape& part : shape.parts)
    if (std::string refusal = refusal_of_form(part, space); !refusal.empty()) return refusal;
  return {};
}

void check_gravity(const Scene& s, Report& report) {
  const Triple& g = s.composition.gravity;
  const auto add = [&](const char* allowed) {
    report.add_other("box.gravity", vector_text(g, axes_of(s.space), "m/s2"), allowed);
  };
  if (!vector(g).allFinite()) return add("made of finite numbers");
  if (!(s.composition.gravity_rise >= 0 && std::isfinite(s.composition.gravity_rise)))
    report.add_other("box.gravity_rise", text_of(s.composition.gravity_rise) + " s", "0 or more");
  if (s.space == Space::axisymmetric && g[0] != 0) add("along y, the axis, when space is \"axisymmetric\"");
}

void check_box(const Scene& s, Report& report) {
  const Composition& all = s.composition;
  const int axes = axes_of(s.space);
  for (int k = 0; k < axes; ++k)
    if (!(at(all.high, k) > at(all.low, k)))
      report.add_other("box", vector_text(all.high, axes, "m"),
                       "high above low = " + vector_text(all.low, axes, "m") + " along each axis");
  if (s.space == Space::axisymmetric && all.low[0] != 0)
    report.add_other("box", "low x = " + text_of(all.low[0]) + " m",
                     "from x = 0 on, the axis, when space is \"axisymmetric\"");
  if (s.space == Space::axisymmetric && is_open(s, Side::left))
    report.add_other("faces.left", "open", "\"mirror\" when space is \"axisymmetric\": it is the axis");
  for (const Side side : {Side::left, Side::right, Side::top, Side::front, Side::back})
    if (all.face(side) == Face::wall)
      report.add_other("faces." + std::string(side_words[static_cast<std::size_t>(side)]), "wall",
                       "\"mirror\" or \"open\": a wall that lets go is there at the bottom only");
  if (all.face(Side::top) == Face::mirror && s.numerics.kernel != Kernel::reference)
    report.add_other("faces.top", "mirror",
                     "\"open\", or kernel = \"reference\": the fast step has no mirror there");
  check_gravity(s, report);
  if (!report.empty()) return;
  constexpr double most_cells = 1e9;
  const double h = s.numerics.cell_size;
  double cells = 1;
  for (int k = 0; k < axes; ++k) cells *= edges(all)[k] / h;
  report.require(cells <= most_cells, "cell_size",
                 "large enough for at most 1e9 cells of the box (these would be " + text_of(cells) + ")");
  if (!report.empty()) return;
  if (across(s).all() < fewest_cells || (axes == 3 && deep(s).all() < fewest_cells))
    report.require(false, "cell_size", "small enough for 3 cells between the sides of the box");
}

void check_bodies(const Scene& s, Report& report) {
  const Composition& all = s.composition;
  if (all.bodies.empty()) report.add_other("body", "none", "a scene of one body or more");
  std::set<std::string> names;
  std::size_t material = 0;
  bool moves = false;
  for (const ComposedBody& b : all.bodies) {
    const std::string what = "body " + b.name;
    if (!names.insert(b.name).second) report.add_other(what, "named twice", "bodies with names of their own");
    if ((b.material < material && !b.rigid) || b.material >= material_count(s))
      report.add_other(what, "material " + std::to_string(b.material),
                       "of the materials of the scene, bodies in their order");
    material = b.rigid ? material : b.material;
    moves = moves || vector(b.velocity).norm() > 0 || b.spin != 0 || b.radial.speed != 0 || b.energy != 0;
    if (const std::string instead = refusal_of_form(b.shape, s.space); !instead.empty())
      report.add_other(what + ", shape", "cylinder", instead);
    else
      check_start(s, b, report);
    if (s.space == Space::axisymmetric && (b.velocity[0] != 0 || b.spin != 0))
      report.add_other(what + ", velocity", vector_text(b.velocity, 2, "m/s"),
                       "along y, without a spin, when space is \"axisymmetric\"");
  }
  check_contacts(s, report);
  if (!all.bodies.empty() && !moves && !all.has_gravity())
    report.add_other(
        "body", "nothing moves",
        "scenes in which a body has a velocity, a spin, or an energy or pressure at the start, or that "
        "have gravity");
}

/// What only bodies that are filled show: that they overlap, or are not there.
template <int axes>
void check_filled(const Scene& scene, Report& report) {
  const Scene s = coarse(scene);
  BasicState<axes> state = without_bodies<axes>(s);
  for (const ComposedBody& b : s.composition.bodies) {
    try {
      add_body(state, s, b);
    } catch (const InputError& error) {
      report.add_other("body " + b.name, error.what(),
                       "bodies apart from each other, each of them in the box and as large as a cell");
      return;
    }
  }
}

void check(const Scene& s, Report& report) {
  check_box(s, report);
  check_bodies(s, report);
  if (report.empty()) axes_of(s.space) == 2 ? check_filled<2>(s, report) : check_filled<3>(s, report);
}

Extent extent(const Scene& s) {
  const Vec3 box = edges(s.composition);
  return {box.x(), box.y(), box.z()};
}

/// The wall of a ring, a shell or a tube, which is one round shape without another that differs in its radius
/// alone [m]; empty: it is none.
std::optional<double> wall_of(const Shape& shape) {
  if (shape.form != Shape::Form::difference || shape.parts.size() != 2) return std::nullopt;
  const Shape &outer = shape.parts[0], &inner = shape.parts[1];
  const bool round = outer.form == Shape::Form::ball || outer.form == Shape::Form::cylinder;
  if (!round || outer.form != inner.form ||
      !std::equal(outer.numbers.begin(), outer.numbers.end() - 1, inner.numbers.begin()))
    return std::nullopt;
  return std::abs(outer.numbers.back() - inner.numbers.back());
}

/// Of what a shape is made of, the smallest length across [m].
double smallest_length(const Shape& shape, int axes) {
  const std::vector<double>& n = shape.numbers;
  const auto point = [&](std::size_t at) { return Vec3(n[at], n[at + 1], n[at + 2]); };
  double least = std::numeric_limits<double>::infinity();
  switch (shape.form) {
    case Shape::Form::block:
      return (point(3) - point(0)).head(axes).minCoeff();
    case Shape::Form::ball:
      return 2 * n[3];
    case Shape::Form::ellipsoid:
      return 2 * point(3).head(axes).minCoeff();
    case Shape::Form::cylinder:
      return std::min((point(3) - point(0)).norm(), 2 * n[6]);
    default:
      for (const Shape& part : shape.parts) least = std::min(least, smallest_length(part, axes));
      return std::min(least, wall_of(shape).value_or(least));
  }
}

double coarsest_cell(const Scene& s) {
  const int axes = axes_of(s.space);
  double least = edges(s.composition).head(axes).minCoeff() / 8;
  for (const ComposedBody& b : s.composition.bodies)
    if (!b.rigid) least = std::min(least, smallest_length(b.shape, axes) / 6);
  return least;
}

bool is_half(const Scene& s) {
  return s.composition.low[0] == 0 && s.composition.face(Side::left) == Face::mirror;
}

bool is_half_along_z(const Scene& s) {
  return s.composition.low[2] == 0 && s.composition.face(Side::front) == Face::mirror;
}

std::vector<Part> parts(const Scene& s) {
  std::vector<Part> all;
  for (const ComposedBody& b : s.composition.bodies)
    if (const double size = smallest_length(b.shape, axes_of(s.space)); std::isfinite(size) && !b.rigid)
      all.push_back({"the smallest part or hole of a body", "cell_size", size});
  return all;
}

template <int axes>
BasicMeasurements<axes> measurements(const Scene& s, const BasicState<axes>& state) {
  BasicMeasurements<axes> all;
  if (BasicWorks<axes>::measures(s)) all.push_back(std::make_unique<BasicWorks<axes>>(s, state));
  return all;
}
constexpr Results measured[] = {Works::results};

void set_default_numerics(Numerics& n) {
  n.scheme = ShapeFunction::bspline2;
  n.particles_per_cell = 4;
  n.linear_viscosity = 0.5;
}

template <int axes>
constexpr KindIn<axes> in_axes{
    .lattice = lattice<axes>, .size = size<axes>, .measurements = measurements<axes>, .state = state<axes>};

}  // namespace

extern constinit const Kind bodies{
    .kind = SceneKind::bodies,
    .name = "bodies",
    .quantities = {},
    .results = measured,
    .headline = "hot_spot_temperature_K",
    .is_composed = true,
    .set_default_numerics = set_default_numerics,
    .check = check,
    .extent = extent,
    .floor = floor,
    .fastest = fastest_at_start,
    .coarsest_cell = coarsest_cell,
    .parts = parts,
    .is_half = is_half,
    .is_half_along_z = is_half_along_z,
    .of_two_axes = in_axes<2>,
    .of_three_axes = in_axes<3>,
};

}  // namespace mpm
