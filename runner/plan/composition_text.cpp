#include "runner/plan/composition_text.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <nlohmann/json.hpp>
#include <stdexcept>

#include "libmpm/scene/effect.hpp"
#include "libmpm/scene/kinds/kind.hpp"
#include "libmpm/scene/parameters.hpp"

namespace mpmstudy {
namespace {

using nlohmann::json;

constexpr const char* infinite = "infinite";  // JSON has no such number

json number(double value) { return std::isinf(value) ? json(infinite) : json(value + 0.0); }
double number_of(const json& j) {
  return j.is_string() ? std::numeric_limits<double>::infinity() : j.get<double>();
}

template <class Word, class Words>
std::string word_of(Word word, const Words& words) {
  return std::string(words[static_cast<std::size_t>(word)]);
}
template <class Word, class Words>
Word from_word(const json& j, const Words& words) {
  for (std::size_t k = 0; k < words.size(); ++k)
    if (words[k] == j.get<std::string>()) return static_cast<Word>(k);
  throw std::invalid_argument("a composition with the word " + j.dump());
}

json shape_json(const mpm::Shape& shape) {
  json j{{"form", word_of(shape.form, mpm::shape_forms)}};
  for (const double x : shape.numbers) j["numbers"].push_back(number(x));
  for (const mpm::Shape& part : shape.parts) j["parts"].push_back(shape_json(part));
  if (shape.rotation != mpm::Shape::no_rotation) j["rotation"] = shape.rotation;
  if (shape.shift != mpm::Triple{}) j["shift"] = shape.shift;
  return j;
}
mpm::Shape shape_from(const json& j) {
  mpm::Shape shape;
  shape.form = from_word<mpm::Shape::Form>(j.at("form"), mpm::shape_forms);
  for (const json& x : j.value("numbers", json::array())) shape.numbers.push_back(number_of(x));
  for (const json& part : j.value("parts", json::array())) shape.parts.push_back(shape_from(part));
  shape.rotation = j.value("rotation", mpm::Shape::no_rotation);
  shape.shift = j.value("shift", mpm::Triple{});
  return shape;
}

/// What a body has not is left out: its text was the same before there was such a thing.
json body_json(const mpm::ComposedBody& b) {
  json j{{"name", b.name},         {"shape", shape_json(b.shape)},
         {"material", b.material}, {"velocity", b.velocity},
         {"spin", b.spin},         {"about", b.about}};
  if (const mpm::RadialVelocity& v = b.radial; v.speed != 0)
    j["radial"] = {{"speed", v.speed}, {"at", v.at}, {"exponent", v.exponent}, {"about", v.about}};
  if (b.energy != 0) j["energy"] = b.energy;
  if (b.rigid) j["rigid"] = true;
  return j;
}
mpm::ComposedBody body_from(const json& j) {
  mpm::ComposedBody b{j.at("name").get<std::string>(),     shape_from(j.at("shape")),
                      j.at("material").get<std::size_t>(), j.at("velocity").get<mpm::Triple>(),
                      j.at("spin").get<double>(),          j.at("about").get<mpm::Triple>()};
  if (const auto radial = j.find("radial"); radial != j.end())
    b.radial = {radial->at("speed").get<double>(), radial->at("at").get<double>(),
                radial->at("exponent").get<double>(), radial->at("about").get<mpm::Triple>()};
  b.energy = j.value("energy", 0.0);
  b.rigid = j.value("rigid", false);
  return b;
}

/// Rows of the parameter table that are of a material, of number `index` of the scene.
json material_json(mpm::Scene scene, std::size_t index, bool for_key) {
  scene.material = mpm::material_of(scene, index);
  json j;
  if (!for_key) j["name"] = scene.material.name;
  const auto has_effect = [&](std::string_view name) {
    const mpm::Condition* condition = mpm::condition_of(name);
    return !for_key || !condition || condition->holds(scene);
  };
  for (const mpm::Quantity& row : mpm::quantities())
    if (mpm::is_of_material(row) && !row.derived && has_effect(row.name) &&
        !(for_key && row.get(scene) == row.implied))
      j[std::string(row.name)] = number(row.get(scene));
  for (const mpm::Choice& row : mpm::choices())
    if (row.section == mpm::Section::material && has_effect(row.name) &&
        !(for_key && row.allowed[row.get(scene)] == row.implied))
      j[std::string(row.name)] = std::string(row.allowed[row.get(scene)]);
  return j;
}
mpm::Material material_from(mpm::Scene scene, const json& j) {
  scene.material = {};
  for (const mpm::Quantity& row : mpm::quantities())
    if (mpm::is_of_material(row) && j.contains(row.name))
      row.set(scene, number_of(j.at(std::string(row.name))));
  for (const mpm::Choice& row : mpm::choices())
    if (row.section == mpm::Section::material && j.contains(row.name))
      row.set(scene, from_word<std::size_t>(j.at(std::string(row.name)), row.allowed));
  scene.material.name = j.at("name").get<std::string>();
  return scene.material;
}

json contact_json(const mpm::ContactRule& rule) {
  json j{{"law", word_of(rule.law, mpm::contact_laws)}};
  if (!rule.first.empty()) j["between"] = {rule.first, rule.second};
  if (rule.law == mpm::ContactLaw::coulomb) j["friction"] = number(rule.friction);
  return j;
}
mpm::ContactRule contact_from(const json& j) {
  mpm::ContactRule rule;
  rule.law = from_word<mpm::ContactLaw>(j.at("law"), mpm::contact_laws);
  if (j.contains("between")) rule.first = j.at("between").at(0), rule.second = j.at("between").at(1);
  if (j.contains("friction")) rule.friction = number_of(j.at("friction"));
  return rule;
}

std::string text_of(const mpm::Scene& scene, bool for_key) {
  if (!mpm::kind_of(scene).is_composed) return {};
  const mpm::Composition& all = scene.composition;
  json j{{"low", all.low}, {"high", all.high}};
  for (const mpm::Face face : all.faces) j["faces"].push_back(word_of(face, mpm::face_words));
  if (all.has_gravity()) j["gravity"] = all.gravity;
  if (all.has_gravity() && all.gravity_rise != 0) j["gravity_rise"] = all.gravity_rise;
  for (const mpm::ComposedBody& b : all.bodies) j["bodies"].push_back(body_json(b));
  for (const mpm::ContactRule& rule : all.contacts) j["contacts"].push_back(contact_json(rule));
  for (std::size_t m = 0; m < mpm::material_count(scene); ++m)
    j["materials"].push_back(material_json(scene, m, for_key));
  return j.dump();
}

}  // namespace

std::string own_parts(const mpm::Scene& here, const mpm::Scene& there) {
  const json mine = json::parse(text_of(here, false)), others = json::parse(text_of(there, false));
  std::string names;
  const auto add = [&](const std::string& name) { names += (names.empty() ? "" : ", ") + name; };
  if (mine.at("low") != others.at("low") || mine.at("high") != others.at("high")) add("box");
  if (mine.at("faces") != others.at("faces")) add("faces");
  for (const char* part : {"gravity", "gravity_rise"})
    if (mine.value(part, json()) != others.value(part, json())) add(part);
  if (mine.value("contacts", json()) != others.value("contacts", json())) add("contact");
  const auto add_of = [&](const char* list, const std::string& before) {
    const json theirs = others.value(list, json::array());
    for (const json& one : mine.value(list, json::array()))
      if (std::ranges::find(theirs, one) == theirs.end()) add(before + one.at("name").get<std::string>());
  };
  add_of("bodies", ""), add_of("materials", "material ");
  return names.empty() ? "none" : names;
}

std::string composition_text(const mpm::Scene& scene) { return text_of(scene, false); }
std::string composition_key(const mpm::Scene& scene) { return text_of(scene, true); }

void set_composition(mpm::Scene& scene, const std::string& text) {
  if (text.empty()) return;
  try {
    const json j = json::parse(text);
    mpm::Composition& all = scene.composition = {};
    all.low = j.at("low").get<mpm::Triple>();
    all.high = j.at("high").get<mpm::Triple>();
    for (std::size_t side = 0; side < all.faces.size(); ++side)
      all.faces[side] = from_word<mpm::Face>(j.at("faces").at(side), mpm::face_words);
    all.gravity = j.value("gravity", mpm::Triple{});
    all.gravity_rise = j.value("gravity_rise", 0.0);
    for (const json& b : j.at("bodies")) all.bodies.push_back(body_from(b));
    for (const json& rule : j.value("contacts", json::array())) all.contacts.push_back(contact_from(rule));
    scene.other_materials.clear();
    const json& materials = j.at("materials");
    for (std::size_t m = 1; m < materials.size(); ++m)
      scene.other_materials.push_back(material_from(scene, materials[m]));
    scene.material = material_from(scene, materials.at(0));
  } catch (const json::exception& error) {
    throw std::invalid_argument(std::string("a composition that cannot be read: ") + error.what());
  }
}

}  // namespace mpmstudy
