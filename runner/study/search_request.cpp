// [search] of a study file.
#include <fmt/format.h>

#include <algorithm>

#include "libmpm/scene/kinds/kind.hpp"
#include "runner/study/quantity_text.hpp"
#include "runner/study/read_word.hpp"
#include "runner/study/readable.hpp"
#include "runner/study/requests.hpp"
#include "runner/study/searched.hpp"

namespace mpmstudy {
namespace {

/// Of a kind of scene; of all of them, if the file does not say which.
std::vector<std::string_view> outcome_names(std::optional<mpm::SceneKind> wanted) {
  std::vector<std::string_view> names;
  for (const mpm::Kind* kind : mpm::kinds())
    for (const std::string_view outcome : kind->outcomes)
      if ((!wanted || kind->kind == *wanted) && std::ranges::find(names, outcome) == names.end())
        names.push_back(outcome);
  return names;
}

/// A number of [search] in the unit of its critical quantity.
std::optional<double> read_bound(std::string_view key, const Value& value, const Expected& expected,
                                 const Units& units, Mistakes& mistakes) {
  const Number number = read_quantity(value, expected, units);
  if (const auto* refusal = std::get_if<Refusal>(&number)) {
    mistakes.add(key, value, *refusal);
    return std::nullopt;
  }
  return std::get<double>(number);
}

void read_between(const Entry& parent, const Table& table, const mpm::Quantity& row, const Units& units,
                  SearchRequest& search, Mistakes& mistakes) {
  const Refusal shape{"not a bracket", "allowed: two quantities, the smaller first"};
  const Entry* entry = table.find("between");
  if (!entry) {
    mistakes.add(parent.place, "between", {"missing", shape.allowed});
    return;
  }
  const List* list = entry->value.list();
  if (!list || list->size() != 2) {
    mistakes.add("between", entry->value, shape);
    return;
  }
  const mpm::Range range =  // both ends are finite
      row.range == mpm::Range::non_negative_or_infinite ? mpm::Range::non_negative : row.range;
  const auto lower = read_bound("between", (*list)[0], {row.unit, range}, units, mistakes);
  const auto upper = read_bound("between", (*list)[1], {row.unit, range}, units, mistakes);
  if (!lower || !upper) return;
  if (!(*lower < *upper)) mistakes.add("between", entry->value, shape);
  search.lower = *lower;
  search.upper = *upper;
  search.place = entry->value.place.text();
}

/// A tolerance far below the bracket is most likely a wrong unit.
void check_steps(const Table& table, const mpm::Quantity& row, const SearchRequest& search,
                 Mistakes& mistakes) {
  if (!(search.tolerance > 0) || !(search.upper > search.lower)) return;
  const double steps = search_steps(search.lower, search.upper, search.tolerance);
  if (steps <= most_search_steps) return;
  mistakes.add("tolerance", table.find("tolerance")->value,
               {fmt::format("makes {:.6g} steps between {} and {}", steps, readable(search.lower, row.unit),
                            readable(search.upper, row.unit)),
                fmt::format("allowed: at most {:.0f} steps, a tolerance of {} or more", most_search_steps,
                            readable((search.upper - search.lower) / most_search_steps, row.unit))});
}

double read_tolerance(const Value& value, const mpm::Quantity& row, const SearchRequest& search,
                      const Units& units, Mistakes& mistakes) {
  const Expected expected{row.unit, mpm::Range::positive, true};
  const double width = read_bound("tolerance", value, expected, units, mistakes).value_or(0);
  if (search.upper > search.lower && width > search.upper - search.lower)
    mistakes.add("tolerance", value,
                 {"is wider than `between`, so that nothing is left to search",
                  "allowed: a width below that of `between`"});
  return width;
}

}  // namespace

std::optional<SearchRequest> read_search(const Table& document, std::optional<mpm::SceneKind> kind,
                                         const Units& units, Mistakes& mistakes) {
  const Entry* entry = document.find("search");
  if (!entry || !entry->value.table()) return std::nullopt;
  const Table& table = *entry->value.table();
  SearchRequest search;
  std::vector<std::string_view> names;
  for (const mpm::Quantity& row : mpm::quantities())
    if (!kind || row.belongs_to(*kind)) names.push_back(row.name);
  search.critical = read_word(*entry, table, "critical", "quantity", names, mistakes);
  if (kind && outcome_names(kind).empty())
    mistakes.add(entry->place, "search",
                 {std::string(mpm::to_string(*kind)) + " has no outcome to look for", "remove [search]"});
  else
    search.outcome = read_word(*entry, table, "outcome", "outcome", outcome_names(kind), mistakes);
  const mpm::Quantity* row = mpm::find_quantity(search.critical);
  if (!row) return std::nullopt;
  read_between(*entry, table, *row, units, search, mistakes);
  if (const Entry* tolerance = table.find("tolerance"))
    search.tolerance = read_tolerance(tolerance->value, *row, search, units, mistakes);
  else
    mistakes.add(entry->place, "tolerance", {"missing", "give the width at which the search ends"});
  check_steps(table, *row, search, mistakes);
  return search;
}

}  // namespace mpmstudy
