#include "runner/study/axis.hpp"

#include <algorithm>
#include <array>
#include <cmath>

#include "runner/study/decimal.hpp"
#include "runner/study/schema.hpp"

namespace mpmstudy {
namespace {

constexpr std::array<std::string_view, 6> sweep_keys = {"values", "unit", "from", "to", "count", "spacing"};
constexpr std::array<std::string_view, 2> spacings = {"linear", "log"};

/// Reads the parts of { ... } for one quantity; remembers whether something was wrong.
class SweepTable {
 public:
  SweepTable(const mpm::Quantity& row, const Table& table, const Value& whole, const Units& units,
             Mistakes& mistakes)
      : row_(row), table_(table), whole_(whole), units_(units), mistakes_(mistakes) {}

  bool read(Axis& axis) {
    for (const Entry& entry : table_.entries)
      if (std::find(sweep_keys.begin(), sweep_keys.end(), entry.key) == sweep_keys.end())
        refuse(key(entry.key), entry.value,
               {"unknown key of a sweep", "allowed: values and unit, or from, to, count, unit, spacing"});
    const Entry* values = table_.find("values");
    const Entry* from = table_.find("from");
    if (values && from) {
      refuse(whole_, {"both values and from ... to", "allowed: one of them"});
    } else if (!values && !from) {
      refuse(whole_, {"no sweep", "allowed: values = [...], or from = ..., to = ..., count = ..."});
    } else if (const auto conversion = read_unit()) {
      values ? read_values(values->value, *conversion, axis) : read_range(*conversion, axis);
    }
    return good_;
  }

 private:
  std::string key(std::string_view part) const { return std::string(row_.name) + "." + std::string(part); }
  Expected expected() const { return {row_.unit, row_.range}; }
  void refuse(std::string_view key, const Value& value, const Refusal& refusal) {
    mistakes_.add(key, value, refusal);
    good_ = false;
  }
  void refuse(const Value& value, const Refusal& refusal) { this->refuse(row_.name, value, refusal); }

  std::optional<Conversion> read_unit() {
    const Entry* unit = table_.find("unit");
    if (!unit) {
      if (row_.unit == "1") return Conversion{0, 1, 0};
      refuse(whole_, {"no unit", "add unit = \"...\", one that converts to " + std::string(row_.unit)});
      return std::nullopt;
    }
    const std::string* text = unit->value.string();
    if (!text) {
      refuse(key("unit"), unit->value, {"not a unit", "allowed: a string such as \"um\""});
      return std::nullopt;
    }
    const auto conversion = units_.conversion(*text, row_.unit);
    if (const auto* wrong = std::get_if<std::string>(&conversion)) {
      refuse(key("unit"), unit->value,
             {*wrong, "allowed: a unit that converts to " + std::string(row_.unit)});
      return std::nullopt;
    }
    return std::get<Conversion>(conversion);
  }

  void read_values(const Value& values, const Conversion& conversion, Axis& axis) {
    for (const std::string_view other : {"to", "count", "spacing"})
      if (const Entry* entry = table_.find(other))
        refuse(key(other), entry->value, {"does not go with values", "allowed beside values: unit"});
    const List* list = values.list();
    if (!list || list->empty()) {
      refuse(key("values"), values,
             {list ? "no values" : "not a list", "allowed: one number or more, such as [1, 2]"});
      return;
    }
    for (const Value& value : *list) {
      const Number number = read_number(value, conversion, expected());
      if (const auto* refusal = std::get_if<Refusal>(&number))
        refuse(key("values"), value, *refusal);
      else
        axis.points.push_back({std::get<double>(number), value.place});
    }
  }

  void read_range(const Conversion& conversion, Axis& axis) {
    SweepRange range;
    range.conversion = conversion;
    read_spacing(range);
    const auto from = read_end("from", range.from, range.from_text, conversion);
    const auto to = read_end("to", range.to, range.to_text, conversion);
    read_count(range);
    if (from && to && *from == *to) refuse(whole_, {"from and to are equal", "write a single value instead"});
    if (good_ && range.logarithmic && !(range.from > 0 && range.to > 0))
      refuse(whole_, {"a log spacing through zero", "allowed: from and to above zero"});
    axis.range = std::move(range);
  }

  std::optional<double> read_end(std::string_view name, double& number, std::string& text,
                                 const Conversion& conversion) {
    const Entry* entry = table_.find(name);
    if (!entry) {
      refuse(whole_, {"'" + std::string(name) + "' is missing", "a range has from, to and count"});
      return std::nullopt;
    }
    const Number si = read_number(entry->value, conversion, expected());
    if (const auto* refusal = std::get_if<Refusal>(&si)) {
      refuse(key(name), entry->value, *refusal);
      return std::nullopt;
    }
    text = entry->value.number_text();
    number = *scaled_decimal(text, 0);
    return std::get<double>(si);
  }

