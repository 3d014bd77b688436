#include "runner/study/shapes.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <span>

#include "runner/study/schema.hpp"

namespace mpmstudy {

std::optional<double> BodyContext::number(std::string_view key, const Value& one,
                                          const Expected& expected) const {
  return quantities.read(key, one, expected, value, mistakes);
}

std::optional<mpm::Triple> BodyContext::vector(std::string_view key, const Value& whole,
                                               std::string_view unit) const {
  const List* list = whole.list();
  if (!list || static_cast<int>(list->size()) != axes()) {
    const std::string names = axes() == 2 ? "two quantities, along x and y" : "three, along x, y and z";
    mistakes.add(key, whole, {"not a list of " + std::to_string(axes()), "allowed: a list of " + names});
    return std::nullopt;
  }
  mpm::Triple triple{};
  bool good = true;
  for (std::size_t k = 0; k < list->size(); ++k) {
    const auto si = number(key, (*list)[k], {unit, mpm::Range::any});
    good = good && si;
    triple[k] = si.value_or(0);
  }
  return good ? std::optional(triple) : std::nullopt;
}

namespace {

using mpm::Shape;
using mpm::Space;

bool has_meridian(Space s) { return s != Space::three_d; }
bool is_round(Space s) { return s != Space::plane_strain; }
bool always(Space) { return true; }

/// The keys of one form, and where it is there.
class Parts {
 public:
  Parts(std::string_view form, const Value& value, const BodyContext& context)
      : form_(form), value_(value), context_(context) {}

  const Value* find(std::string_view key) {
    known_.push_back(key);
    const Table* table = value_.table();
    const Entry* entry = table ? table->find(key) : nullptr;
    if (!entry) {
      context_.mistakes.add(value_.place, path(key), {"missing", std::string(form_) + " needs it"});
      good_ = false;
    }
    return entry ? &entry->value : nullptr;
  }
  void vector(std::string_view key, std::string_view unit = "m") {
    const Value* value = find(key);
    const auto triple = value ? context_.vector(path(key), *value, unit) : std::nullopt;
    good_ = good_ && triple;
    for (const double x : triple.value_or(mpm::Triple{})) numbers.push_back(x);
  }
  void length(std::string_view key) { numbers.push_back(one_length(key)); }
  double one_length(std::string_view key) {
    const Value* value = find(key);
    const auto si = value ? context_.number(path(key), *value, {"m", mpm::Range::positive}) : std::nullopt;
    good_ = good_ && si;
    return si.value_or(1);
  }
  void refuse(std::string_view key, const Refusal& refusal) {
    const Table* table = value_.table();
    const Entry* entry = table ? table->find(key) : nullptr;
    context_.mistakes.add(path(key), entry ? entry->value : value_, refusal);
    good_ = false;
  }
  /// Whether all was there, and nothing else.
  bool good() {
    for (const Entry& entry : entries_of(value_.table()))
      if (std::ranges::find(known_, entry.key) == known_.end()) {
        context_.mistakes.add(entry.place, path(entry.key), entry.value.written(),
                              unknown_word(entry.key, "key of " + std::string(form_), known_));
        good_ = false;
      }
    return good_;
  }
  std::string path(std::string_view key) const {
    return "shape." + std::string(form_) + "." + std::string(key);
  }
  const BodyContext& context() const { return context_; }

  std::vector<double> numbers;

