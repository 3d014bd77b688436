#include "libmpm/scene/parameters.hpp"

#include <algorithm>
#include <initializer_list>
#include <stdexcept>
#include <string>
#include <utility>

#include "libmpm/core/enumerators.hpp"
#include "libmpm/material/rows.hpp"
#include "libmpm/scene/kinds/kind.hpp"

namespace mpm {
namespace {

using S = Scene;
constexpr auto P = Section::parameters;
constexpr auto N = Section::numerics;
constexpr auto positive = Range::positive;
constexpr auto non_negative = Range::non_negative;
constexpr bool required = true;
constexpr bool optional = false;
constexpr bool derived = true;

#define FIELD(member) [](const S& s) -> double { return s.member; }, [](S& s, double v) { s.member = v; }

/// Rows that every kind of scene has, beside those of the material.
// clang-format off
constexpr Quantity common_quantities[] = {
    {"end_time", "s", "t", "end_time_s", "time at which a run ends",
     P, positive, required, "", FIELD(end_time)},
    {"cell_size", "m", "h", "cell_size_m", "edge of a grid cell",
     N, positive, required, "", FIELD(numerics.cell_size)},
    {"particles_per_cell", "1", "", "particles_per_cell", "particles per cell: 1, 4, 9 or 16; in three-d 1, 8 or 27",
     N, Range::count, optional, "",
     [](const S& s) -> double { return s.numerics.particles_per_cell; },
     [](S& s, double v) { s.numerics.particles_per_cell = static_cast<int>(v); }},
    {"cfl", "1", "", "cfl", "share of the stability limit that a time step takes",
     N, positive, optional, "", FIELD(numerics.cfl)},
    {"pic_fraction", "1", "", "pic_fraction", "share of PIC in the FLIP transfer, per step; damps what the grid cannot see",
     N, non_negative, optional, "", FIELD(numerics.pic_fraction)},
    {"linear_viscosity", "1", "", "linear_viscosity", "linear coefficient of the artificial viscosity",
     N, non_negative, optional, "", FIELD(numerics.linear_viscosity)},
    {"quadratic_viscosity", "1", "", "quadratic_viscosity", "quadratic coefficient of the artificial viscosity",
     N, non_negative, optional, "", FIELD(numerics.quadratic_viscosity)},

    {"area_every", "s", "", "area_every_s", "period of the area history and of gauges",
     Section::measure, positive, optional, "", FIELD(measures.area_every)},
};
// clang-format on
#undef FIELD

constexpr auto scheme_words = words<ShapeFunction>({{ShapeFunction::gimp, "gimp"},
                                                    {ShapeFunction::bspline2, "bspline2"},
                                                    {ShapeFunction::cpdi, "cpdi"},
                                                    {ShapeFunction::bspline3, "bspline3"},
                                                    {ShapeFunction::linear, "linear"}});
constexpr auto transfer_words = words<Transfer>({{Transfer::flip, "flip"}, {Transfer::apic, "apic"}});
constexpr auto symmetry_words = words<Symmetry>({{Symmetry::half, "half"}, {Symmetry::full, "full"}});
constexpr auto space_words = words<Space>({{Space::plane_strain, "plane-strain"},
                                           {Space::axisymmetric, "axisymmetric"},
                                           {Space::three_d, "three-d"}});
constexpr auto kernel_words = words<Kernel>({{Kernel::fast, "fast"}, {Kernel::reference, "reference"}});
constexpr auto wall_gap_words = words<WallGap>({{WallGap::unseen, "unseen"}, {WallGap::tracked, "tracked"}});
constexpr auto precision_words =
    words<Precision>({{Precision::double_precision, "double"}, {Precision::single_precision, "float"}});

#define CHOICE(member)                                           \
  [](const S& s) { return static_cast<std::size_t>(s.member); }, \
      [](S& s, std::size_t i) { s.member = static_cast<decltype(s.member)>(i); }

constexpr Choice common_choices[] = {
    {"space", "space",
     "plane strain; axial symmetry about x = 0: circles are spheres, blocks cylinders; or three dimensions: "
     "circles are spheres, blocks as deep as wide",
     Section::top, space_words, CHOICE(space), "plane-strain"},
    {"scheme", "scheme", "shape functions", N, scheme_words, CHOICE(numerics.scheme)},
    {"transfer", "transfer",
     "how particles and grid exchange velocities: acceleration, or velocity and gradient", N, transfer_words,
     CHOICE(numerics.transfer), "flip"},
    {"symmetry", "symmetry",
     "model half of the scene (a quarter of a shell; in three-d a quarter, of a shell an octant) or all of "
     "it",
     N, symmetry_words, CHOICE(numerics.symmetry)},
    {"kernel", "kernel", "code that takes the steps: the fast one, or the plain one that it is held against",
     N, kernel_words, CHOICE(numerics.kernel)},
    {"precision", "precision", "numbers of the fast step; the reference step has double only", N,
     precision_words, CHOICE(numerics.precision)},
    {"wall_gap", "wall_gap",
     "when the impact wall pushes a body that comes back: from a cell away, or once the gap that has opened "
     "is "
     "closed",
     N, wall_gap_words, CHOICE(numerics.wall_gap), "unseen"},
};
#undef CHOICE

/// Row number i of a material's, as one of the scene.
template <std::size_t i>
Quantity quantity_of_material() {
  const MaterialRow& row = material_rows[i];
  return {row.name,
          row.unit,
          row.symbol,
          row.column,
          row.meaning,
          row.section,
          row.range,
          optional,
          "",
          [](const Scene& s) -> double { return s.material.*material_rows[i].value; },
          [](Scene& s, double v) { s.material.*material_rows[i].value = v; },
          {},
          false,
          row.implied};
}
template <std::size_t i>
Choice choice_of_material() {
  const MaterialChoice& row = material_choices[i];
  return {row.name,
          row.name,
          row.meaning,
          Section::material,
          row.allowed,
          [](const Scene& s) { return material_choices[i].get(s.material); },
          [](Scene& s, std::size_t v) { material_choices[i].set(s.material, v); },
          row.implied};
}

/// What all scenes have, in the order of the sections.
template <class Row>
std::vector<Row> common_rows(std::span<const Row> own, std::initializer_list<Row> of_material) {
  std::vector<Row> rows(own.begin(), own.end());
  rows.insert(rows.end(), of_material);
  std::ranges::stable_sort(rows, {}, &Row::section);
  return rows;
}
std::vector<Quantity> all_common_quantities() {
  return [&]<std::size_t... i>(std::index_sequence<i...>) {
    return common_rows<Quantity>(common_quantities, {quantity_of_material<i>()...});
  }
  (std::make_index_sequence<material_rows.size()>());
}
std::vector<Choice> all_common_choices() {
  return [&]<std::size_t... i>(std::index_sequence<i...>) {
    return common_rows<Choice>(common_choices, {choice_of_material<i>()...});
  }
  (std::make_index_sequence<material_choices.size()>());
}

template <class Rows>
auto find_row(const Rows& rows, std::string_view name) -> decltype(&rows[0]) {
  for (const auto& row : rows)
    if (row.name == name) return &row;
  return nullptr;
}

/// Takes the rows of a kind; one that an earlier kind has too is shared.
template <class Row>
void add(std::vector<Row>& table, std::span<const Row> rows, SceneKind kind, bool parameters) {
  for (Row row : rows) {
    if ((row.section == Section::parameters) != parameters) continue;
    const unsigned bit = 1u << static_cast<unsigned>(kind);
    const auto there = std::ranges::find(table, row.name, &Row::name);
    if (there == table.end()) {
      row.belongs_to.bits = bit;
      table.push_back(row);
    } else if (there->get == row.get && there->set == row.set && there->column == row.column) {
      there->belongs_to.bits |= bit;
    } else {
      throw std::logic_error("two kinds of scene have different rows " + std::string(row.name));
    }
  }
}

/// What scenes of a kind are made of, what all scenes have, and how scenes of a kind are measured and
/// computed.
template <class Row>
std::vector<Row> table_of(const std::vector<Row>& common, std::span<const Row> Kind::*own) {
  std::vector<Row> table;
  for (const Kind* kind : kinds()) add(table, kind->*own, kind->kind, true);
  table.insert(table.end(), common.begin(), common.end());
  for (const Kind* kind : kinds()) add(table, kind->*own, kind->kind, false);
  return table;
}

const std::vector<Quantity>& quantity_table() {
  static const auto table = table_of(all_common_quantities(), &Kind::quantities);
  return table;
}
const std::vector<Choice>& choice_table() {
  static const auto table = [] {
    auto all = table_of(all_common_choices(), &Kind::choices);
    // how much of a composed scene is modelled is what its box and its faces say
    Choice& symmetry = *std::ranges::find(all, "symmetry", &Choice::name);
    for (const Kind* kind : kinds())
      if (kind->is_composed) symmetry.belongs_to.bits &= ~(1u << static_cast<unsigned>(kind->kind));
    return all;
  }();
  return table;
}

const std::vector<std::string_view>& kind_names() {
  static const auto names = [] {
    std::vector<std::string_view> all;
    for (const Kind* kind : kinds()) all.push_back(kind->name);
    return all;
  }();
  return names;
}

}  // namespace

std::span<const Quantity> quantities() { return quantity_table(); }
std::span<const Choice> choices() { return choice_table(); }
const Quantity* find_quantity(std::string_view name) { return find_row(quantity_table(), name); }
/// yield_stress stands with the parameters that studies sweep.
bool is_of_material(const Quantity& row) {
  return row.section == Section::material || row.name == "yield_stress";
}

const Choice* find_choice(std::string_view name) {
  if (name == material_choice().name) return &material_choice();
  return find_row(choice_table(), name);
}

const Choice& material_choice() {
  static const Choice choice = [] {
    Choice c{"material",
             "material",
             "named material; [material] replaces constants of it",
             Section::parameters,
             material_names(),
             [](const Scene& s) {
               const auto names = material_names();
               return static_cast<std::size_t>(std::ranges::find(names, s.material.name) - names.begin());
             },
             [](Scene& s, std::size_t i) { s.material = named_material(material_names()[i]); }};
    for (const Kind* kind : kinds()) c.belongs_to.bits |= 1u << static_cast<unsigned>(kind->kind);
    return c;
  }();
  return choice;
}

std::span<const std::string_view> scene_kind_names() { return kind_names(); }
std::string_view to_string(SceneKind kind) { return kind_of(kind).name; }
std::optional<SceneKind> scene_kind_from(std::string_view name) {
  for (const Kind* kind : kinds())
    if (kind->name == name) return kind->kind;
  return std::nullopt;
}

}  // namespace mpm
