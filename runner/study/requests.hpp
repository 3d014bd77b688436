#pragma once
/// What a study asks for beside its runs: [[fit]], [[figure]], [search], [expect].
#include <optional>
#include <string>
#include <vector>

#include "libmpm/scene/parameters.hpp"
#include "runner/study/mistakes.hpp"
#include "runner/study/study.hpp"
#include "runner/study/units.hpp"

namespace mpmstudy {

/// What the rest of the file decides about its requests.
struct RequestContext {
  std::optional<mpm::SceneKind> kind;  ///< empty: the scene is unknown
  std::vector<std::string> fixed;      ///< quantities with one value in the file: no x of a fit or a figure
  std::vector<std::string> said;       ///< quantities and choices that the file or --set has
  int cells = 1;                       ///< of the study's ladders
  bool decides_ejection = false;       ///< some jobs may
  std::vector<mpm::Space> spaces = {mpm::Space::plane_strain};  ///< of its jobs
  bool has_snapshots = false;
  std::string critical;                         ///< what its [search] looks for; "": it has none
  std::vector<std::string> gauges = {};         ///< names
  std::vector<std::string> gauge_results = {};  ///< all that they come to: "rear.max"
  std::vector<OwnParameter> own = {};           ///< of the study

  /// Whether the study has a quantity, by its own name or by the other one of the same degree of freedom.
  bool says(std::string_view quantity) const;
};

std::vector<FitRequest> read_fits(const Table& document, const RequestContext&, Mistakes&);
std::vector<FigureRequest> read_figures(const Table& document, const RequestContext&, const Units&,
                                        Mistakes&);

/// Empty if there is no [search], or after adding mistakes.
std::optional<SearchRequest> read_search(const Table& document, std::optional<mpm::SceneKind>, const Units&,
                                         Mistakes&);

/// Empty if there is no [surface], or after adding mistakes. Its candidates are left out.
std::optional<SurfaceRequest> read_surface(const Table& document, const RequestContext&, const Units&,
                                           Mistakes&);

/// A key that names a result which jobs of this study can have. Adds a mistake for another one.
std::string read_result_name(std::string_view key, const Entry& parent, const Table&, const RequestContext&,
                             Mistakes&);

/// Whether a ladder of cells gives a result an interval (libmpm/measure/results.hpp).
bool has_interval(std::string_view result);
/// Those of one job. With a kind: that this kind of scene has.
std::vector<std::string_view> results_with_interval(std::optional<mpm::SceneKind>);

/// Empty if there is no [expect], or after adding mistakes.
std::optional<Expectation> read_expectation(const Table& document, const Units&, Mistakes&);

/// A name that can be a file's.
bool is_file_name(std::string_view);
inline constexpr const char* allowed_file_name =
    "allowed: up to 100 letters, digits, '-', '_' and '.', not first a '.'";

/// A string that must be there. Empty after adding a mistake.
std::optional<std::string> required_string(const Table&, const Place&, std::string_view key,
                                           std::string_view what, Mistakes&);
/// A string that is shown on terminals, pages and figures: without control characters.
std::optional<std::string> required_title(const Table&, const Place&, Mistakes&);

}  // namespace mpmstudy