 private:
  std::string_view form_;
  const Value& value_;
  const BodyContext& context_;
  std::vector<std::string_view> known_;
  bool good_ = true;
};

Shape plain(Shape::Form form, Parts& p) { return {form, p.numbers, {}}; }

Shape block(Parts& p) {
  p.vector("low"), p.vector("high");
  const auto axes = static_cast<std::size_t>(p.context().axes());
  for (std::size_t k = 0; k < axes; ++k)
    if (!(p.numbers[3 + k] > p.numbers[k])) {
      p.refuse("high", {"is not above low along each axis", "allowed: corners that are apart"});
      break;
    }
  return plain(Shape::Form::block, p);
}

/// In axisymmetry a circle is a sphere only about a point of the axis.
void check_center(Parts& p) {
  if (p.context().space == Space::axisymmetric && p.numbers[0] != 0)
    p.refuse("center",
             {"is beside the axis", "allowed: x = 0; a disc beside the axis is a torus: write disc"});
}

Shape disc(Parts& p) {
  p.vector("center"), p.length("radius");
  return plain(Shape::Form::ball, p);
}
Shape sphere(Parts& p) {
  const Shape shape = disc(p);
  check_center(p);
  return shape;
}

Shape ring(Parts& p) {
  p.vector("center");
  const double inner = p.one_length("inner_radius"), outer = p.one_length("outer_radius");
  if (inner >= outer) p.refuse("inner_radius", {"is not below outer_radius", "allowed: less than it"});
  const auto ball = [&](double radius) {
    Shape shape = plain(Shape::Form::ball, p);
    shape.numbers.push_back(radius);
    return shape;
  };
  return {Shape::Form::difference, {}, {ball(outer), ball(inner)}};
}
Shape shell(Parts& p) {
  Shape shape = ring(p);
  check_center(p);
  return shape;
}

Shape ellipse(Parts& p) {
  p.vector("center"), p.vector("half_axes");
  for (std::size_t k = 0; k < static_cast<std::size_t>(p.context().axes()); ++k)
    if (!(p.numbers[3 + k] > 0)) p.refuse("half_axes", {"not positive", "allowed: lengths above 0"});
  if (p.context().axes() == 2) p.numbers[5] = 1;
  return plain(Shape::Form::ellipsoid, p);
}
Shape ellipsoid(Parts& p) {
  Shape shape = ellipse(p);
  check_center(p);
  return shape;
}

/// In axisymmetry along the axis: a block of the meridian.
Shape rod(Parts& p, double inner, double outer) {
  if (p.context().space != Space::axisymmetric) {
    const auto of = [&](double radius) {
      Shape shape = plain(Shape::Form::cylinder, p);
      shape.numbers.push_back(radius);
      return shape;
    };
    if (inner == 0) return of(outer);
    return {Shape::Form::difference, {}, {of(outer), of(inner)}};
  }
  if (p.numbers[0] != 0 || p.numbers[3] != 0)
    p.refuse("from",
             {"is beside the axis", "allowed: from and to with x = 0 when space is \"axisymmetric\""});
  const auto [low, high] = std::minmax(p.numbers[1], p.numbers[4]);
  return {Shape::Form::block, {inner, low, 0, outer, high, 0}, {}};
}
void read_ends(Parts& p) {
  p.vector("from"), p.vector("to");
  if (std::equal(p.numbers.begin(), p.numbers.begin() + 3, p.numbers.begin() + 3))
    p.refuse("to", {"is where from is", "allowed: another point"});
}
Shape cylinder(Parts& p) {
  read_ends(p);
  return rod(p, 0, p.one_length("radius"));
}
Shape tube(Parts& p) {
  read_ends(p);
  const double inner = p.one_length("inner_radius"), outer = p.one_length("outer_radius");
  if (inner >= outer) p.refuse("inner_radius", {"is not below outer_radius", "allowed: less than it"});
  return rod(p, inner, outer);
}

double turn_of(const double* a, const double* b, const double* c) {
  return (b[0] - a[0]) * (c[1] - a[1]) - (b[1] - a[1]) * (c[0] - a[0]);
}
/// Whether two edges of a polygon cross. Corners as x, y in turn.
bool crosses_itself(const std::vector<double>& corners) {
  const std::size_t n = corners.size() / 2;
  const auto at = [&](std::size_t k) { return &corners[2 * (k % n)]; };
  for (std::size_t i = 0; i < n; ++i)
    for (std::size_t k = i + 2; k < n; ++k) {
      if (i == 0 && k == n - 1) continue;  // neighbours
      const bool apart = turn_of(at(i), at(i + 1), at(k)) * turn_of(at(i), at(i + 1), at(k + 1)) >= 0 ||
                         turn_of(at(k), at(k + 1), at(i)) * turn_of(at(k), at(k + 1), at(i + 1)) >= 0;
      if (!apart) return true;
    }
  return false;
}

Shape polygon(Parts& p) {
  const Value* corners = p.find("corners");
  const List* list = corners ? corners->list() : nullptr;
  if (!list || list->size() < 3) {
    if (corners) p.refuse("corners", {"not a polygon", "allowed: a list of three corners [x, y] or more"});
    return {};
  }
  // of three axes corners have two coordinates, too
  BodyContext in_plane{Space::plane_strain, p.context().value, p.context().quantities, p.context().mistakes};
  for (const Value& corner : *list)
    if (const auto point = in_plane.vector(p.path("corners"), corner, "m"))
      p.numbers.insert(p.numbers.end(), {(*point)[0], (*point)[1]});
    else
      p.refuse("corners", {"cannot be read", "allowed: corners [x, y]"});
  if (crosses_itself(p.numbers))
    p.refuse("corners", {"crosses itself", "allowed: edges that do not cross; join polygons with union"});
  return plain(Shape::Form::polygon, p);
}

Shape half_space(Parts& p) {
  p.vector("point"), p.vector("outwards", "1");
  if (p.numbers[3] == 0 && p.numbers[4] == 0 && p.numbers[5] == 0)
    p.refuse("outwards", {"no direction", "allowed: numbers that are not all 0"});
  return plain(Shape::Form::half_space, p);
}

struct FormRow {
  std::string_view word;
  Shape (*read)(Parts&);
  bool (*is_in)(Space);
  std::string_view instead;  ///< in spaces that have it not
  bool is_section = false;   ///< in axisymmetry a part of the half plane, wherever it is put
};
constexpr std::array forms = {
    FormRow{"block", block, always, ""},
    FormRow{"disc", disc, has_meridian, "sphere or cylinder", true},
    FormRow{"ring", ring, has_meridian, "shell or tube", true},
    FormRow{"ellipse", ellipse, has_meridian, "ellipsoid", true},
    FormRow{"polygon", polygon, always, "", true},
    FormRow{"half_space", half_space, always, "", true},
    FormRow{"sphere", sphere, is_round, "disc, which is a cylinder along z in plane strain"},
    FormRow{"shell", shell, is_round, "ring, which is a tube along z in plane strain"},
    FormRow{"ellipsoid", ellipsoid, is_round, "ellipse, which is a cylinder along z in plane strain"},
    FormRow{"cylinder", cylinder, is_round, "disc, which is a cylinder along z in plane strain"},
    FormRow{"tube", tube, is_round, "ring, which is a tube along z in plane strain"},
};
struct Joint {
  std::string_view word;
  Shape::Form form;
};
constexpr std::array joints = {Joint{"union", Shape::Form::together}, Joint{"minus", Shape::Form::difference},
                               Joint{"intersection", Shape::Form::intersection}};

std::vector<std::string_view> shape_words() {
  std::vector<std::string_view> words;
  for (const FormRow& row : forms) words.push_back(row.word);
  for (const Joint& joint : joints) words.push_back(joint.word);
  return words;
}

std::optional<Shape> read_joint(const Joint& joint, const Entry& entry, const BodyContext& context) {
  const List* list = entry.value.list();
  if (!list || list->size() < 2) {
    context.mistakes.add(
        "shape." + entry.key, entry.value,
        {"not a list of shapes", "allowed: two shapes or more, such as [{ block = ... }, ...]"});
    return std::nullopt;
  }
  Shape whole{joint.form, {}, {}};
  bool good = true;
  for (const Value& part : *list) {
    auto shape = read_shape({"shape", part.place, part}, context);
    good = good && shape;
    if (shape) whole.parts.push_back(std::move(*shape));
  }
  return good ? std::optional(whole) : std::nullopt;
}

/// cos and sin of an angle; exact where it is a multiple of a right angle.
std::array<double, 2> direction_of(double angle) {
  const double quarters = angle / (3.14159265358979323846 / 2);
  const double whole = std::round(quarters);
  if (std::abs(quarters - whole) > 1e-12) return {std::cos(angle), std::sin(angle)};
  constexpr std::array<double, 4> cosines = {1, 0, -1, 0};
  const auto at = static_cast<std::size_t>((static_cast<long>(whole) % 4 + 4) % 4);
  return {cosines[at], cosines[(at + 3) % 4]};
}

/// { angle = "30 deg", about = [...], axis = "z" }, anticlockwise seen from the end of the axis.
bool turn(Shape& shape, const Entry& entry, const BodyContext& context) {
  const Table* table = entry.value.table();
  const Entry* angle = table ? table->find("angle") : nullptr;
  const Entry* about = table ? table->find("about") : nullptr;
  const Entry* along = table ? table->find("axis") : nullptr;
  if (!angle || !about || table->entries.size() != (along ? 3u : 2u)) {
    context.mistakes.add("shape.rotate", entry.value,
                         {"not a rotation",
                          "allowed: { angle = \"30 deg\", about = [...] }, of three axes with axis = \"z\""});
    return false;
  }
  constexpr std::array<std::string_view, 3> axis_names = {"x", "y", "z"};
  const std::string* word = along ? along->value.string() : nullptr;
  const auto axis = std::ranges::find(axis_names, along ? (word ? *word : "") : "z");
  if (axis == axis_names.end() || (context.space != Space::three_d && *axis != "z")) {
    context.mistakes.add(
        "shape.rotate.axis", along->value,
        unknown_word(word ? *word : "", "axis of rotation here",
                     context.space == Space::three_d ? std::vector<std::string_view>{"x", "y", "z"}
                                                     : std::vector<std::string_view>{"z"}));
    return false;
  }
  if (shape.form == Shape::Form::polygon && *axis != "z") {
    context.mistakes.add("shape.rotate.axis", along->value,
                         {"turns a prism out of its axis", "allowed for a polygon: \"z\""});
    return false;
  }
  const auto radians = context.number("shape.rotate.angle", angle->value, {"rad", mpm::Range::any});
  const auto center = context.vector("shape.rotate.about", about->value, "m");
  if (!radians || !center) return false;
  const auto [c, s] = direction_of(*radians);
  const auto k = static_cast<std::size_t>(axis - axis_names.begin()), i = (k + 1) % 3, j = (k + 2) % 3;
  std::array<double, 9> rotation{};
  rotation[3 * k + k] = 1;
  rotation[3 * i + i] = rotation[3 * j + j] = c;
  rotation[3 * i + j] = -s, rotation[3 * j + i] = s;
  for (std::size_t a = 0; a < 3; ++a) {
    double moved = 0;
    for (std::size_t b = 0; b < 3; ++b) moved += rotation[3 * a + b] * (*center)[b];
    shape.shift[a] = (*center)[a] - moved;
  }
  shape.rotation = rotation;
  return true;
}

}  // namespace

std::optional<mpm::Shape> read_shape(const Entry& entry, const BodyContext& context) {
  const Table* table = entry.value.table();
  std::optional<Shape> shape;
  int count = 0;
  bool good = table != nullptr, is_section = false;
  for (const Entry& one : entries_of(table)) {
    if (one.key == "rotate" || one.key == "translate") continue;
    ++count;
    const auto form = std::ranges::find(forms, one.key, &FormRow::word);
    const auto joint = std::ranges::find(joints, one.key, &Joint::word);
    if (form != forms.end()) {
      if (!form->is_in(context.space)) {
        context.mistakes.add("shape." + one.key, one.value,
                             {"is no shape of this space", "write " + std::string(form->instead)});
        good = false;
        continue;
      }
      Parts parts(one.key, one.value, context);
      shape = form->read(parts);
      is_section = form->is_section;
      good = parts.good() && good;
    } else if (joint != joints.end()) {
      shape = read_joint(*joint, one, context);
      good = good && shape;
    } else {
      context.mistakes.add(one.place, "shape." + one.key, one.value.written(),
                           unknown_word(one.key, "shape", shape_words()));
      good = false;
    }
  }
  if (count != 1 && good) {
    context.mistakes.add(entry.key, entry.value,
                         {count == 0 ? "no shape" : "more than one shape",
                          "allowed: one of " + listed(shape_words()) +
                              ", with rotate and translate beside it; union and minus join shapes"});
    good = false;
  }
  if (!good || !shape) return std::nullopt;
  // what is round about the axis stays there
  const bool is_about_axis = context.space == Space::axisymmetric && !is_section;
  const Refusal off_axis{
      "takes a shape off the axis",
      "allowed when space is \"axisymmetric\": disc, ring, ellipse, polygon and half_space turn and "
      "move; others move along y"};
  if (const Entry* rotate = table->find("rotate")) {
    if (is_about_axis) context.mistakes.add("shape.rotate", rotate->value, off_axis);
    good = turn(*shape, *rotate, context) && !is_about_axis;
  }
  if (const Entry* translate = table->find("translate")) {
    const auto way = context.vector("shape.translate", translate->value, "m");
    good = good && way;
    if (way && (*way)[0] != 0 && is_about_axis) {
      context.mistakes.add("shape.translate", translate->value, off_axis);
      good = false;
    }
    for (std::size_t k = 0; k < 3 && way; ++k) shape->shift[k] += (*way)[k];
  }
  return good ? shape : std::nullopt;
}

}  // namespace mpmstudy
