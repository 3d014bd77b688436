#pragma once
/// What a study's jobs have come to, read from the catalog: the tables that fits and figures are made from.
#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "libmpm/scene/parameters.hpp"
#include "libmpm/simulation.hpp"
#include "runner/study/study.hpp"

namespace mpmstudy {

/// A number with the half width of its interval, in the unit of its column.
struct ValueWithError {
  double value = 0;
  std::optional<double> error;
};

/// One done job of a study.
struct JobResults {
  std::string key;
  mpm::Scene scene;
  std::optional<ValueWithError>
      critical;  ///< of a search: middle and half width of the bracket; key: its upper end
  std::optional<ValueWithError> extrapolated;  ///< ... for cells of size 0
  std::string flags;                           ///< ... of the bracket (view `brackets`)
};

/// The done jobs of a study, in the order of its sweep, each once, and how many are not done; of a study with
/// [search], the brackets that were found, and how many points have not been searched.
struct StudyResults {
  std::string study;             ///< its name
  std::filesystem::path folder;  ///< the results folder
  std::vector<JobResults> done;
  std::size_t missing = 0;
  std::string fingerprint;                  ///< of keys and results: 16 hexadecimal digits
  const mpm::Quantity* critical = nullptr;  ///< what the study searches, or null
};

/// Throws CatalogError if there is no catalog.
StudyResults read_results(const Study&, const std::filesystem::path& results);

/// Whether a result means nothing once the cavity is no closed hole: what the column `flags` of the view
/// `jobs` is about.
bool is_of_the_final_area(const std::string& name);

/// A number that has no meaning in its job (view `jobs`, column `flags`) is left out of figures and fits: a
/// line each, "collapsibility of job 1a2b3c4d5e6f: cavity open to the outside ...". So is a bracket that is
/// doubtful. Of the results that the study's figures and fits ask for.
std::vector<std::string> left_out(const Study&, const StudyResults&);

/// Whether the flags of a bracket leave open where the critical value is: the outcome flips back at a larger
/// value, or the run at the lower end had not decided. One that says "failed at ..." is proven by the runs at
/// its ends all the same.
bool is_doubtful(const std::string& flags_of_bracket);
/// Brackets that are drawn and fitted although they have flags, a line each: "impact_speed of the bracket at
/// cell_size = 0.1 um: failed at 900 m/s".
std::vector<std::string> flagged_brackets(const Study&, const StudyResults&);

/// A result column of the view `jobs`, a name of the view `metrics`, or one of a search
/// (runner/study/searched.hpp); empty where the job has none, or one without a meaning.
std::optional<ValueWithError> result_of(const StudyResults&, const JobResults&, const std::string& name);
/// SI unit of such a name: that of the searched quantity, that of the metric, or what the column's name ends
/// in.
std::string unit_of(const StudyResults&, const std::string& name);

/// What a gauge of the job has seen; empty where it has none of that name.
mpm::History history_of(const StudyResults&, const JobResults&, const std::string& gauge);
std::vector<mpm::AreaSample> area_history_of(const StudyResults&, const JobResults&);
/// Files of a job's snapshots, in order of time.
std::vector<std::filesystem::path> snapshots_of(const StudyResults&, const JobResults&);

/// Jobs that differ in a few swept names alone, and what sets them apart from the other groups.
struct Group {
  std::string label;          ///< "h = 0.1 um", digits until labels differ; empty if there is one group
  std::string family = "{}";  ///< the same as a JSON object: column of the view `jobs` -> value
  std::vector<const JobResults*> jobs;
};
/// Groups by the values of all that the study sweeps apart from `within`; without any, every job is a group.
/// Values that differ by rounding alone are one: a wall thickness is a difference of lengths.
std::vector<Group> group_jobs(const Study&, const StudyResults&, const std::vector<std::string>& within);
/// What jobs on one curve of `y` against `x` differ in: x; cells, where y is extrapolated from them;
/// what goes together with x, where that has as many values (zip, points); everything, where no two scenes
/// have the same x, and where x is a result.
std::vector<std::string> curve_of(const Study&, const std::string& x, const std::string& y);
/// What jobs on one map over x and y differ in: both, and what goes together with one of them.
std::vector<std::string> map_of(const Study&, const std::string& x, const std::string& y);

}  // namespace mpmstudy
