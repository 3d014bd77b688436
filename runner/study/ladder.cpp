#include "runner/study/ladder.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "libmpm/scene/kinds/kind.hpp"
#include "runner/study/quantity_text.hpp"
#include "runner/study/requests.hpp"
#include "runner/study/schema.hpp"
#include "runner/study/study.hpp"

namespace mpmstudy {
namespace {

/// More would reach cells that no machine holds.
constexpr int most_cells = 16;

int read_cells(const Entry& entry, int least, Mistakes& mistakes) {
  const auto* cells = std::get_if<std::int64_t>(&entry.value.data);
  if (cells && *cells >= least && *cells <= most_cells) return static_cast<int>(*cells);
  mistakes.add("ladder", entry.value,
               {"not a number of cells", "allowed: a whole number from " + std::to_string(least) + " to " +
                                             std::to_string(most_cells)});
  return least;
}

std::optional<double> read_accuracy(const Entry& entry, const Units& units, Mistakes& mistakes) {
  const std::string allowed = "allowed: a share between 0 and 1, such as \"1 %\" or 0.01";
  const Number number = read_quantity(entry.value, {"1", mpm::Range::positive}, units);
  if (const auto* refusal = std::get_if<Refusal>(&number)) {
    mistakes.add("accuracy", entry.value, {refusal->wrong, allowed});
    return std::nullopt;
  }
  const double share = std::get<double>(number);
  if (!(share < 1)) mistakes.add("accuracy", entry.value, {"not less than the whole", allowed});
  return share;
}

}  // namespace

double rung_ratio() { return std::numbers::sqrt2; }

double finer_cell(double cell, int rungs) {
  const int pairs = rungs >= 0 ? rungs / 2 : -((1 - rungs) / 2);  // towards minus infinity
  const double finer = std::ldexp(cell, -pairs);
  return rungs == 2 * pairs ? finer : finer / rung_ratio();
}

double coarsest_cell(const mpm::Scene& s) { return mpm::kind_of(s).coarsest_cell(s); }

std::string_view default_accuracy_of(mpm::SceneKind kind) { return mpm::kind_of(kind).headline; }

LadderRequest read_ladder(const Table* numerics, std::optional<mpm::SceneKind> kind,
                          const std::vector<std::string>& gauge_results, const Units& units,
                          Mistakes& mistakes) {
  LadderRequest request;
  if (kind) request.quantity = default_accuracy_of(*kind);
  if (!numerics) return request;
  const Entry* cell = numerics->find("cell_size");
  const Entry* accuracy = numerics->find("accuracy");
  const Entry* of = numerics->find("accuracy_of");
  const Entry* ladder = numerics->find("ladder");
  request.finds_cell = !cell && (accuracy || ladder);
  if (accuracy) request.accuracy = read_accuracy(*accuracy, units, mistakes);
  if (accuracy) request.cells = default_most_cells;
  if (ladder) request.cells = read_cells(*ladder, accuracy ? first_cells : 1, mistakes);
  if (accuracy && cell)
    mistakes.add("accuracy", accuracy->value,
                 {"the cell is given and looked for", "remove accuracy or cell_size"});
  if (of && !accuracy) {
    mistakes.add("accuracy_of", of->value, {"there is no accuracy", "add accuracy = \"1 %\", or remove it"});
  } else if (of) {
    const std::string* name = of->value.string();
    auto names = results_with_interval(kind);
    names.insert(names.end(), gauge_results.begin(), gauge_results.end());
    if (!name || std::find(names.begin(), names.end(), *name) == names.end())
      mistakes.add("accuracy_of", of->value, unknown_word(name ? *name : "", "result", names));
    else
      request.quantity = *name;
  }
  return request;
}

void sweep_ladder(Study& study) {
  std::vector<mpm::Scene> scenes;
  for (const mpm::Scene& scene : study.scenes)
    for (int k = 0; k < study.ladder.cells; ++k) {
      scenes.push_back(scene);
      scenes.back().numerics.cell_size =
          finer_cell(scene.numerics.cell_size, study.ladder.finds_cell ? k : k + 1 - study.ladder.cells);
    }
  study.scenes = std::move(scenes);
  study.ladder = {};
  if (std::ranges::find(study.swept, "cell_size") == study.swept.end()) study.swept.emplace_back("cell_size");
}

}  // namespace mpmstudy
