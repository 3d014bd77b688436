#pragma once
/// Every kind of figure that a study can ask for ([[figure]] kind = "..."). A kind is added by its row here
/// and by the function that draws it (runner/finish/figures.cpp).
#include <array>
#include <string_view>

#include "libmpm/core/enumerators.hpp"

namespace mpmstudy {

enum class FigureKind { history, xy, map, fields, calibration };

/// What its key `y` names; of a kind with `colour` that names a result.
enum class FigureY {
  history,               ///< of a gauge; none: of a cavity's area
  result,                ///< of a job, or what [search] finds
  quantity,              ///< that the study sweeps
  result_with_interval,  ///< of a job, by several cells
  field                  ///< of a snapshot
};

struct FigureKindRow {
  FigureKind kind;
  std::string_view word;  ///< in study files
  bool has_x = false;     ///< its key `x` names a swept quantity; where y is a result, also another result
  FigureY y;
  bool of_snapshots = false;  ///< only of studies that write them; one file per job
  bool has_colour = false;    ///< its key `colour` names a result; one file per group of jobs
  int least_cells = 1;        ///< of the study's ladders; more than one: of single runs, not of a search
};

inline constexpr std::array figure_kinds = {
    FigureKindRow{.kind = FigureKind::history, .word = "history", .y = FigureY::history},
    FigureKindRow{.kind = FigureKind::xy, .word = "xy", .has_x = true, .y = FigureY::result},
    FigureKindRow{
        .kind = FigureKind::map, .word = "map", .has_x = true, .y = FigureY::quantity, .has_colour = true},
    FigureKindRow{.kind = FigureKind::fields, .word = "fields", .y = FigureY::field, .of_snapshots = true},
    // An interval takes four cells, and what it is held against one more (first_cells of ladder.hpp).
    FigureKindRow{.kind = FigureKind::calibration,
                  .word = "calibration",
                  .y = FigureY::result_with_interval,
                  .least_cells = 5}};
static_assert(figure_kinds.size() == mpm::enumerators<FigureKind>());

/// Null if there is no such kind.
constexpr const FigureKindRow* find_figure_kind(std::string_view word) {
  for (const FigureKindRow& row : figure_kinds)
    if (row.word == word) return &row;
  return nullptr;
}
constexpr const FigureKindRow& row_of(FigureKind kind) {
  for (const FigureKindRow& row : figure_kinds)
    if (row.kind == kind) return row;
  throw "every kind has a row";
}

}  // namespace mpmstudy
