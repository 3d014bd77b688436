#include "runner/exec/run_search.hpp"

#include <algorithm>
#include <map>
#include <unordered_map>

#include "runner/catalog/query.hpp"
#include "runner/search/extrapolate.hpp"

namespace mpmstudy {
namespace {

struct State {
  std::string status, outcome;
  double margin = 0;  ///< distance from the other outcome; 0 if the run does not say
};

std::unordered_map<std::string, State> states_of(const std::filesystem::path& results,
                                                 const std::string& study) {
  std::unordered_map<std::string, State> states;
  const SqlValue name = study;
  const Rows rows =
      query(results,
            "SELECT j.key, j.status, coalesce(j.outcome, ''), coalesce(m.value, 0.0) FROM jobs j LEFT JOIN "
            "metrics m ON m.key = j.key AND m.name = 'decision_margin' WHERE j.study = ?1",
            std::span(&name, 1));
  for (const auto& row : rows.rows)
    states[std::get<std::string>(row[0])] = {std::get<std::string>(row[1]), std::get<std::string>(row[2]),
                                             std::get<double>(row[3])};
  return states;
}

Verdict verdict_of(const State& state, const std::string& wanted) {
  if (state.status != "done") return Verdict::broken;
  if (state.outcome == wanted) return Verdict::above;
  return state.outcome == "undecided" ? Verdict::undecided : Verdict::below;
}

void add(RunReport& sum, const RunReport& round) {
  sum.executed.done += round.executed.done;
  sum.executed.failed += round.executed.failed;
  sum.executed.updates += round.executed.updates;
  sum.executed.cpu_s += round.executed.cpu_s;
  sum.signal = round.signal;
}

/// Rows of the catalog; what is extrapolated stands on the finest cell of each ladder.
std::vector<CriticalSpeedRow> rows_of(const std::vector<FoundBracket>& brackets) {
  std::map<std::pair<std::size_t, double>, std::vector<CellBracket>> ladders;  // coarse cells come first
  for (const FoundBracket& b : brackets)
    if (b.lower) ladders[{b.point.family, b.point.along}].push_back({b.point.cell, *b.lower, *b.upper});
  std::vector<CriticalSpeedRow> rows;
  for (const FoundBracket& b : brackets) {
    if (!b.lower) continue;
    CriticalSpeedRow row;
    const mpm::Quantity* wall = mpm::find_quantity("wall_thickness");
    if (wall->belongs_to(b.point.scene.kind)) row.wall_thickness = wall->get(b.point.scene);
    row.lower = *b.lower;
    row.upper = *b.upper;
    row.lower_key = b.lower_key;
    row.upper_key = b.upper_key;
    row.cell_size = b.point.cell;
    row.flags = b.flags;
    row.runs = b.runs;
    row.position = static_cast<std::int64_t>(b.point.position);
    const auto& ladder = ladders[{b.point.family, b.point.along}];
    if (ladder.back().cell == b.point.cell)
      if (const auto extrapolated = extrapolate(ladder)) {
        row.extrapolated = extrapolated->value;
        row.interval = extrapolated->interval;
      }
    rows.push_back(std::move(row));
  }
  return rows;
}

/// Whether a run is in the sample: by its key, so that it is the same ones every time.
bool sampled(const std::string& key, double share) {
  return static_cast<double>(std::stoul(key.substr(0, 8), nullptr, 16)) < share * 4294967296.0;
}

class SearchRun {
 public:
  SearchRun(const Study& study, const SearchOptions& options, CatalogWriter& writer,
            const std::filesystem::path& results, const RunRound& run_round)
      : study_(study), options_(options), writer_(writer), results_(results), run_round_(run_round) {}

