#pragma once
/// Searches for a made-up material whose critical speed is known.
#include <gmock/gmock.h>

#include <csignal>
#include <functional>
#include <mutex>
#include <set>
#include <sstream>
#include <string>
#include <vector>

#include "runner/catalog/answers.hpp"
#include "runner/catalog/query.hpp"
#include "runner/catalog/row_format.hpp"
#include "runner/exec/run_studies.hpp"
#include "runner/search/forecast.hpp"
#include "tests/runner/fakes.hpp"
#include "tests/runner/study/study_text.hpp"

namespace mpmstudy {

inline constexpr const char* search_text = R"(schema = 1
name = "critical"
scene = "cavity-impact"
[parameters]
material = "aluminium"
block_width = "10 um"
block_height = "11 um"
cavity_radius = "1.5 um"
wall_thickness = { values = [0.5, 1, 2, 3, 4], unit = "um" }
end_time = "16 ns"
[numerics]
cell_size = { values = [0.4, 0.2, 0.1], unit = "um" }
[search]
critical = "impact_speed"
outcome = "ejected"
between = ["100 m/s", "2100 m/s"]
tolerance = "10 m/s"
)";

/// What the made-up material does: a parabola in d, first order in the cell.
inline double critical_speed(const mpm::Scene& s) {
  const double d = (s.block_height - s.cavity_center_height - s.cavity_radius) * 1e6;
  return 203 + 250 * d + 30 * d * d + 400 * s.numerics.cell_size * 1e6;
}

/// Of a run of one search.
struct SearchOutcome {
  RunReport run;
  std::vector<FoundBracket> brackets;
  Audit audit;
  int exit_code() const { return run.exit_code(); }
  std::int64_t not_found() const { return SearchReport{brackets, audit}.not_found(); }
};

class SearchStudy : public testing::Test {
 protected:
  SearchOutcome search(const std::filesystem::path& results, unsigned workers, double audit = 0,
                       ExecutorOptions executor = {}) {
    const Study study = read_text(study_text);
    executor.results = results;
    executor.workers = workers;
    CatalogWriter writer(results);
    Status status;
    const Simulate simulate = [this](const mpm::Scene& s, mpm::Observer& o) {
      {
        std::lock_guard lock(mutex);
        EXPECT_TRUE(simulated.insert(job_key(s)).second) << "run twice";
        cells.push_back(s.numerics.cell_size);
        if (static_cast<int>(simulated.size()) == stop_at) flag.ask(SIGTERM);
      }
      mpm::RunResult r = fakes::simulate(s, o);
      if (breaks && breaks(s)) {
        r.status = mpm::RunStatus::failed;
        r.reason = "made to fail";
        return r;
      }
      const bool whole = s.measures.stop == mpm::Stop::end_time;
      r.outcome = s.impact_speed > critical_speed(s) || (whole && late) ? "ejected" : "arrested";
      if (outcome) r.outcome = outcome(s);
      return r;
    };
    const PlannedStudy planned{{study.name, {}, {}, {}, 1e6}, study.title, {}, {}, study, audit};
    const RunReport run = run_studies(std::span(&planned, 1), retry_failed, writer, status, simulate,
                                      fakes::write_snapshot, flag, executor);
    if (!run.searches.contains(study.name)) return {run, {}, {}};
    const SearchReport& found = run.searches.at(study.name);
    return {run, found.brackets, found.audit};
  }
  SearchForecast forecast(const Study& study) {
    const CatalogAnswers known(folder.path());
    return forecast_search(study, &known);
  }
  std::string rows(const std::filesystem::path& results) {
    std::ostringstream out;
    query(results, "SELECT * FROM critical_speed ORDER BY position", *make_row_sink(RowFormat::csv, out));
    return out.str();
  }
  fakes::TemporaryFolder folder;
  StopFlag flag;
  std::mutex mutex;
  std::set<std::string> simulated;
  std::vector<double> cells;  ///< of the runs, in the order of their starts
  int stop_at = -1;
  std::function<bool(const mpm::Scene&)> breaks;          ///< which runs fail
  std::function<std::string(const mpm::Scene&)> outcome;  ///< in place of that of the made-up material
  std::string study_text = search_text;
  bool retry_failed = false;
  bool late = false;  ///< runs to the end say "ejected" whatever the speed
};

}  // namespace mpmstudy
