#include "runner/cli/run_plan.hpp"

#include <fmt/format.h>

#include <filesystem>
#include <fstream>
#include <map>
#include <sstream>
#include <unordered_set>

#include "runner/search/search_planner.hpp"

namespace mpmstudy {
namespace {

/// Keys of jobs from a file, separated by blanks or ends of lines: key -> line. Throws StudyError.
std::map<std::string, int> read_keys(const std::string& path) {
  std::ifstream file(path);
  if (!file) throw StudyError(path + ": cannot be read; --only names a file of keys, one per line");
  std::map<std::string, int> keys;
  int number = 1;
  for (std::string line; std::getline(file, line); ++number) {
    std::istringstream words(line);
    for (std::string key; words >> key;) keys.emplace(key, number);
  }
  if (keys.empty()) throw StudyError(path + ": holds no key; --only names a file of keys, one per line");
  return keys;
}

/// Has only the jobs run whose keys are in a file. Throws StudyError naming those that no study has.
void choose(const std::string& path, const std::map<std::string, int>& lines,
            std::vector<PlannedStudy>& planned) {
  std::unordered_set<std::string> keys, known;
  for (const auto& [key, line] : lines) keys.insert(key);
  std::string names;
  for (auto& study : planned) {
    study.selection.keys = keys;
    for (const auto& job : jobs_to_run(study)) known.insert(job.key);
    names += (names.empty() ? "" : ", ") + study.plan.study;
  }
  std::string unknown;
  std::size_t more = 0;
  for (const auto& [key, line] : lines) {
    if (known.contains(key)) continue;
    if (++more <= 5) unknown += fmt::format("{}:{}: {}\n", path, line, key);
  }
  if (more > 5) unknown += fmt::format("and {} more\n", more - 5);
  if (more > 0)
    throw StudyError(unknown + "not a key of a job of " + names +
                     " as its file and the options are now; `mpmstudy plan --json` lists the keys, of 32 "
                     "hexadecimal digits");
}

StudySource source_of(const Study& study, const StudyOptions& options) {
  return {std::filesystem::absolute(study.path).lexically_normal().string(), options.set, options.cells};
}

}  // namespace

double share_of(const std::string& text) {
  std::size_t end = 0;
  double share = -1;
  try {
    share = std::stod(text, &end);
  } catch (const std::exception&) {
    end = 0;
  }
  std::string rest = text.substr(std::min(end, text.size()));
  std::erase(rest, ' ');
  if (rest == "%") share /= 100;
  if (end == 0 || (!rest.empty() && rest != "%") || !(share >= 0 && share <= 1))
    throw StudyError("--audit: " + text + ": not a share; write for example --audit \"5 %\"");
  return share;
}

std::vector<PlannedStudy> plan_studies(const RunOptions& options, const std::vector<Study>& studies,
                                       const CostModel& cost) {
  std::vector<PlannedStudy> planned;
  const auto keys = options.only.empty() ? std::map<std::string, int>() : read_keys(options.only);
  for (Study study : studies) {
    const StudySource source = source_of(study, options.study);
    if (study.search && options.only.empty()) {
      planned.push_back(
          {{study.name, {}, {}, {}, cost}, study.title, source, {}, study, share_of(options.audit)});
      continue;
    }
    if (study.search)
      study.scenes = possible_scenes(study, [&](const std::string& key) { return keys.contains(key); });
    planned.push_back({make_plan(study, cost), study.title, source, {}, {}, 0});
    if (study.surface) planned.back().surface = study;
    if (options.only.empty()) continue;
    auto& members = planned.back().selection.members;
    if (study.search || study.surface || options.shard)
      members = Members::also;
    else if (!planned.back().plan.ladders.empty())
      members = Members::at_least;
  }
  if (!options.only.empty()) choose(options.only, keys, planned);
  return planned;
}

}  // namespace mpmstudy
