#include "runner/cli/missing.hpp"

#include <fmt/format.h>

#include "runner/catalog/job_states.hpp"
#include "runner/cli/cli.hpp"
#include "runner/finish/figures.hpp"
#include "runner/finish/standing.hpp"
#include "runner/status/label.hpp"

namespace mpmstudy {

int say_what_is_missing(const Study& study, const StudyResults& results, const std::string& again) {
  for (const std::string& note : figure_notes(study, results))
    fmt::print(stderr, "{}: {}\n", study.name, note);
  const StudyStanding found = standing_of(study, results.folder);
  const bool other_jobs_too = found.standing == Standing::other && results.missing == 0;
  if (found.standing == Standing::whole || other_jobs_too) return exit_ok;
  if (found.standing == Standing::other) {
    // How far a study has come is said by the numbers; that it is another one is not.
    const bool progress = found.why.ends_with("are done") || found.why.ends_with("are bracketed");
    fmt::print(stderr, "{}: {} of {} {} not done{}; `mpmstudy run {}` runs them\n", study.name,
               results.missing, results.missing + results.done.size(),
               study.search ? "points are" : "jobs are", progress ? "" : " (" + found.why + ")", again);
    return exit_stopped;
  }
  fmt::print(stderr, "{}: {}\n", study.name, found.why);
  const auto failed = keys_of(results.folder, study.name, JobStatus::failed);
  if (!failed.empty()) {
    const std::string key = short_key(failed.front());
    fmt::print(stderr,
               "{}: `mpmstudy explain {}` says why the first of them failed, `mpmstudy retry --study {}` "
               "plans failed jobs again\n",
               study.name, key, study.name);
  }
  return exit_failed;
}

}  // namespace mpmstudy
