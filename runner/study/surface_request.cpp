// [surface] of a study file.
#include "runner/study/surface_request.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <bit>
#include <cmath>

#include "libmpm/measure/results.hpp"
#include "runner/study/quantity_text.hpp"
#include "runner/study/requests.hpp"
#include "runner/study/schema.hpp"

namespace mpmstudy {
namespace {

/// The likelihood of a surface takes the cube of their number, and is asked many times in each round.
constexpr std::int64_t most_budget = 1000;
constexpr std::int64_t default_batch = 8;

/// "2 %": a share of the range of the result; else a number with its unit.
void read_tolerance(const Entry& parent, const Table& table, SurfaceRequest& surface, const Units& units,
                    Mistakes& mistakes) {
  const mpm::ResultRow* row = mpm::find_result(surface.of);
  const std::string unit(row ? row->unit : "1");
  const std::string allowed =
      "allowed: a share of the range of the result below 100 %, such as \"2 %\", or a width in its unit" +
      (unit == "1" ? ", such as 0.02" : ", " + unit);
  const Entry* entry = table.find("tolerance");
  if (!entry) return mistakes.add(parent.place, "tolerance", {"missing", allowed});
  const std::string* text = entry->value.string();
  surface.is_share = text && trimmed(*text).ends_with('%');
  const Expected expected{surface.is_share ? "1" : std::string_view(unit), mpm::Range::positive, true};
  const Number number = read_quantity(entry->value, expected, units);
  if (const auto* refusal = std::get_if<Refusal>(&number))
    return mistakes.add("tolerance", entry->value, {refusal->wrong, allowed});
  surface.tolerance = std::get<double>(number);
  if (surface.is_share && !(surface.tolerance < 1))
    mistakes.add("tolerance", entry->value, {"not less than the whole range", allowed});
}

/// A whole number; `otherwise` where there is none.
std::int64_t read_number_of_runs(const Entry& parent, const Table& table, std::string_view key,
                                 std::optional<std::int64_t> otherwise, std::int64_t most,
                                 Mistakes& mistakes) {
  const std::string allowed = fmt::format("allowed: a whole number of runs from 1 to {}", most);
  const Entry* entry = table.find(key);
  if (!entry) {
    if (!otherwise) mistakes.add(parent.place, key, {"missing", allowed});
    return otherwise.value_or(0);
  }
  const auto* whole = std::get_if<std::int64_t>(&entry->value.data);
  if (whole && *whole >= 1 && *whole <= most) return *whole;
  mistakes.add(key, entry->value, {"not a number of runs", allowed});
  return 0;
}

}  // namespace

std::optional<SurfaceRequest> read_surface(const Table& document, const RequestContext& context,
                                           const Units& units, Mistakes& mistakes) {
  const Entry* entry = document.find("surface");
  if (!entry || !entry->value.table()) return std::nullopt;
  const Table& table = *entry->value.table();
  SurfaceRequest surface;
  surface.of = read_result_name("of", *entry, table, context, mistakes);
  read_tolerance(*entry, table, surface, units, mistakes);
  surface.budget = read_number_of_runs(*entry, table, "budget", {}, most_budget, mistakes);
  surface.batch = read_number_of_runs(*entry, table, "batch", default_batch, most_budget, mistakes);
  if (!context.critical.empty())
    mistakes.add(entry->place, "surface",
                 {"adds single runs, and the study has a [search]", "remove one of the two"});
  else if (context.cells > 1)
    mistakes.add(entry->place, "surface",
                 {"adds runs on one cell, and the study has a ladder of cells",
                  "remove ladder and accuracy, or [surface]"});
  return surface;
}

void check_surface(const SweepRequest& sweep, const Entry& section, const Study& study, Mistakes& mistakes) {
  const SurfaceRequest& surface = *study.surface;
  const Table& table = *section.value.table();
  if (!is_sampled(sweep.mode))
    return mistakes.add(section.place, "surface",
                        {"adds runs between those of a sampled mode, and this study is a " +
                             std::string(to_string(sweep.mode)),
                         "write mode = \"sobol\" in [sweep], with samples, seed and ranges"});
  const auto samples = static_cast<std::int64_t>(sweep.samples);
  if (surface.budget > 0 && surface.budget < samples)
    mistakes.add("budget", table.find("budget")->value,
                 {fmt::format("is less than the design alone has: samples = {}", samples),
                  "allowed: a budget of that or more"});
  const auto least = static_cast<std::int64_t>(3 * study.swept.size());
  if (samples < least)
    mistakes.add(section.place, "surface",
                 {fmt::format("begins with {} runs over {} quantities", samples, study.swept.size()),
                  fmt::format("allowed: samples = {} or more, three for each quantity", least)});
}

SweepRequest candidates_of(const SweepRequest& design, const SurfaceRequest& surface) {
  SweepRequest more = design;
  if (more.mode == SweepMode::latin_hypercube) more.mode = SweepMode::sobol;
  constexpr std::uint64_t least = 1024;
  more.samples = std::max(least, std::bit_ceil(4 * static_cast<std::uint64_t>(surface.budget)));
  return more;
}

}  // namespace mpmstudy
