#include "runner/study/own_parameters.hpp"

#include <algorithm>
#include <charconv>

#include "runner/study/gauges.hpp"
#include "runner/study/requirement.hpp"
#include "runner/study/schema.hpp"

namespace mpmstudy {
namespace {

/// The tables whose values may be expressions, with all that is in them.
bool may_have_expressions(std::string_view table) {
  constexpr std::string_view without[] = {"sweep", "search", "expect", "fit", "figure"};
  return std::ranges::find(without, table) == std::end(without);
}

/// Keys whose text is a name or a word, and no expression.
bool is_word(std::string_view key) {
  constexpr std::string_view words[] = {"name", "title", "material", "base", "axis",
                                        "unit", "of",    "body",     "wall", "kind"};
  return std::ranges::find(words, key) != std::end(words) || mpm::find_choice(key);
}

template <class Parts>
void add_names_of_parts(const Value& value, const Parts& parts_of, std::set<std::string>& names) {
  if (const std::string* text = value.string())
    for (const std::string_view part : parts_of(*text))
      for (std::string& name : names_in(part)) names.insert(std::move(name));
}

void add_names(const Value& value, std::set<std::string>& names) {
  if (const std::string* text = value.string())
    for (std::string& name : names_in(*text)) names.insert(std::move(name));
  if (const List* list = value.list())
    for (const Value& one : *list) add_names(one, names);
  for (const Entry& one : entries_of(value.table())) {
    if (is_word(one.key)) continue;
    if (one.key == "reduce")
      for (const Entry& reduction : entries_of(one.value.table()))
        add_names_of_parts(reduction.value, numbers_of_reduction, names);
    else if (one.key == "when")
      add_names_of_parts(one.value, numbers_of_condition, names);
    else
      add_names(one.value, names);
  }
}

/// What follows the number of "32.4 mm".
std::string unit_of(std::string_view text) {
  double number = 0;
  const char* const end = text.data() + text.size();
  const auto result = std::from_chars(text.data(), end, number);
  const std::string_view unit(result.ptr, static_cast<std::size_t>(end - result.ptr));
  const auto first = unit.find_first_not_of(' ');
  return first == unit.npos ? "1" : std::string(unit.substr(first));
}

/// A unit of that dimension as the table of parameters writes it; else in base units.
std::string si_unit(const Dimension& dimension, const Units& units) {
  for (const mpm::Quantity& row : mpm::quantities())
    if (units.dimension(row.unit) == dimension) return std::string(row.unit);
  return dimension.text();
}

}  // namespace

OwnParameters::OwnParameters(const Table& document, std::optional<mpm::SceneKind> kind, const Units& units)
    : document_(document), units_(units) {
  std::set<std::string> used;
  for (const Entry& table : document.entries)
    if (!table.value.string() && may_have_expressions(table.key)) add_names(table.value, used);
  for (std::string& name : names_in_requirements(document.find_table("sweep"))) used.insert(std::move(name));
  std::vector<std::string_view> unknown;  // names in expressions that the file gives nowhere
  for (const std::string& name : used) {
    const bool given = std::ranges::any_of(document.entries, [&](const Entry& table) {
      return table.value.table() && table.value.table()->find(name);
    });
    if (!given) unknown.push_back(name);
  }
  for (const Entry& one : entries_of(document.find_table("parameters"))) {
    const mpm::Quantity* row = mpm::find_quantity(one.key);
    const bool is_row = (row && (!kind || row->belongs_to(*kind))) || mpm::find_choice(one.key);
    // also one that an expression may mean with a slip: it is said there
    const bool is_meant = used.contains(one.key) || !nearest(one.key, unknown).empty();
    if (!is_row && is_meant) own_.insert(one.key), names_.push_back(one.key);
  }
  for (const Entry& table : document.entries)
    for (const Entry& one : entries_of(table.value.table()))
      if (mpm::find_quantity(one.key) && !has(one.key) && may_have_expressions(table.key))
        names_.push_back(one.key);
}

const Entry* OwnParameters::find(std::string_view name) const {
  const Table* parameters = document_.find_table("parameters");
  return parameters ? parameters->find(name) : nullptr;
}

bool OwnParameters::is_expression(const Value& value, const Expected& expected) const {
  const std::string* text = value.string();
  if (!text || std::holds_alternative<double>(read_quantity(value, expected, units_))) return false;
  return std::ranges::any_of(names_in(*text), [&](const std::string& name) {
    return std::ranges::find(names_, name) != names_.end();
  });
}

KnownParameters OwnParameters::known(Mistakes& mistakes) {
  return {[this, &mistakes](std::string_view name) { return dimension(name, mistakes); }, names_};
}

std::optional<Dimension> OwnParameters::dimension(std::string_view name, Mistakes& mistakes) {
  if (!has(name)) {
    if (std::ranges::find(names_, name) == names_.end()) return std::nullopt;
    return units_.dimension(mpm::find_quantity(name)->unit);
  }
  const auto unit = this->unit(*find(name), mistakes);
  return unit ? units_.dimension(*unit) : Dimension{};  // said already
}

std::optional<std::string> OwnParameters::unit(const Entry& entry, Mistakes& mistakes) {
  const Value* value = &entry.value;
  if (const List* list = value->list(); list && !list->empty()) value = &list->front();
  std::string written = "1";
  if (const Table* table = value->table()) {
    const Entry* unit = table->find("unit");
    if (unit && unit->value.string()) written = *unit->value.string();
  } else if (const std::string* text = value->string()) {
    if (!names_in(*text).empty()) {
      if (std::ranges::find(asked_, entry.key) != asked_.end()) {
        std::string cycle;
        for (const std::string& name : asked_) cycle += name + " -> ";
        mistakes.add(entry.place, entry.key, entry.value.written(),
                     {"is made of itself: " + cycle + entry.key, "allowed: expressions without a cycle"});
        return std::nullopt;
      }
      asked_.push_back(entry.key);
      const auto known = this->known(mistakes);
      auto read = Expression::read(*text, units_, known.dimension, known.names);
      asked_.pop_back();
      const auto* expression = std::get_if<Expression>(&read);
      // what is wrong with it is said where it is read as a value
      return expression ? std::optional(si_unit(expression->dimension(), units_)) : std::string("1");
    }
    written = unit_of(*text);
  }
  const auto dimension = units_.dimension(written);
  if (!dimension) {
    mistakes.add(entry.key, entry.value,
                 {"'" + written + "' is not a unit", "allowed: a number with a unit, such as \"10 um\""});
    return std::nullopt;
  }
  return si_unit(*dimension, units_);
}

const mpm::Quantity* OwnParameters::row(const Entry& entry, Mistakes& mistakes) {
  const auto unit = this->unit(entry, mistakes);
  if (!unit) return nullptr;
  Row& row = rows_.emplace_back(Row{entry.key, *unit, entry.key, {}});
  row.row.name = row.name, row.row.unit = row.unit, row.row.column = row.column;
  row.row.symbol = row.row.meaning = row.row.alternative = "";
  row.row.section = mpm::Section::parameters;
  row.row.range = mpm::Range::any;
  row.row.required = false;
  row.row.get = [](const mpm::Scene&) { return 0.0; };
  row.row.set = [](mpm::Scene&, double) {};
  return &row.row;
}

}  // namespace mpmstudy
