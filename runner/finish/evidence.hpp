#pragma once
/// What statements on results rest on: numbers of the done jobs of one study.
#include <filesystem>
#include <functional>
#include <map>
#include <optional>
#include <string>
#include <vector>

#include "libmpm/simulation.hpp"
#include "runner/catalog/found_values.hpp"
#include "runner/catalog/job_rows.hpp"
#include "runner/finish/standing.hpp"
#include "runner/finish/study_results.hpp"
#include "runner/study/study.hpp"

namespace mpmstudy {

/// A result of one job, and a parameter of its scene.
struct ResultAt {
  double parameter = 0;  ///< 0 where none was asked for
  ValueWithError result;
  std::string flags;  ///< why the final area of the job has no meaning; "": it has one
};

/// Numbers of the done jobs of studies. Of a study that the catalog does not have whole nothing is answered.
class Evidence {
 public:
  /// `studies` as their files say. Only of these, and only where the catalog has one whole, is anything
  /// answered: what stands under a name may be something else (`run --set`).
  Evidence(std::filesystem::path results, const std::vector<Study>& studies);

  /// Why nothing is answered of a study.
  const StudyStanding& standing(const std::string& study) const;

  /// The first done job in the order of the sweep, with these parameters.
  std::optional<JobRow> first_done(const std::string& study,
                                   const std::vector<std::string>& parameters = {}) const;
  /// A result of all done jobs that have it, in the order of the sweep; with a parameter, in the order of
  /// that.
  std::vector<ResultAt> results(const std::string& study, const std::string& result,
                                const std::string& parameter = "") const;
  /// The first of these.
  std::optional<double> result(const std::string& study, const std::string& result) const;
  /// Flags of the first done job that has any.
  std::optional<std::string> flags(const std::string& study) const;

  std::vector<FitRow> fits(const std::string& study, const std::string& quantity) const;
  std::vector<CriticalSpeed> critical_speeds(const std::string& study, const std::string& parameter) const;
  /// Of the intervals from several cells; empty: there are none.
  std::optional<double> largest_relative_error(const std::string& study, const std::string& quantity) const;
  /// Snapshots of the study's first done job, in order of time. One at a time: together they may be larger
  /// than memory. Throws std::runtime_error for one that cannot be read.
  void each_snapshot(const std::string& study, const std::function<void(const mpm::Snapshot&)>& visit) const;

 private:
  bool is_whole(const std::string& study) const;
  std::filesystem::path results_;
  std::map<std::string, StudyStanding> standings_;
};

}  // namespace mpmstudy
