#include "runner/finish/evidence.hpp"

#include <algorithm>

#include "libmpm/io/vtkhdf.hpp"
#include "runner/catalog/accuracy.hpp"
#include "runner/catalog/job_results.hpp"

namespace mpmstudy {

Evidence::Evidence(std::filesystem::path results, const std::vector<Study>& studies)
    : results_(std::move(results)) {
  for (const Study& study : studies) standings_[study.name] = standing_of(study, results_);
}

const StudyStanding& Evidence::standing(const std::string& study) const {
  static const StudyStanding unknown{Standing::other, "its study file is not among those given"};
  const auto found = standings_.find(study);
  return found == standings_.end() ? unknown : found->second;
}

bool Evidence::is_whole(const std::string& study) const {
  return standing(study).standing == Standing::whole;
}

std::optional<JobRow> Evidence::first_done(const std::string& study,
                                           const std::vector<std::string>& parameters) const {
  if (!is_whole(study)) return std::nullopt;
  const auto rows = job_rows(results_, {study, parameters, {}, true, 1});
  return rows.empty() ? std::nullopt : std::optional(rows.front());
}

std::vector<ResultAt> Evidence::results(const std::string& study, const std::string& result,
                                        const std::string& parameter) const {
  std::vector<ResultAt> found;
  if (!is_whole(study)) return found;
  JobRequest request{study, {}, {result}, true};
  if (!parameter.empty()) request.parameters = {parameter};
  for (const JobRow& row : job_rows(results_, request)) {
    const double at = parameter.empty() ? 0 : number_of(row.parameters[0]).value_or(0);
    if (const JobResult& one = row.results[0]; one.value)
      found.push_back({at, {*one.value, one.error}, row.flags});
  }
  std::ranges::stable_sort(found, {}, &ResultAt::parameter);
  return found;
}

std::optional<double> Evidence::result(const std::string& study, const std::string& result) const {
  const auto found = results(study, result);
  return found.empty() ? std::nullopt : std::optional(found.front().result.value);
}

std::optional<std::string> Evidence::flags(const std::string& study) const {
  if (!is_whole(study)) return std::nullopt;
  const auto rows = job_rows(results_, {study, {}, {}, true});
  const auto flagged = std::ranges::find_if(rows, [](const JobRow& row) { return !row.flags.empty(); });
  return flagged == rows.end() ? std::nullopt : std::optional(flagged->flags);
}

std::vector<FitRow> Evidence::fits(const std::string& study, const std::string& quantity) const {
  return is_whole(study) ? fits_of(results_, study, quantity) : std::vector<FitRow>();
}

std::vector<CriticalSpeed> Evidence::critical_speeds(const std::string& study,
                                                     const std::string& parameter) const {
  return is_whole(study) ? mpmstudy::critical_speeds(results_, study, parameter)
                         : std::vector<CriticalSpeed>();
}

std::optional<double> Evidence::largest_relative_error(const std::string& study,
                                                       const std::string& quantity) const {
  return is_whole(study) ? mpmstudy::largest_relative_error(results_, study, quantity) : std::nullopt;
}

void Evidence::each_snapshot(const std::string& study,
                             const std::function<void(const mpm::Snapshot&)>& visit) const {
  if (const auto job = first_done(study))
    for (const auto& path : snapshot_paths(results_, job->key)) visit(mpm::read_vtkhdf(results_ / path));
}

}  // namespace mpmstudy
