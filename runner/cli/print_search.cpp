#include "runner/cli/print_search.hpp"

#include <fmt/format.h>

#include "libmpm/scene/parameters.hpp"
#include "runner/status/label.hpp"

namespace mpmstudy {

void print_search(const Study& study, const SearchReport& search) {
  const mpm::Quantity* critical = mpm::find_quantity(study.search->critical);
  std::vector<std::string> swept = study.swept;
  for (const FoundBracket& b : search.brackets) {
    const std::string found =
        b.lower ? fmt::format("{:g} to {:g} {}", *b.lower, *b.upper, critical->unit) : "not found";
    fmt::print("{}  {} {}  ({} runs){}\n", label_of(b.point.scene, swept), critical->name, found, b.runs,
               b.flags.empty() ? "" : "; " + b.flags);
  }
  const Audit& audit = search.audit;
  if (audit.audited == 0) return;
  fmt::print("audit: {} of {} early stops run to their end, {} of them false\n", audit.audited, audit.early,
             audit.disagreeing.size());
  for (const std::string& key : audit.disagreeing) fmt::print("  false stop: {}\n", short_key(key));
}

}  // namespace mpmstudy
