#include "runner/study/axis.hpp"

#include <algorithm>
#include <array>
#include <cmath>

#include "runner/study/decimal.hpp"
#include "runner/study/quasi_random.hpp"
#include "runner/study/schema.hpp"

namespace mpmstudy {
namespace {

constexpr std::array<std::string_view, 2> spacings = {"linear", "log"};

/// What a sweep of a quantity may begin with.
struct Form {
  std::string_view key;
  std::vector<std::string_view> beside;  ///< the keys that go with it
  std::string_view whole;                ///< for messages
  std::optional<Spread> distribution = {};
};
const std::vector<Form>& axis_forms() {
  static const std::vector<Form> all = {
      {"values", {"unit"}, "values = [...]"},
      {"from", {"to", "count", "spacing", "unit"}, "from = ..., to = ..., count = ..."},
      {"uniform", {"unit"}, "uniform = [from, to]", Spread::even},
      {"log_uniform", {"unit"}, "log_uniform = [from, to]", Spread::logarithmic},
      {"normal", {"unit"}, "normal = [mean, deviation]", Spread::normal}};
  return all;
}
std::string all_axis_forms() {
  std::string text;
  for (const Form& form : axis_forms())
    text += (text.empty() ? "" : &form == &axis_forms().back() ? " or " : ", ") + std::string(form.whole);
  return text + "; and unit";
}

/// Reads the parts of { ... } for one quantity; remembers whether something was wrong.
class SweepTable {
 public:
  SweepTable(const mpm::Quantity& row, const Table& table, const Value& whole, const Units& units,
             Mistakes& mistakes)
      : row_(row), table_(table), whole_(whole), units_(units), mistakes_(mistakes) {}

  bool read(Axis& axis) {
    const Form* chosen = nullptr;
    for (const Form& form : axis_forms()) {
      if (!table_.find(form.key)) continue;
      if (chosen) {
        refuse(whole_, {"both " + std::string(chosen->key) + " and " + std::string(form.key),
                        "allowed: one of them"});
        return false;
      }
      chosen = &form;
    }
    if (!chosen && table_.find("to")) chosen = &axis_forms()[1];  // what is missing is said there
    if (!chosen) {
      refuse(whole_, {"no sweep", "allowed: " + all_axis_forms()});
      for (const Entry& entry : table_.entries) refuse_key(nullptr, entry);
      return false;
    }
    for (const Entry& entry : table_.entries)
      if (entry.key != chosen->key && std::ranges::find(chosen->beside, entry.key) == chosen->beside.end())
        refuse_key(chosen, entry);
    if (const auto conversion = read_unit()) {
      if (chosen->distribution)
        read_distribution(*chosen, *conversion, axis);
      else if (chosen->key == "values")
        read_values(table_.find("values")->value, *conversion, axis);
      else
        read_range(*conversion, axis);
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

  /// A key that does not go with the form that the sweep has; null: it has none.
  void refuse_key(const Form* form, const Entry& entry) {
    std::vector<std::string_view> all;
    for (const Form& other : axis_forms()) {
      all.push_back(other.key);
      for (const std::string_view beside : other.beside)
        if (std::ranges::find(all, beside) == all.end()) all.push_back(beside);
    }
    const bool known = std::ranges::find(all, entry.key) != all.end();
    if (!form && known) return;
    refuse(key(entry.key), entry.value,
           {known ? "does not go with " + std::string(form->key) : "unknown key of a sweep",
            form ? "allowed beside " + std::string(form->key) + ": " + listed(form->beside)
                 : "allowed: " + listed(all)});
  }

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
    const auto end = [&](std::string_view name, double& number, std::string& text) -> std::optional<double> {
      if (const Entry* entry = table_.find(name))
        return read_end(name, entry->value, number, text, conversion);
      refuse(whole_, {"'" + std::string(name) + "' is missing", "a range has from, to and count"});
      return std::nullopt;
    };
    const auto from = end("from", range.from, range.from_text), to = end("to", range.to, range.to_text);
    read_count(range);
    check_ends(from, to, range);
    axis.range = std::move(range);
  }

  /// { uniform = [from, to] }, ...
  void read_distribution(const Form& form, const Conversion& conversion, Axis& axis) {
    const Value& value = table_.find(form.key)->value;
    const List* pair = value.list();
    if (!pair || pair->size() != 2) {
      refuse(key(form.key), value, {"not two numbers", "allowed: " + std::string(form.whole)});
      return;
    }
    SweepRange range;
    range.conversion = conversion;
    range.is_distribution = true;
    range.spread = *form.distribution;
    const auto from = read_end(form.key, (*pair)[0], range.from, range.from_text, conversion);
    if (range.spread != Spread::normal) {
      check_ends(from, read_end(form.key, (*pair)[1], range.to, range.to_text, conversion), range);
    } else if (const Number width = read_number((*pair)[1], Conversion{0, 1, 0}, {"1", mpm::Range::positive});
               const auto* refusal = std::get_if<Refusal>(&width)) {
      refuse(key(form.key), (*pair)[1], {refusal->wrong, "allowed: a standard deviation above zero"});
    } else {
      range.to_text = (*pair)[1].number_text();
      range.to = std::get<double>(width);
    }
    axis.range = std::move(range);
  }

  void check_ends(const std::optional<double>& from, const std::optional<double>& to,
                  const SweepRange& range) {
    if (from && to && *from == *to) refuse(whole_, {"from and to are equal", "write a single value instead"});
    if (good_ && range.spread == Spread::logarithmic && !(range.from > 0 && range.to > 0))
      refuse(whole_, {"a log spacing through zero", "allowed: from and to above zero"});
  }

  std::optional<double> read_end(std::string_view name, const Value& value, double& number, std::string& text,
                                 const Conversion& conversion) {
    const Number si = read_number(value, conversion, expected());
    if (const auto* refusal = std::get_if<Refusal>(&si)) {
      refuse(key(name), value, *refusal);
      return std::nullopt;
    }
    text = value.number_text();
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
    range.spread = word == 1u ? Spread::logarithmic : Spread::even;
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
  if (spread != Spread::normal && share <= 0) return *conversion(from_text);
  if (spread != Spread::normal && share >= 1) return *conversion(to_text);
  double written = 0;
  switch (spread) {
    case Spread::even:
      written = from + (to - from) * share;
      break;
    case Spread::logarithmic:
      written = std::exp(std::log(from) + (std::log(to) - std::log(from)) * share);
      break;
    case Spread::normal:
      written = from + to * normal_quantile(share);
      break;
  }
  return *conversion(shortest_text(round_to_12_digits(written)));
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
