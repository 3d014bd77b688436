#include "runner/cli/json_results.hpp"

#include <algorithm>
#include <limits>
#include <map>

#include "libmpm/measure/results.hpp"
#include "runner/catalog/connection.hpp"
#include "runner/catalog/job_rows.hpp"
#include "runner/catalog/sql.hpp"
#include "runner/catalog/study_tables.hpp"
#include "runner/cli/print_results.hpp"
#include "runner/cli/skipped_points.hpp"
#include "runner/cli/surface_text.hpp"
#include "runner/finish/fits.hpp"
#include "runner/finish/study_results.hpp"

namespace mpmstudy {
namespace {

using Json = nlohmann::ordered_json;

Json json_of(const SqlValue& value) {
  return std::visit(
      []<class T>(const T& v) {
        if constexpr (std::is_same_v<T, std::int64_t> || std::is_same_v<T, double> ||
                      std::is_same_v<T, std::string>)
          return Json(v);
        else
          return Json(nullptr);
      },
      value);
}

/// What fits and figures show, then all other numbers that this kind of scene can come to.
std::vector<std::string> all_results(const Study& study) {
  auto names = results_of_interest(study, std::numeric_limits<std::size_t>::max());
  std::erase_if(names, [](const std::string& name) {
    return !mpm::find_result(name) && !mpm::is_of_gauge(name);  // of a search: in its brackets
  });
  const auto add = [&](const std::string& name) {
    if (std::ranges::find(names, name) == names.end()) names.push_back(name);
  };
  for (const mpm::ResultRow& row : mpm::results())
    if (row.belongs_to(study.kind)) add(std::string(row.name));
  return names;
}

std::string error_name(const std::string& result) {
  const mpm::ResultRow* row = mpm::find_result(result);
  return row && !row->error_column.empty() ? std::string(row->error_column) : result + "_error";
}

/// Results that no job has, and intervals that none has, are left out.
Json jobs_of(const Study& study, const std::filesystem::path& results) {
  const auto names = all_results(study);
  const auto rows = job_rows(results, {study.name, study.swept, names});
  Json jobs = Json::array();
  const auto any = [&](std::size_t at, std::optional<double> JobResult::*part) {
    return std::ranges::any_of(rows, [&](const JobRow& row) { return (row.results[at].*part).has_value(); });
  };
  const auto number = [](const std::optional<double>& value) { return value ? Json(*value) : Json(nullptr); };
  std::vector<bool> has_value, has_error;
  for (std::size_t at = 0; at < names.size(); ++at) {
    has_value.push_back(any(at, &JobResult::value));
    has_error.push_back(any(at, &JobResult::error));
  }
  for (const JobRow& row : rows) {
    Json job = {{"key", row.key},
                {"status", to_string(row.status)},
                {"outcome", row.outcome.empty() ? Json(nullptr) : Json(row.outcome)},
                {"flags", row.flags}};
    for (std::size_t at = 0; at < study.swept.size(); ++at)
      job[column_of_parameter(study.swept[at])] = json_of(row.parameters[at]);
    for (std::size_t at = 0; at < names.size(); ++at) {
      if (has_value[at]) job[names[at]] = number(row.results[at].value);
      if (has_error[at]) job[error_name(names[at])] = number(row.results[at].error);
    }
    jobs.push_back(std::move(job));
  }
  return jobs;
}

Json brackets_of_search(const Study& study, const std::filesystem::path& results) {
  std::vector<std::string> parameters = study.swept;
  std::erase(parameters, "cell_size");  // has a column of its own
  const StudyTable table = table_of_brackets(results, study.name, parameters);
  Json brackets = Json::array();
  for (const StudyTable::Row& row : table.rows) {
    Json bracket = Json::object();
    for (std::size_t at = 0; at < table.head.size(); ++at) bracket[table.head[at]] = json_of(row.cells[at]);
    brackets.push_back(std::move(bracket));
  }
  return brackets;
}

Json fits_of_study(const Study& study, const std::filesystem::path& results) {
  Json fits = Json::array();
  if (study.fits.empty()) return fits;
  for (const FitRow& row : fit_study(study, read_results(study, results)).rows) {
    if (row.coefficient == "c0")
      fits.push_back({{"quantity", row.quantity},
                      {"against", row.against},
                      {"model", row.model},
                      {"family", Json::parse(row.family)},
                      {"points", row.points},
                      {"r2", row.r2 ? Json(*row.r2) : Json(nullptr)},
                      {"reduced_chi2", row.reduced_chi2 ? Json(*row.reduced_chi2) : Json(nullptr)},
                      {"coefficients", Json::array()}});
    fits.back()["coefficients"].push_back(
        {{"name", row.coefficient},
         {"value", row.value},
         {"standard_error", row.standard_error ? Json(*row.standard_error) : Json(nullptr)},
         {"unit", row.unit}});
  }
  return fits;
}

}  // namespace

nlohmann::ordered_json results_json(const Study& study, const std::filesystem::path& results) {
  Json json = {{"study", study.name},
               {"title", study.title},
               {"scene", mpm::to_string(study.kind)},
               {"file", study.path.string()},
               {"jobs", jobs_of(study, results)}};
  if (study.search) json["brackets"] = brackets_of_search(study, results);
  if (study.surface) json["surface"] = tolerance_json(study, results);
  json["fits"] = fits_of_study(study, results);
  json["skipped"] = skipped_json(study);
  return json;
}

std::string results_json(const std::vector<Study>& studies, const std::filesystem::path& results,
                         int exit_code) {
  Json json = {
      {"studies", Json::array()}, {"catalog", catalog_path(results).string()}, {"exit_code", exit_code}};
  for (const Study& study : studies) json["studies"].push_back(results_json(study, results));
  return json.dump(2, ' ', false, Json::error_handler_t::replace);
}

}  // namespace mpmstudy
