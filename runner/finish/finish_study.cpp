#include "runner/finish/finish_study.hpp"

#include <fmt/format.h>

#include "runner/finish/figures.hpp"
#include "runner/finish/fits.hpp"
#include "runner/ladder/intervals.hpp"

namespace mpmstudy {

void finish_study(const Study& study, const std::filesystem::path& folder, CatalogWriter& writer) {
  writer.replace_intervals(study.name, intervals_of(study, folder));
  const StudyResults results = read_results(study, folder);
  Fits fits = fit_study(study, results);
  for (const std::string& problem : fits.problems)
    fmt::print(stderr, "{}: no fit, {}\n", study.name, problem);
  writer.replace_fits(study.name, std::move(fits.rows));
  for (const auto& path : draw_figures(study, results)) fmt::print("{}\n", path.string());
}

}  // namespace mpmstudy
