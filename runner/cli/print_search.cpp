#include "runner/cli/print_search.hpp"

#include <fmt/format.h>

#include "libmpm/scene/parameters.hpp"
#include "runner/status/label.hpp"
#include "runner/study/readable.hpp"
#include "runner/study/searched.hpp"

namespace mpmstudy {

std::string readable_forecast(const Study& study, const SearchForecast& forecast) {
  const SearchRequest& s = *study.search;
  const auto unit = mpm::find_quantity(s.critical)->unit;
  std::string text =
      fmt::format("search for the smallest {} with outcome {}, {} to {} in {} at {}: ", s.critical, s.outcome,
                  readable(s.lower, unit), readable(s.upper, unit),
                  counted(static_cast<std::int64_t>(search_steps(s.lower, s.upper, s.tolerance)), "step"),
                  counted(static_cast<std::int64_t>(study.scenes.size()), "point"));
  if (forecast.most == 0) return text + "all its runs are done";
  return text + fmt::format("about {} ({} to {}) in {}; which ones depends on what it finds",
                            counted(forecast.runs, "run"), forecast.fewest, forecast.most,
                            counted(static_cast<std::int64_t>(forecast.rounds.size()), "round"));
}

void print_search(const Study& study, const SearchReport& search) {
  const mpm::Quantity* critical = mpm::find_quantity(study.search->critical);
  for (const FoundBracket& b : search.brackets) {
    const std::string found =
        b.lower ? readable(*b.lower, critical->unit) + " to " + readable(*b.upper, critical->unit)
                : fmt::format("not found between {} and {}", readable(study.search->lower, critical->unit),
                              readable(study.search->upper, critical->unit));
    const std::string point = label_of(b.point.scene, study.swept);
    fmt::print("{}{}{} {}  ({}){}\n", point, point.empty() ? "" : "  ", critical->name, found,
               counted(b.runs, "run"), b.flags.empty() ? "" : "; " + b.flags);
  }
  const Audit& audit = search.audit;
  if (audit.audited == 0) return;
  fmt::print("audit: {} of {} early stops run to their end, {} of them false\n", audit.audited, audit.early,
             audit.disagreeing.size());
  for (const std::string& key : audit.disagreeing) fmt::print("  false stop: {}\n", short_key(key));
}

}  // namespace mpmstudy