  void read_count(SweepRange& range) {
    const Entry* entry = table_.find("count");
    if (!entry) return;
    const auto* count = std::get_if<std::int64_t>(&entry->value.data);
    if (!count || *count < 2)
      refuse(key("count"), entry->value, {"not a number of points", "allowed: a whole number, 2 or more"});
    else
      range.count = static_cast<std::uint64_t>(*count);
  }

  void read_spacing(SweepRange& range) {
    const Entry* entry = table_.find("spacing");
    if (!entry) return;
    const auto word = find_word(key("spacing"), entry->value, "spacing", spacings, mistakes_);
    good_ = good_ && word;
    range.logarithmic = word == 1u;
  }

  const mpm::Quantity& row_;
  const Table& table_;
  const Value& whole_;
  const Units& units_;
  Mistakes& mistakes_;
  bool good_ = true;
};

Axis begin_axis(const Entry& entry) {
  Axis axis;
  axis.place = entry.place;
  axis.value_place = entry.value.place;
  axis.written = entry.value.written();
  axis.swept = entry.value.list() || entry.value.table();
  return axis;
}

}  // namespace

double SweepRange::at(double share) const {
  if (share <= 0) return *conversion(from_text);
  if (share >= 1) return *conversion(to_text);
  const double written = logarithmic ? std::exp(std::log(from) + (std::log(to) - std::log(from)) * share)
                                     : from + (to - from) * share;
  return *conversion(shortest_text(round_to_12_digits(written)));  // between two ends that are in range
}

Point Axis::point(std::uint64_t i) const {
  if (!range) return points[i];
  const double share = static_cast<double>(i) / static_cast<double>(size() - 1);
  return {range->at(share), value_place};
}

std::optional<Axis> read_axis(const mpm::Quantity& row, const Entry& entry, const Units& units,
                              Mistakes& mistakes) {
  Axis axis = begin_axis(entry);
  axis.quantity = &row;
  const Value& value = entry.value;
  if (const Table* table = value.table()) {
    if (!SweepTable(row, *table, value, units, mistakes).read(axis)) return std::nullopt;
    return axis;
  }
  const Expected expected{row.unit, row.range};
  bool good = true;
  const auto read_one = [&](const Value& one) {
    const Number number = read_quantity(one, expected, units);
    if (const auto* refusal = std::get_if<Refusal>(&number)) {
      mistakes.add(row.name, one, *refusal);
      good = false;
    } else {
      axis.points.push_back({std::get<double>(number), one.place});
    }
  };
  if (const List* list = value.list()) {
    if (list->empty()) {
      mistakes.add(row.name, value, {"no values", "allowed: one value or more"});
      return std::nullopt;
    }
    for (const Value& one : *list) read_one(one);
  } else {
    read_one(value);
  }
  return good ? std::optional(axis) : std::nullopt;
}

Axis expression_axis(const mpm::Quantity& row, const Entry& entry, Expression expression) {
  Axis axis = begin_axis(entry);
  axis.quantity = &row;
  axis.points = {{0, entry.value.place}};
  axis.expression = std::move(expression);
  return axis;
}

std::optional<Axis> read_axis(const mpm::Choice& row, const Entry& entry, Mistakes& mistakes) {
  Axis axis = begin_axis(entry);
  axis.choice = &row;
  const Value* values = &entry.value;
  if (const Table* table = values->table()) {
    const Entry* inner = table->find("values");
    if (!inner || table->entries.size() != 1) {
      mistakes.add(row.name, entry.value,
                   {"not a sweep of words", "allowed: a list of words out of " + listed(row.allowed)});
      return std::nullopt;
    }
    values = &inner->value;
  }
  const List one = {*values};
  const List& words = values->list() ? *values->list() : one;
  if (words.empty()) mistakes.add(row.name, *values, {"no values", "allowed: " + listed(row.allowed)});
  bool good = !words.empty();
  for (const Value& value : words) {
    const bool material = &row == &mpm::material_choice();
    const auto word = find_word(row.name, value, material ? "material" : "choice", row.allowed, mistakes);
    good = good && word;
    if (word) axis.points.push_back({static_cast<double>(*word), value.place});
  }
  return good ? std::optional(axis) : std::nullopt;
}

}  // namespace mpmstudy
