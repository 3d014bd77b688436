#include "runner/cli/missing.hpp"

#include <fmt/format.h>

#include "runner/catalog/query.hpp"
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
  const SqlValue name = study.name;
  const Rows failed = query(
      results.folder, "SELECT key FROM jobs WHERE study = ?1 AND status = 'failed' ORDER BY position LIMIT 1",
      std::span(&name, 1));
  if (!failed.rows.empty()) {
    const std::string key = short_key(std::get<std::string>(failed.rows[0][0]));
    fmt::print(stderr,
               "{}: `mpmstudy explain {}` says why the first of them failed, `mpmstudy retry --study {}` "
               "plans failed jobs again\n",
               study.name, key, study.name);
  }
  return exit_failed;
}

}  // namespace mpmstudy
