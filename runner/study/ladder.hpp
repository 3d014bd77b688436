#pragma once
/// [numerics] ladder, accuracy, accuracy_of: how many cells a study asks for, or how small an interval.
#include <optional>
#include <string_view>

#include "libmpm/scene/scene.hpp"
#include "runner/study/ladder_request.hpp"
#include "runner/study/mistakes.hpp"
#include "runner/study/units.hpp"

namespace mpmstudy {

struct Study;

/// Cells that an accuracy may climb where a study says nothing.
inline constexpr int default_most_cells = 7;
/// Cells that an interval is first asked of.
inline constexpr int first_cells = 4;

/// Cells from one rung of a ladder to the next are smaller by this factor.
double rung_ratio();
/// The cell that is `rungs` (may be negative) finer than this one [m]. Two rungs are exactly a factor of two.
double finer_cell(double cell, int rungs);

/// The cell at which a scene's ladder begins where nothing says so [m].
double coarsest_cell(const mpm::Scene&);

/// What an accuracy is asked of where a study does not say: the number that this kind of scene is about.
std::string_view default_accuracy_of(mpm::SceneKind);

/// Reads the keys out of [numerics]; null: there is no such table. Adds what is wrong with them.
LadderRequest read_ladder(const Table* numerics, std::optional<mpm::SceneKind>,
                          const std::vector<std::string>& gauge_results, const Units&, Mistakes&);

/// A ladder under a search is a sweep of its cells: each is searched, the finer from the coarser ones, and
/// the brackets are extrapolated.
void sweep_ladder(Study&);

}  // namespace mpmstudy
