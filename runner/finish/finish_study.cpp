#include "runner/finish/finish_study.hpp"

#include <fmt/format.h>

#include <stdexcept>

#include "runner/catalog/accuracy.hpp"
#include "runner/finish/figures.hpp"
#include "runner/finish/fits.hpp"
#include "runner/ladder/intervals.hpp"
#include "runner/status/label.hpp"

namespace mpmstudy {

/// In a message; the others are counted.
constexpr std::size_t most_named = 5;

namespace {

/// Throws if an accuracy was missed; the message is the last one of the run.
void check_accuracy(const Study& study, const std::filesystem::path& folder) {
  const auto jobs = accuracies(folder, study.name, study.ladder.quantity);
  std::string missed;
  std::size_t count = 0;
  for (const JobAccuracy& job : jobs) {
    if (job.reached) continue;
    if (++count <= most_named) missed += " " + short_key(job.key);
  }
  if (count == 0) return;
  throw std::runtime_error(fmt::format(
      "accuracy {:g} % of {} not reached by {} of {} jobs with up to {} cells:{}{}; view accuracy "
      "has what was reached, a larger ladder or accuracy goes on from there",
      100 * *study.ladder.accuracy, study.ladder.quantity, count, jobs.size(), study.ladder.cells, missed,
      count > most_named ? " ..." : ""));
}

}  // namespace

void finish_study(const Study& study, const std::filesystem::path& folder, CatalogWriter& writer) {
  writer.replace_intervals(study.name, intervals_of(study, folder));
  const StudyResults results = read_results(study, folder);
  Fits fits = fit_study(study, results);
  for (const std::string& failure : fits.not_made)
    fmt::print(stderr, "{}: no fit, {}\n", study.name, failure);
  for (const std::string& note : fits.notes) fmt::print(stderr, "{}: {}\n", study.name, note);
  for (const std::string& note : figure_notes(study, results))
    fmt::print(stderr, "{}: {}\n", study.name, note);
  writer.replace_fits(study.name, std::move(fits.rows));
  const auto drawn = draw_figures(study, results);
  for (const auto& path : drawn) fmt::print("{}\n", path.string());
  const auto empty = not_drawn(study, drawn, folder);
  for (const std::string& line : empty) fmt::print(stderr, "{}: {}\n", study.name, line);
  if (study.ladder.accuracy) check_accuracy(study, folder);
  if (const std::size_t missed = fits.not_made.size() + empty.size(); missed > 0)
    throw std::runtime_error(fmt::format("{} could not be made, for the reasons above",
                                         missed == 1 ? "a fit or a figure" : "fits or figures"));
}

}  // namespace mpmstudy
