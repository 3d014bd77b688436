#include "libmpm/measure/results.hpp"

#include <algorithm>
#include <stdexcept>
#include <string>
#include <vector>

#include "libmpm/measure/energy.hpp"
#include "libmpm/measure/health.hpp"
#include "libmpm/measure/hot_spots.hpp"
#include "libmpm/scene/kinds/kind.hpp"

namespace mpm {
namespace {

/// What a run costs: nothing that is measured in it.
constexpr ResultRow cost_rows[] = {
    {.name = "particles",
     .unit = "1",
     .meaning = "particles of the run",
     .has_interval = false,
     .lower = 0,
     .metric = false,
     .column = true},
    {.name = "steps",
     .unit = "1",
     .meaning = "time steps of the run",
     .has_interval = false,
     .lower = 0,
     .metric = false,
     .column = true},
    {.name = "wall_s",
     .unit = "s",
     .meaning = "duration",
     .has_interval = false,
     .lower = 0,
     .metric = false,
     .column = true},
    {.name = "cpu_s",
     .unit = "s",
     .meaning = "time on a processor",
     .has_interval = false,
     .lower = 0,
     .metric = false,
     .column = true},
};
std::span<const ResultRow> cost() { return cost_rows; }

/// Of every kind of scene.
constexpr Results common[] = {cost, Balance::results, Health::results, HotSpots::results};

/// Takes a row of a kind; one that an earlier kind has too is shared.
void add(std::vector<ResultRow>& table, ResultRow row, SceneKind kind) {
  const unsigned bit = 1u << static_cast<unsigned>(kind);
  const auto there = std::ranges::find(table, row.name, &ResultRow::name);
  if (there == table.end()) {
    row.belongs_to.bits = bit;
    table.push_back(row);
  } else if (there->unit == row.unit && there->meaning == row.meaning) {
    there->belongs_to.bits |= bit;
  } else {
    throw std::logic_error("two kinds of scene have different results " + std::string(row.name));
  }
}

/// What runs of a kind have as columns, what all runs have, and the other results of kinds.
std::vector<ResultRow> make_table() {
  std::vector<ResultRow> table;
  const auto take_those_of_kinds = [&](bool columns) {
    for (const Kind* kind : kinds())
      for (const Results rows : kind->results)
        for (const ResultRow& row : rows())
          if (row.column == columns) add(table, row, kind->kind);
  };
  take_those_of_kinds(true);
  for (const Results rows : common) table.insert(table.end(), rows().begin(), rows().end());
  take_those_of_kinds(false);
  return table;
}

const std::vector<ResultRow>& table() {
  static const auto rows = make_table();
  return rows;
}

}  // namespace

std::span<const ResultRow> results() { return table(); }

const ResultRow* find_result(std::string_view name) {
  for (const ResultRow& row : table())
    if (row.name == name) return &row;
  return nullptr;
}

}  // namespace mpm
