#pragma once
/// What statements on results rest on: numbers of the done jobs of one study.
#include <filesystem>
#include <functional>
#include <map>
#include <optional>
#include <string>
#include <vector>

#include "libmpm/simulation.hpp"
#include "runner/catalog/query.hpp"
#include "runner/catalog/records.hpp"
#include "runner/finish/standing.hpp"
#include "runner/finish/study_results.hpp"
#include "runner/study/study.hpp"

namespace mpmstudy {

/// Numbers of the done jobs of studies. Of a study that the catalog does not have whole nothing is answered.
class Evidence {
 public:
  /// `studies` as their files say. Only of these, and only where the catalog has one whole, is anything
  /// answered: what stands under a name may be something else (`run --set`).
  Evidence(std::filesystem::path results, const std::vector<Study>& studies);

  /// Why nothing is answered of a study.
  const StudyStanding& standing(const std::string& study) const;

  /// One number: the first column of the first row. ?1 is the study. Empty: no row, or null.
  std::optional<double> number(const std::string& study, const std::string& sql) const;
  std::optional<std::string> text(const std::string& study, const std::string& sql) const;
  std::vector<double> numbers(const std::string& study, const std::string& sql) const;
  /// Of every row the first two columns: a number, its half width.
  std::vector<Measured> with_errors(const std::string& study, const std::string& sql) const;
  /// A metric of the study's first done job, or of the first that a condition on the view `jobs` (j) holds
  /// for.
  std::optional<double> metric(const std::string& study, const std::string& name,
                               const std::string& condition = "1") const;
  /// A metric of all done jobs that the condition holds for, in the order of a column of the view `jobs`.
  std::vector<double> metrics(const std::string& study, const std::string& name, const std::string& order,
                              const std::string& condition = "1") const;
  /// The same with the half widths of their intervals.
  std::vector<Measured> measured(const std::string& study, const std::string& name, const std::string& order,
                                 const std::string& condition = "1") const;
  /// Collapsibility of all done jobs, in the order of a column of the view `jobs`.
  std::vector<Measured> collapsibilities(const std::string& study, const std::string& order) const;
  /// "; intervals of at most 1.2 %": of the collapsibilities for cells of size 0; empty without several
  /// cells.
  std::string largest_interval(const std::string& study) const;
  /// Snapshots of the study's first done job, in order of time. One at a time: together they may be larger
  /// than memory. Throws std::runtime_error for one that cannot be read.
  void each_snapshot(const std::string& study, const std::function<void(const mpm::Snapshot&)>& visit) const;

 private:
  Rows ask(const std::string& study, const std::string& sql) const;
  std::filesystem::path results_;
  std::map<std::string, StudyStanding> standings_;
};

}  // namespace mpmstudy
