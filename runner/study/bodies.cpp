#include "runner/study/bodies.hpp"

#include <algorithm>
#include <array>

#include "libmpm/scene/effect.hpp"
#include "libmpm/scene/parameters.hpp"
#include "runner/study/check_words.hpp"
#include "runner/study/contact_rules.hpp"
#include "runner/study/shapes.hpp"

namespace mpmstudy {
namespace {

constexpr std::string_view energy_key = "specific_internal_energy", pressure_key = "pressure";
constexpr std::array<std::string_view, 10> body_keys = {
    "name",  "material",        "shape",    "velocity",   "angular_velocity",
    "about", "radial_velocity", energy_key, pressure_key, "rigid"};
constexpr std::string_view gravity_key = "gravity", rise_key = "gravity_rise";

bool is_rigid(const Table& body) {
  const Entry* rigid = body.find("rigid");
  const bool* said = rigid ? std::get_if<bool>(&rigid->value.data) : nullptr;
  return said && *said;
}

/// Of [materials.NAME], beside base.
std::vector<std::string_view> keys_of_materials() {
  std::vector<std::string_view> keys;
  for (const mpm::Quantity& row : mpm::quantities())
    if (mpm::is_of_material(row)) keys.push_back(row.name);
  for (const mpm::Choice& row : mpm::choices())
    if (row.section == mpm::Section::material) keys.push_back(row.name);
  return keys;
}

const std::string* text_at(const Table& table, std::string_view key) {
  const Entry* entry = table.find(key);
  return entry ? entry->value.string() : nullptr;
}

/// { speed = "-100 m/s", at = "1 um", exponent = -1, about = [...] }; without at and exponent one speed.
/// Empty after adding mistakes.
std::optional<mpm::RadialVelocity> read_radial(const Entry& entry, const BodyContext& context) {
  constexpr std::array<std::string_view, 4> keys = {"speed", "at", "exponent", "about"};
  const std::string what = "body." + entry.key;
  const Table* table = entry.value.table();
  const auto find = [&](const char* key) { return table ? table->find(key) : nullptr; };
  const Entry *speed = find("speed"), *at = find("at"), *exponent = find("exponent"), *about = find("about");
  if (!speed || !about || !at != !exponent) {
    context.mistakes.add(what, entry.value,
                         {"not a radial velocity",
                          "allowed: { speed = \"-100 m/s\", about = [...] }, for a speed that depends on the "
                          "radius with at = \"1 um\" and exponent = -1"});
    return std::nullopt;
  }
  if (!check_words(*table, what, keys, context.mistakes)) return std::nullopt;
  const auto number = [&](const Entry& one, const Expected& expected) {
    return context.number(what + "." + one.key, one.value, expected);
  };
  const auto v = number(*speed, {"m/s", mpm::Range::any});
  const auto center = context.vector(what + ".about", about->value, "m");
  const auto radius = at ? number(*at, {"m", mpm::Range::positive}) : 1;
  const auto power = exponent ? number(*exponent, {"1", mpm::Range::any}) : 0;
  if (!v || !center || !radius || !power) return std::nullopt;
  return mpm::RadialVelocity{*v, *radius, *power, *center};
}

/// The energy of a body at the start, said as it is or as the pressure that it makes; 0 after adding
/// mistakes.
double read_energy(const Table& body, const mpm::Material& material, const BodyContext& context) {
  const Entry *energy = body.find(energy_key), *pressure = body.find(pressure_key);
  const auto read = [&](const Entry& entry, const char* unit) {
    return context.number("body." + entry.key, entry.value, {unit, mpm::Range::non_negative}).value_or(0);
  };
  if (!pressure) return energy ? read(*energy, "J/kg") : 0;
  const double per_energy = mpm::pressure_per_energy(material);
  if (energy || per_energy == 0) {
    context.mistakes.add("body.pressure", pressure->value,
                         energy ? Refusal{"stands beside specific_internal_energy", "allowed: one of them"}
                                : Refusal{"of a material whose pressure knows no heat",
                                          "allowed: a material with a positive gruneisen_gamma, or a gas"});
    return 0;
  }
  return read(*pressure, "Pa") / per_energy;
}

/// All of a [[body]] but its material and its energy. Empty after adding mistakes about its keys or its name.
std::optional<mpm::ComposedBody> read_body(const Value& one, const BodyContext& context) {
  Mistakes& mistakes = context.mistakes;
  const Table* table = one.table();
  if (!table || !check_words(*table, "body", body_keys, mistakes)) return std::nullopt;
  mpm::ComposedBody body;
  const Entry *name = table->find("name"), *shape = table->find("shape");
  if (!name || !name->value.string() || name->value.string()->empty()) {
    mistakes.add(name ? name->value.place : one.place, "body.name",
                 {name ? "not a name" : "missing", "allowed: a text such as \"flyer\""});
    return std::nullopt;
  }
  body.name = *name->value.string();
  if (body.name == "all")
    mistakes.add("body.name", name->value, {"is kept for gauges of all bodies", "allowed: another name"});
  if (shape) {
    if (auto read = read_shape(*shape, context)) body.shape = std::move(*read);
  } else {
    mistakes.add(one.place, "body.shape", {"missing", "[[body]] needs shape = { ... }"});
  }
  if (const Entry* velocity = table->find("velocity"))
    body.velocity = context.vector("body.velocity", velocity->value, "m/s").value_or(mpm::Triple{});
  if (const Entry* rigid = table->find("rigid")) {
    if (!std::get_if<bool>(&rigid->value.data))
      mistakes.add("body.rigid", rigid->value, {"not true or false", "allowed: true, false"});
    body.rigid = is_rigid(*table);
    for (const std::string_view key :
         {std::string_view("material"), std::string_view("radial_velocity"), energy_key, pressure_key})
      if (const Entry* entry = body.rigid ? table->find(key) : nullptr)
        mistakes.add("body." + std::string(key), entry->value, {"a rigid body has none", "remove it"});
  }
  const Entry *spin = table->find("angular_velocity"), *about = table->find("about");
  if (!spin != !about)
    mistakes.add(
        one.place, spin ? "body.about" : "body.angular_velocity",
        {"missing", "a body that turns has angular_velocity and about, the point that it turns about"});
  if (spin && about) {
    body.spin = context.number("body.angular_velocity", spin->value, {"rad/s", mpm::Range::any}).value_or(0);
    body.about = context.vector("body.about", about->value, "m").value_or(mpm::Triple{});
  }
  if (const Entry* radial = table->find("radial_velocity"))
    body.radial = read_radial(*radial, context).value_or(mpm::RadialVelocity{});
  return body;
}

}  // namespace

BodiesReader::BodiesReader(const Table& document, const Units& units, KnownParameters known)
    : document_(document), quantities_(units, std::move(known)) {
  const auto keep = [&](const std::string& name, const Place& place) { places_.try_emplace(name, place); };
  for (const auto name : {box_table, faces_table, body_table, contact_table})
    if (const Entry* entry = document.find(name)) keep(std::string(name), entry->place);
  if (const Entry* contacts = document.find(contact_table))
    if (const List* list = contacts->value.list())
      for (std::size_t k = 0; k < list->size(); ++k)
        for (const char* key : {", between", ", friction"})
          keep("contact " + std::to_string(k + 1) + key, (*list)[k].place);
  for (const Entry& entry : entries_of(document.find_table(faces_table)))
    keep("faces." + entry.key, entry.value.place);
  if (const Table* box = document.find_table(box_table))
    for (const std::string_view key : {gravity_key, rise_key})
      if (const Entry* entry = box->find(key)) keep("box." + std::string(key), entry->value.place);
  for (const Value& body : bodies()) {
    const Table* table = body.table();
    const std::string* name = table ? text_at(*table, "name") : nullptr;
    if (!name) continue;
    keep("body " + *name, body.place);
    for (const char* part : {"shape", "velocity", "radial_velocity", "specific_internal_energy"})
      if (const Entry* entry = table->find(part)) keep("body " + *name + ", " + part, entry->value.place);
  }
  for (const Entry& one : entries_of(document.find_table(materials_table))) {
    for (const auto key : keys_of_materials()) keep(std::string(key) + " of " + one.key, one.place);
    for (const Entry& entry : entries_of(one.value.table()))
      places_[entry.key + " of " + one.key] = entry.value.place;
  }
}

const List& BodiesReader::bodies() const {
  static const List none;
  const Entry* entry = document_.find(body_table);
  const List* list = entry ? entry->value.list() : nullptr;
  return list ? *list : none;
}

bool BodiesReader::uses_study_material() const {
  return std::ranges::any_of(bodies(), [](const Value& body) {
    return body.table() && !body.table()->find("material") && !is_rigid(*body.table());
  });
}

std::vector<std::string_view> BodiesReader::known_materials() const {
  std::vector<std::string_view> known(mpm::material_names().begin(), mpm::material_names().end());
  for (const Entry& one : entries_of(document_.find_table(materials_table))) known.push_back(one.key);
  return known;
}

bool BodiesReader::knows_all_materials() const {
  const std::vector<std::string_view> known = known_materials();
  return std::ranges::all_of(bodies(), [&](const Value& body) {
    const Entry* material = body.table() ? body.table()->find("material") : nullptr;
    const std::string* name = material ? material->value.string() : nullptr;
    return !material || (name && std::ranges::find(known, *name) != known.end());
  });
}

const Place* BodiesReader::place_of(std::string_view parameter) const {
  const auto found = places_.find(parameter);
  return found == places_.end() ? nullptr : &found->second;
}

std::vector<std::string> BodiesReader::warnings() const {
  std::vector<std::string> lines;
  for (const Entry& one : entries_of(document_.find_table(materials_table))) {
    const Table* table = one.value.table();
    const Entry* density = table && table->find("base") ? table->find("reference_density") : nullptr;
    if (!density) continue;
    for (const char* other : {"specific_heat", "pressure_limit"})
      if (!table->find(other))
        lines.push_back(density->value.place.text() + ": " + one.key +
                        " has another reference_density than " + "its base, whose " + other + " it keeps");
  }
  return lines;
}

std::optional<mpm::Material> BodiesReader::read_material(const mpm::Scene& scene, std::string_view name,
                                                         const ValueOf& value, Mistakes& mistakes) {
  const Table* materials = document_.find_table(materials_table);
  const Entry* entry = materials ? materials->find(name) : nullptr;
  if (!entry) return mpm::named_material(name);
  const Table* table = entry->value.table();
  const std::string what = "materials." + std::string(name);
  if (!table) {
    mistakes.add(what, entry->value, {"not a table", "write [" + what + "]"});
    return std::nullopt;
  }
  auto keys = keys_of_materials();
  keys.push_back("base");
  if (!check_words(*table, what, keys, mistakes)) return std::nullopt;
  mpm::Scene of = scene;  // rows are of scenes
  of.material = {};
  bool good = true;
  if (const Entry* base = table->find("base")) {
    const auto names = mpm::material_names();
    const auto word = find_word(what + ".base", base->value, "material", names, mistakes);
    if (!word) return std::nullopt;
    of.material = mpm::named_material(names[*word]);
  }
  for (const mpm::Quantity& row : mpm::quantities()) {
    const Entry* given = mpm::is_of_material(row) ? table->find(row.name) : nullptr;
    if (!given) continue;
    const auto si =
        quantities_.read(what + "." + given->key, given->value, {row.unit, row.range}, value, mistakes);
    good = good && si;
    if (si) row.set(of, *si);
  }
  for (const mpm::Choice& row : mpm::choices()) {
    const Entry* given = row.section == mpm::Section::material ? table->find(row.name) : nullptr;
    if (!given) continue;
    const auto word = find_word(what + "." + given->key, given->value, "choice", row.allowed, mistakes);
    good = good && word;
    if (word) row.set(of, *word);
  }
  std::string missing;
  for (const mpm::Quantity& row : mpm::quantities()) {
    const mpm::Condition* condition = mpm::condition_of(row.name);
    if (mpm::is_of_material(row) && !row.derived && !row.implied && !table->find(row.name) &&
        (!condition || condition->holds(of)))
      missing += (missing.empty() ? "" : ", ") + std::string(row.name);
  }
  if (!table->find("base") && !missing.empty()) {
    mistakes.add(entry->place, what,
                 {"has no base and lacks " + missing, "allowed: base = \"...\", or all constants"});
    return std::nullopt;
  }
  of.material.name = name;
  return good ? std::optional(of.material) : std::nullopt;
}

void BodiesReader::read_box(mpm::Scene& scene, const ValueOf& value, Mistakes& mistakes) {
  const Entry* entry = document_.find(box_table);
  const Table* box = entry ? entry->value.table() : nullptr;
  constexpr std::array<std::string_view, 4> keys = {"low", "high", gravity_key, rise_key};
  const Refusal missing{"missing",
                        "[box] with low = [...] and high = [...]: the corners of what is modelled"};
  if (!box) return mistakes.add(entry ? entry->place : document_.entries.front().place, box_table, missing);
  if (!check_words(*box, box_table, keys, mistakes)) return;
  const BodyContext context{scene.space, value, quantities_, mistakes};
  if (const Entry* gravity = box->find(gravity_key))
    scene.composition.gravity = context.vector("box.gravity", gravity->value, "m/s2").value_or(mpm::Triple{});
  if (const Entry* rise = box->find(rise_key)) {
    scene.composition.gravity_rise =
        context.number("box.gravity_rise", rise->value, {"s", mpm::Range::non_negative}).value_or(0);
    if (!box->find(gravity_key))
      mistakes.add("box.gravity_rise", rise->value,
                   {"there is no gravity that rises", "add gravity = [...]"});
  }
  for (const std::string_view key : {"low", "high"}) {
    const Entry* corner = box->find(key);
    if (!corner) {
      mistakes.add(entry->place, "box." + std::string(key), missing);
      continue;
    }
    const auto at = context.vector("box." + std::string(key), corner->value, "m");
    if (at) (key == "low" ? scene.composition.low : scene.composition.high) = *at;
  }
}

void BodiesReader::read_faces(mpm::Scene& scene, Mistakes& mistakes) {
  if (scene.space == mpm::Space::axisymmetric)
    scene.composition.faces[static_cast<std::size_t>(mpm::Side::left)] = mpm::Face::mirror;
  const Entry* entry = document_.find(faces_table);
  if (!entry) return;
  const Table* faces = entry->value.table();
  if (!faces) return mistakes.add(faces_table, entry->value, {"not a table", "write [faces]"});
  const std::size_t sides = scene.space == mpm::Space::three_d ? 6 : 4;
  const std::vector<std::string_view> names(mpm::side_words.begin(), mpm::side_words.begin() + sides);
  check_words(*faces, faces_table, names, mistakes);
  for (const Entry& one : faces->entries) {
    const auto side = std::ranges::find(names, one.key);
    if (side == names.end()) continue;
    if (const auto word = find_word("faces." + one.key, one.value, "face", mpm::face_words, mistakes))
      scene.composition.faces[static_cast<std::size_t>(side - names.begin())] = static_cast<mpm::Face>(*word);
  }
}

void BodiesReader::apply(mpm::Scene& scene, const ValueOf& value, Mistakes& mistakes) {
  scene.composition = {};
  read_box(scene, value, mistakes);
  read_faces(scene, mistakes);
  const BodyContext context{scene.space, value, quantities_, mistakes};
  const std::vector<std::string_view> known = known_materials();
  const std::vector<Entry>& of_file = entries_of(document_.find_table(materials_table));
  // the study's own material is number 0, where a body is of it
  std::vector<std::string> names;
  std::vector<mpm::Material> materials;
  if (uses_study_material()) names.emplace_back(), materials.push_back(scene.material);
  for (const Value& one : bodies()) {
    std::optional<mpm::ComposedBody> body = read_body(one, context);
    if (!body) continue;
    if (const Entry* material = one.table()->find("material")) {
      const auto word = find_word("body.material", material->value, "material", known, mistakes);
      if (!word) continue;
      const auto found = std::ranges::find(names, known[*word]);
      body->material = static_cast<std::size_t>(found - names.begin());
      if (found == names.end()) {
        names.emplace_back(known[*word]);
        materials.push_back(read_material(scene, known[*word], value, mistakes).value_or(mpm::Material{}));
      }
    }
    if (!body->rigid) body->energy = read_energy(*one.table(), materials[body->material], context);
    scene.composition.bodies.push_back(std::move(*body));
  }
  for (const Entry& one : of_file)
    if (std::ranges::find(names, one.key) == names.end())
      mistakes.add(one.place, "materials." + one.key,
                   {"no body is of it", "remove it, or name it as the material of a [[body]]"});
  std::ranges::stable_sort(scene.composition.bodies, {}, &mpm::ComposedBody::material);
  std::vector<std::string> body_names;
  for (const mpm::ComposedBody& body : scene.composition.bodies) body_names.push_back(body.name);
  scene.composition.contacts = read_contacts(document_, body_names, quantities_, value, mistakes);
  if (materials.empty()) return;
  scene.material = materials.front();
  scene.other_materials.assign(materials.begin() + 1, materials.end());
}

}  // namespace mpmstudy
