#include "runner/study/requests.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>

#include "analysis/fit.hpp"
#include "libmpm/core/enumerators.hpp"
#include "libmpm/io/fields.hpp"
#include "libmpm/measure/results.hpp"
#include "libmpm/scene/kinds/kind.hpp"
#include "runner/study/characters.hpp"
#include "runner/study/each_table.hpp"
#include "runner/study/field_view.hpp"
#include "runner/study/quantity_text.hpp"
#include "runner/study/read_word.hpp"
#include "runner/study/schema.hpp"
#include "runner/study/searched.hpp"

namespace mpmstudy {
namespace {

using Outcome = Expectation::Outcome;
constexpr auto expected_outcomes = mpm::words<Outcome>(
    {{Outcome::holds, "holds"}, {Outcome::breaks, "breaks"}, {Outcome::refused, "refused"}});

bool has_area_history(const RequestContext& context) {
  return !context.kind || mpm::kind_of(*context.kind).has_area_history;
}

/// Kinds of figure that a study can have; all, where nothing is known of it.
std::vector<std::string_view> figure_words(const RequestContext& context) {
  std::vector<std::string_view> words;
  for (const FigureKindRow& row : figure_kinds)
    if (row.y != FigureY::history || has_area_history(context) || !context.gauges.empty())
      words.push_back(row.word);
  return words;
}

std::vector<std::string_view> field_names() {
  std::vector<std::string_view> names;
  for (const mpm::Field& field : mpm::fields()) names.push_back(field.name);
  return names;
}

bool in_a_space_of(const mpm::ResultRow& row, const RequestContext& context) {
  return std::ranges::any_of(context.spaces, row.spaces);
}

/// Results that jobs of this study can have.
bool can_have(const mpm::ResultRow& row, const RequestContext& context) {
  return (!context.kind || row.belongs_to(*context.kind)) &&
         (row.needs != mpm::Needs::ejection || context.decides_ejection) && in_a_space_of(row, context);
}

/// Why a result of the table is none of this study's, and what is.
Refusal not_of_this_study(const mpm::ResultRow& row, const RequestContext& context,
                          const std::vector<std::string_view>& own) {
  if (context.kind && !row.belongs_to(*context.kind))
    return {std::string(mpm::to_string(*context.kind)) + " has no such result", "allowed: " + listed(own)};
  if (!in_a_space_of(row, context)) {
    std::string needed, written;
    const mpm::Choice& spaces = *mpm::find_choice("space");
    for (std::size_t i = 0; i < spaces.allowed.size(); ++i) {
      if (!row.spaces(static_cast<mpm::Space>(i))) continue;
      const std::string word(spaces.allowed[i]);
      needed += (needed.empty() ? "" : " or ") + word;
      written += (written.empty() ? "\"" : " or \"") + word + "\"";
    }
    return {"no job of this study is " + needed, "write space = " + written + ", or take another result"};
  }
  return {"no job of this study decides ejection",
          "write decides = \"ejection\" in [measure], or take another result"};
}

/// "rear.max": a number that a gauge of this study comes to.
void read_gauge_result(std::string_view key, const std::string& name, const Value& value,
                       const RequestContext& context, Mistakes& mistakes) {
  if (std::ranges::find(context.gauge_results, name) != context.gauge_results.end()) return;
  if (context.gauges.empty())
    return mistakes.add(key, value, {"there is no [[gauge]]", "add one, or take a result of a run"});
  std::vector<std::string_view> own(context.gauge_results.begin(), context.gauge_results.end());
  if (!mpm::is_of_gauge(name)) {
    std::erase_if(own, [&](std::string_view one) { return !one.starts_with(name + "."); });
    return mistakes.add(key, value, {"is a history, and not one number", "allowed: " + listed(own)});
  }
  mistakes.add(key, value, unknown_word(name, "number of a gauge", own));
}

/// y of a fit or a figure, or another of its keys: a result that jobs of this study can have. `wanted`: which
/// of them will do.
template <class Wanted>
std::string read_result(std::string_view key, const Entry& parent, const Table& table,
                        const RequestContext& context, Mistakes& mistakes, Wanted wanted) {
  const auto name = required_string(table, parent.place, key, "result", mistakes);
  if (!name) return {};
  std::vector<std::string_view> own;
  for (const mpm::ResultRow& row : mpm::results())
    if (wanted(row) && can_have(row, context)) own.push_back(row.name);
  const Value& value = table.find(key)->value;
  if (mpm::is_of_gauge(*name) || std::ranges::find(context.gauges, *name) != context.gauges.end()) {
    read_gauge_result(key, *name, value, context, mistakes);
    return *name;
  }
  const mpm::ResultRow* row = mpm::find_result(*name);
  if (!row || !wanted(*row))
    mistakes.add(key, value, unknown_word(*name, "result", own));
  else if (!can_have(*row, context))
    mistakes.add(key, value, not_of_this_study(*row, context, own));
  return *name;
}

bool any_result(const mpm::ResultRow&) { return true; }
bool with_interval(const mpm::ResultRow& row) { return row.has_interval; }

/// y of a fit or an xy figure: a result, or what the study's [search] finds.
std::string read_y(std::string_view key, const Entry& parent, const Table& table,
                   const RequestContext& context, Mistakes& mistakes) {
  const Entry* entry = table.find(key);
  const std::string* name = entry ? entry->value.string() : nullptr;
  if (name && critical_result(*name)) {
    if (context.critical.empty())
      mistakes.add(key, entry->value, {"there is no [search]", "add one, or take a result of a run"});
    else if (!critical_result(*name, context.critical))
      mistakes.add(
          key, entry->value,
          {"is not what [search] looks for", "allowed: " + listed(critical_names(context.critical))});
    return *name;
  }
  return read_result(key, parent, table, context, mistakes, any_result);
}

/// x of a fit or a figure: a quantity that the study varies.
std::string read_x(std::string_view key, const Entry& parent, const Table& table,
                   const RequestContext& context, Mistakes& mistakes) {
  const auto name = required_string(table, parent.place, key, "a swept quantity", mistakes);
  if (!name) return {};
  std::vector<std::string_view> names;
  for (const mpm::Quantity& row : mpm::quantities())
    if (!context.kind || row.belongs_to(*context.kind)) names.push_back(row.name);
  for (const OwnParameter& own : context.own) names.push_back(own.name);
  const Value& value = table.find(key)->value;
  if (std::find(names.begin(), names.end(), *name) == names.end())
    mistakes.add(key, value, unknown_word(*name, "quantity", names));
  else if (std::find(context.fixed.begin(), context.fixed.end(), *name) != context.fixed.end())
    mistakes.add(key, value, {"has one value in this study", "sweep it, or take a quantity that is swept"});
  else if (!context.says(*name))
    mistakes.add(key, value,
                 {"is not in this study", "sweep it in [" +
                                              std::string(table_name(mpm::find_quantity(*name)->section)) +
                                              "], or take a quantity that is swept"});
  return *name;
}

/// x of a figure against which a result is drawn: a quantity that the study varies, or another result.
std::string read_abscissa(const Entry& parent, const Table& table, const RequestContext& context,
                          Mistakes& mistakes) {
  const Entry* entry = table.find("x");
  const std::string* name = entry ? entry->value.string() : nullptr;
  std::vector<std::string_view> results, quantities;
  for (const mpm::ResultRow& row : mpm::results()) results.push_back(row.name);
  for (const mpm::Quantity& row : mpm::quantities()) quantities.push_back(row.name);
  const bool is_result =
      name && (critical_result(*name) || mpm::is_of_gauge(*name) ||
               (nearest(*name, quantities).empty() && !nearest(*name, results).empty()));  // also misspelt
  return is_result ? read_y("x", parent, table, context, mistakes)
                   : read_x("x", parent, table, context, mistakes);
}

/// log = "x", or ["x", "y"].
void read_log(const Table& table, const FigureKindRow& row, FigureRequest& figure, Mistakes& mistakes) {
  const Entry* entry = table.find("log");
  if (!entry) return;
  if (!row.has_x) {
    mistakes.add("log", entry->value,
                 {fmt::format("a figure of kind {} has no such axes", row.word), "remove it"});
    return;
  }
  constexpr std::array<std::string_view, 2> axes = {"x", "y"};
  const List one = {entry->value};
  for (const Value& value : entry->value.list() ? *entry->value.list() : one)
    if (const auto axis = find_word("log", value, "axis", axes, mistakes))
      (*axis == 0 ? figure.log_x : figure.log_y) = true;
}

/// Whether this study can have a figure of that kind.
void check_figure_kind(const FigureKindRow& row, const Value& value, const RequestContext& context,
                       Mistakes& mistakes) {
  if (row.y == FigureY::history && !has_area_history(context) && context.gauges.empty())
    mistakes.add(
        "kind", value,
        {std::string(mpm::to_string(*context.kind)) + " has no history of a cavity's area",
         "add a [[gauge]] and write y = its name, or take another kind: " + listed(figure_words(context))});
  if (row.of_snapshots && !context.has_snapshots)
    mistakes.add("kind", value,
                 {"there are no snapshots to draw", "write snapshots = [\"1 ns\"] in [measure]"});
}

/// y of a figure of a history: the name of a gauge, or nothing where jobs have the history of an area.
std::string read_history(const Entry& parent, const Table& table, const RequestContext& context,
                         Mistakes& mistakes) {
  if (!table.find("y") && has_area_history(context)) return {};
  const std::vector<std::string_view> gauges(context.gauges.begin(), context.gauges.end());
  if (gauges.empty()) {
    if (const Entry* y = table.find("y"))
      mistakes.add(
          "y", y->value,
          {"there is no [[gauge]]",
           "add one" + std::string(has_area_history(context) ? ", or remove y: the cavity's area" : "")});
    return {};
  }
  return read_word(parent, table, "y", "gauge", gauges, mistakes);
}

/// What a figure's x and y are, for the keys that its kind has.
void read_axes(const Entry& entry, const Table& table, const FigureKindRow& row,
               const RequestContext& context, FigureRequest& figure, Mistakes& mistakes) {
  const auto refuse = [&](std::string_view key) {
    if (const Entry* extra = table.find(key))
      mistakes.add(key, extra->value,
                   {fmt::format("a figure of kind {} has no {}", row.word, key), "remove it"});
  };
  if (!row.has_x)
    refuse("x");
  else if (row.y == FigureY::result)
    figure.x = read_abscissa(entry, table, context, mistakes);
  else
    figure.x = read_x("x", entry, table, context, mistakes);
  if (row.has_colour)
    figure.colour = read_y("colour", entry, table, context, mistakes);
  else
    refuse("colour");
  read_log(table, row, figure, mistakes);
  switch (row.y) {
    case FigureY::quantity:
      figure.y = read_x("y", entry, table, context, mistakes);
      if (!figure.y.empty() && figure.y == figure.x)
        mistakes.add("y", table.find("y")->value,
                     {"is also its x", "allowed: another quantity that is swept"});
      break;
    case FigureY::history:
      figure.y = read_history(entry, table, context, mistakes);
      break;
    case FigureY::result:
      figure.y = read_y("y", entry, table, context, mistakes);
      break;
    case FigureY::result_with_interval:
      figure.y = read_result("y", entry, table, context, mistakes, with_interval);
      break;
    case FigureY::field:
      figure.y = read_word(entry, table, "y", "field", field_names(), mistakes);
      if (const mpm::Field* field = mpm::find_field(figure.y);
          field && field->only_of_three_axes() &&
          std::ranges::any_of(context.spaces, [](mpm::Space space) { return space != mpm::Space::three_d; }))
        mistakes.add("y", table.find("y")->value,
                     {"only jobs in three dimensions have this field",
                      "write space = \"three-d\", or take another field"});
      break;
  }
}

void check_cells(const FigureKindRow& row, const Value& value, const RequestContext& context,
                 Mistakes& mistakes) {
  if (row.least_cells <= 1) return;
  if (!context.critical.empty())
    mistakes.add("kind", value, {"is of single runs, and the study has a [search]", "remove the figure"});
  else if (context.cells < row.least_cells)
    mistakes.add("kind", value,
                 {fmt::format("needs a ladder of {} cells or more", row.least_cells),
                  fmt::format("write ladder = {} in [numerics]", row.least_cells)});
}

}  // namespace

bool has_interval(std::string_view result) {
  const mpm::ResultRow* row = mpm::find_result(result);
  return mpm::is_of_gauge(result) || (row && row->has_interval);
}

std::vector<std::string_view> results_with_interval(std::optional<mpm::SceneKind> kind) {
  std::vector<std::string_view> names;
  for (const mpm::ResultRow& row : mpm::results())
    if (row.has_interval && (!kind || row.belongs_to(*kind))) names.push_back(row.name);
  return names;
}

bool RequestContext::says(std::string_view quantity) const {
  const mpm::Quantity* row = mpm::find_quantity(quantity);
  return std::ranges::any_of(
      said, [&](const std::string& name) { return name == quantity || (row && name == row->alternative); });
}

bool is_file_name(std::string_view name) {
  const auto plain = [](char c) {
    return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || (c >= '0' && c <= '9') || c == '-' ||
           c == '_' || c == '.';
  };
  return !name.empty() && name.size() <= 100 && name[0] != '.' &&
         std::all_of(name.begin(), name.end(), plain);
}

std::optional<std::string> required_string(const Table& table, const Place& place, std::string_view key,
                                           std::string_view what, Mistakes& mistakes) {
  const Entry* entry = table.find(key);
  if (!entry) {
    mistakes.add(place, key, {"missing", "give " + std::string(key) + " = \"...\": " + std::string(what)});
    return std::nullopt;
  }
  const std::string* text = entry->value.string();
  if (!text || text->empty()) {
    mistakes.add(key, entry->value, {text ? "empty" : "not a string", "allowed: " + std::string(what)});
    return std::nullopt;
  }
  return *text;
}

std::optional<std::string> required_title(const Table& table, const Place& place, Mistakes& mistakes) {
  constexpr const char* what = "a line of text";
  const auto title = required_string(table, place, "title", what, mistakes);
  if (!title) return std::nullopt;
  if (std::string wrong = control_character(*title); !wrong.empty()) {
    mistakes.add("title", table.find("title")->value, {wrong, std::string("allowed: ") + what});
    return std::nullopt;
  }
  return title;
}

std::vector<FitRequest> read_fits(const Table& document, const RequestContext& context, Mistakes& mistakes) {
  std::vector<FitRequest> fits;
  for_each_table(document, "fit", mistakes, [&](const Entry& entry, const Table& table) {
    FitRequest fit;
    fit.x = read_x("x", entry, table, context, mistakes);
    fit.y = read_y("y", entry, table, context, mistakes);
    fit.model = read_word(entry, table, "model", "model", analysis::fit_model_names(), mistakes);
    fits.push_back(fit);
  });
  return fits;
}

std::vector<FigureRequest> read_figures(const Table& document, const RequestContext& context,
                                        const Units& units, Mistakes& mistakes) {
  std::vector<FigureRequest> figures;
  for_each_table(document, "figure", mistakes, [&](const Entry& entry, const Table& table) {
    FigureRequest figure;
    figure.name =
        required_string(table, entry.place, "name", "the stem of a file name", mistakes).value_or("");
    if (!figure.name.empty() && !is_file_name(figure.name))
      mistakes.add("name", table.find("name")->value, {"cannot be a file's name", allowed_file_name});
    for (const FigureRequest& other : figures)
      if (!figure.name.empty() && other.name == figure.name)
        mistakes.add("name", table.find("name")->value, {"two figures of one name", "give each its own"});
    if (table.find("title")) figure.title = required_title(table, entry.place, mistakes).value_or("");
    const std::string word = read_word(entry, table, "kind", "kind of figure", figure_words({}), mistakes);
    if (const FigureKindRow* row = find_figure_kind(word)) {
      const Value& kind = table.find("kind")->value;
      figure.kind = row->kind;
      check_figure_kind(*row, kind, context, mistakes);
      read_axes(entry, table, *row, context, figure, mistakes);
      check_cells(*row, kind, context, mistakes);
      figure.view = read_field_view(table, *row, context, units, mistakes);
    }
    figures.push_back(figure);
  });
  return figures;
}

std::string read_result_name(std::string_view key, const Entry& parent, const Table& table,
                             const RequestContext& context, Mistakes& mistakes) {
  return read_result(key, parent, table, context, mistakes, any_result);
}

std::optional<Expectation> read_expectation(const Table& document, const Units& units, Mistakes& mistakes) {
  const Entry* entry = document.find("expect");
  if (!entry || !entry->value.table()) return std::nullopt;
  const Table& table = *entry->value.table();
  Expectation expected;
  const std::string outcome =
      read_word(*entry, table, "outcome", "expected outcome", expected_outcomes, mistakes);
  if (const auto at = std::ranges::find(expected_outcomes, outcome); at != expected_outcomes.end())
    expected.outcome = static_cast<Outcome>(at - expected_outcomes.begin());
  expected.why = required_string(table, entry->place, "why", "why the case is hard", mistakes).value_or("");
  if (expected.outcome != Outcome::holds)
    expected.reason =
        required_string(table, entry->place, "reason", "words of the message", mistakes).value_or("");
  else if (const Entry* extra = table.find("reason"))
    mistakes.add("reason", extra->value, {"what holds has no reason to fail", "remove it"});
  if (const Entry* limit = table.find("energy_error")) {
    const Number number = read_quantity(limit->value, {"1", mpm::Range::positive}, units);
    if (const auto* refusal = std::get_if<Refusal>(&number))
      mistakes.add("energy_error", limit->value, *refusal);
    else
      expected.energy_error = std::get<double>(number);
  }
  return expected;
}

}  // namespace mpmstudy