  SearchReport run() {
    Search search(study_);
    Study all = study_;
    all.scenes.clear();
    for (auto scenes = search.next_round(); !scenes.empty(); scenes = search.next_round()) {
      all.scenes.insert(all.scenes.end(), scenes.begin(), scenes.end());
      if (!round(all)) return std::move(report_);
      const auto states = states_of(results_, all.name);
      for (const mpm::Scene& scene : scenes) {
        const std::string key = job_key(scene);
        const State& state = states.at(key);
        search.tell(key, verdict_of(state, study_.search->outcome), state.margin);
      }
    }
    report_.brackets = search.brackets();
    writer_.replace_critical_speeds(study_.name, rows_of(report_.brackets));
    if (options_.audit > 0) audit(all);
    return std::move(report_);
  }

 private:
  /// False if the run was stopped.
  bool round(const Study& study) {
    const PlannedStudy planned{make_plan(study, options_.cost), study.title, options_.source};
    const RunReport one = run_round_(planned);
    add(report_.run, one);
    if (one.left() > 0) {
      report_.run.executed.untouched = one.left();
      report_.run.executed.storage_error = one.executed.storage_error;
    }
    return one.left() == 0;
  }

  void audit(const Study& all) {
    Study whole = all;
    whole.name += "-audit";
    whole.title += ", runs that stopped early run to their end";
    whole.scenes.clear();
    const auto said = states_of(results_, all.name);
    std::vector<std::string> early;
    for (const mpm::Scene& scene : all.scenes) {
      if (scene.measures.stop != mpm::Stop::decided) continue;
      const std::string key = job_key(scene);
      if (said.at(key).status != "done") continue;  // a run that broke down said nothing
      ++report_.audit.early;
      if (!sampled(key, options_.audit)) continue;
      early.push_back(key);
      whole.scenes.push_back(scene);
      whole.scenes.back().measures.stop = mpm::Stop::end_time;
    }
    if (whole.scenes.empty() || !round(whole)) return;
    const auto says = states_of(results_, whole.name);
    for (std::size_t i = 0; i < early.size(); ++i) {
      ++report_.audit.audited;
      const State &a = said.at(early[i]), &b = says.at(job_key(whole.scenes[i]));
      if ((a.outcome == study_.search->outcome) != (b.outcome == study_.search->outcome))
        report_.audit.disagreeing.push_back(early[i]);
    }
  }

  const Study& study_;
  const SearchOptions& options_;
  CatalogWriter& writer_;
  const std::filesystem::path& results_;
  const RunRound& run_round_;
  SearchReport report_;
};

}  // namespace

SearchReport run_search(const Study& study, const SearchOptions& options, CatalogWriter& writer,
                        const std::filesystem::path& results, const RunRound& run_round) {
  return SearchRun(study, options, writer, results, run_round).run();
}

SearchReport run_search(const Study& study, const SearchOptions& options, CatalogWriter& writer,
                        Status& status, const Simulate& simulate, const WriteSnapshot& write, StopFlag& flag,
                        const ExecutorOptions& executor) {
  const RunRound here = [&](const PlannedStudy& planned) {
    return run_studies(std::span(&planned, 1), options.retry_failed, writer, status, simulate, write, flag,
                       executor);
  };
  return run_search(study, options, writer, executor.results, here);
}

std::vector<mpm::Scene> possible_scenes(const Study& study) {
  const SearchRequest& request = *study.search;
  Lattice lattice(request.lower, request.upper, request.tolerance);
  lattice.intervals *= 2;  // half steps: where runs failed
  const mpm::Quantity* critical = mpm::find_quantity(request.critical);
  std::vector<mpm::Scene> scenes;
  for (mpm::Scene scene : study.scenes)
    for (int i = 0; i <= lattice.intervals; ++i) {
      critical->set(scene, lattice.value(i));
      scenes.push_back(scene);
      if (scene.measures.stop != mpm::Stop::decided) continue;
      scenes.push_back(scene);  // as an audit runs it
      scenes.back().measures.stop = mpm::Stop::end_time;
    }
  return scenes;
}

}  // namespace mpmstudy
