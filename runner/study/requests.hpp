#pragma once
/// What a study asks for beside its runs: [[fit]], [[figure]], [search], [expect].
#include <optional>
#include <string>
#include <vector>

#include "libmpm/scene/parameters.hpp"
#include "runner/study/problems.hpp"
#include "runner/study/study.hpp"
#include "runner/study/units.hpp"

namespace mpmstudy {

/// `kind`: empty if the scene is unknown. `fixed`: quantities that a fit or a figure may not use as x because
/// the file gives them one value only.
struct RequestContext {
  std::optional<mpm::SceneKind> kind;
  std::vector<std::string> fixed;
  int cells = 1;         ///< of the study's ladders
  std::string critical;  ///< what its [search] looks for; "": it has none
};

std::vector<FitRequest> read_fits(const Table& document, const RequestContext&, Problems&);
std::vector<FigureRequest> read_figures(const Table& document, const RequestContext&, Problems&);

/// Empty if there is no [search], or after adding problems.
std::optional<SearchRequest> read_search(const Table& document, std::optional<mpm::SceneKind>, const Units&,
                                         Problems&);

/// Whether a ladder of cells gives a result an interval: what is measured, apart from what is an error
/// itself.
bool has_interval(std::string_view result);
std::vector<std::string_view> results_with_interval();

/// Empty if there is no [expect], or after adding problems.
std::optional<Expectation> read_expectation(const Table& document, const Units&, Problems&);

/// A name that can be a file's: letters, digits, '-', '_', '.', not first a '.'.
bool is_file_name(std::string_view);

/// A string that must be there. Empty after adding a problem.
std::optional<std::string> required_string(const Table&, const Place&, std::string_view key,
                                           std::string_view what, Problems&);

}  // namespace mpmstudy
