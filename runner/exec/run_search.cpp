#include "runner/exec/run_search.hpp"

#include <algorithm>
#include <chrono>
#include <map>
#include <nlohmann/json.hpp>
#include <unordered_map>

#include "runner/catalog/connection.hpp"
#include "runner/catalog/query.hpp"
#include "runner/search/extrapolate.hpp"
#include "runner/study/decimal.hpp"

namespace mpmstudy {
namespace {

struct State {
  std::string status, outcome;
  double margin = 0;  ///< distance from the other outcome; 0 if the run does not say
};

std::unordered_map<std::string, State> states_of(const Rows& rows) {
  std::unordered_map<std::string, State> states;
  for (const auto& row : rows.rows)
    states[std::get<std::string>(row[0])] = {std::get<std::string>(row[1]), std::get<std::string>(row[2]),
                                             std::get<double>(row[3])};
  return states;
}

constexpr const char* select_states =
    "SELECT j.key, j.status, coalesce(j.outcome, ''), coalesce(m.value, 0.0) FROM jobs j LEFT JOIN metrics m "
    "ON m.key = j.key AND m.name = 'decision_margin' ";

std::unordered_map<std::string, State> states_of(const std::filesystem::path& results,
                                                 const std::string& study) {
  const SqlValue name = study;
  return states_of(query(results, std::string(select_states) + "WHERE j.study = ?1", std::span(&name, 1)));
}

/// Of whatever study: a run that another one has made is known, too.
std::unordered_map<std::string, State> states_of_all(const std::filesystem::path& results) {
  return states_of(query(results, std::string(select_states) + "WHERE j.status IN ('done', 'failed')"));
}

Verdict verdict_of(const State& state, const std::string& wanted) {
  if (state.status != "done") return Verdict::broken;
  if (state.outcome == wanted) return Verdict::above;
  return state.outcome == "undecided" ? Verdict::undecided : Verdict::below;
}

/// JSON object: column of the view `jobs` -> value, of what the study sweeps beside its cells.
std::string swept_values(const Study& study, const mpm::Scene& scene) {
  nlohmann::ordered_json values = nlohmann::ordered_json::object();
  for (const std::string& name : study.swept) {
    if (name == "cell_size") continue;  // has a column of its own
    if (const mpm::Quantity* q = mpm::find_quantity(name))
      values[std::string(q->column)] = without_rounding(q->get(scene));
    else if (const mpm::Choice* c = mpm::find_choice(name))
      values[std::string(c->column)] = c->allowed[c->get(scene)];
  }
  return values.dump();
}

/// Rows of the catalog; what is extrapolated stands on the finest cell of each ladder. A point without a
/// bracket has a row, too: its ends are null and its flags say why.
std::vector<BracketRow> rows_of(const Study& study, const std::vector<FoundBracket>& brackets) {
  std::map<std::pair<std::size_t, double>, std::vector<CellBracket>> ladders;  // coarse cells come first
  for (const FoundBracket& b : brackets)
    if (b.lower) ladders[{b.point.family, b.point.along}].push_back({b.point.cell, *b.lower, *b.upper});
  const mpm::Quantity* critical = mpm::find_quantity(study.search->critical);
  const mpm::Quantity* wall = mpm::find_quantity("wall_thickness");
  std::vector<BracketRow> rows;
  for (const FoundBracket& b : brackets) {
    BracketRow row;
    row.quantity = critical->name;
    row.unit = critical->unit;
    row.lower = b.lower;
    row.upper = b.upper;
    row.lower_key = b.lower_key;
    row.upper_key = b.upper_key;
    row.cell_size = b.point.cell;
    row.flags = b.flags;
    row.runs = b.runs;
    row.position = static_cast<std::int64_t>(b.point.position);
    row.swept = swept_values(study, b.point.scene);
    if (wall != critical && wall->belongs_to(study.kind)) row.wall_thickness = wall->get(b.point.scene);
    const auto& ladder = ladders[{b.point.family, b.point.along}];
    if (b.lower && ladder.back().cell == b.point.cell)
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
      if (report_.run.signal != 0) {  // a round of jobs that are all done does not stop by itself
        report_.run.executed.untouched += static_cast<std::int64_t>(scenes.size());
        return std::move(report_);
      }
      all.scenes.insert(all.scenes.end(), scenes.begin(), scenes.end());
      if (!round(all, scenes)) return std::move(report_);
      const auto states = states_of(results_, all.name);
      for (const mpm::Scene& scene : scenes) {
        const std::string key = job_key(scene);
        const auto state = states.find(key);
        if (state == states.end()) {  // another run has registered the study anew meanwhile
          report_.run.executed.untouched += static_cast<std::int64_t>(scenes.size());
          return std::move(report_);
        }
        search.tell(key, verdict_of(state->second, study_.search->outcome), state->second.margin);
      }
    }
    report_.brackets = search.brackets();
    writer_.replace_brackets(study_.name, rows_of(study_, report_.brackets));
    count(all.name);
    if (options_.audit > 0) audit(all);
    return std::move(report_);
  }

 private:
  /// False if the run was stopped. Every round registers the jobs of those before, too, so what it finds
  /// decided is counted at the end. Failed jobs are tried again in the round that asks for them, `scenes`,
  /// and not in every round after it.
  bool round(const Study& study, const std::vector<mpm::Scene>& scenes) {
    PlannedStudy planned{make_plan(study, options_.cost), study.title, options_.source, {}};
    if (options_.retry_failed) {
      planned.selection.retry.emplace();
      for (const mpm::Scene& scene : scenes) planned.selection.retry->insert(job_key(scene));
    }
    RunReport one = run_round_(planned);
    one.reused = one.left_failed = 0;
    report_.run += one;
    return one.left() == 0;
  }

  /// Jobs of a study that were decided before this run.
  void count(const std::string& study) {
    const ExecutorReport& now = report_.run.executed;
    std::int64_t done = 0, failed = 0;
    for (const auto& [key, state] : states_of(results_, study)) {
      done += state.status == "done";
      failed += state.status == "failed";
    }
    report_.run.reused = std::max<std::int64_t>(0, done - now.done - now.done_elsewhere);
    report_.run.left_failed = std::max<std::int64_t>(0, failed - now.failed - now.failed_elsewhere);
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
    if (whole.scenes.empty() || !round(whole, whole.scenes)) return;
    const auto says = states_of(results_, whole.name);
    for (const auto& [key, state] : says) report_.run.left_failed += state.status == "failed";
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
  const auto begin = std::chrono::steady_clock::now();
  const RunRound here = [&](const PlannedStudy& planned) {
    ExecutorOptions rest = executor;  // the budget is that of all rounds
    const double spent = std::chrono::duration<double>(std::chrono::steady_clock::now() - begin).count();
    if (executor.budget_s > 0) rest.budget_s = std::max(1e-9, executor.budget_s - spent);
    return run_studies(std::span(&planned, 1), options.retry_failed, writer, status, simulate, write, flag,
                       rest);
  };
  return run_search(study, options, writer, executor.results, here);
}

std::int64_t SearchReport::not_found() const {
  return std::ranges::count_if(brackets, [](const FoundBracket& b) { return !b.lower; });
}

int SearchReport::exit_code() const {
  const int code = run.exit_code();
  return code == 0 && not_found() > 0 ? 1 : code;
}

SearchForecast forecast_search(const Study& study, const std::filesystem::path& results, bool retry_failed) {
  std::unordered_map<std::string, State> states;
  if (has_catalog(results)) states = states_of_all(results);
  return forecast_search(study, [&](const std::string& key) -> std::optional<Verdict> {
    const auto found = states.find(key);
    if (found == states.end()) return std::nullopt;
    const State& state = found->second;
    if (state.status == "done" || (state.status == "failed" && !retry_failed))
      return verdict_of(state, study.search->outcome);
    return std::nullopt;
  });
}

std::vector<mpm::Scene> possible_scenes(const Study& study,
                                        const std::function<bool(const std::string& key)>& wanted) {
  const SearchRequest& request = *study.search;
  Lattice lattice(request.lower, request.upper, request.tolerance);
  lattice.intervals *= 2;  // half steps: where runs failed
  const Searched critical(study);
  std::vector<mpm::Scene> scenes;
  const auto add = [&](const mpm::Scene& scene) {
    if (wanted(job_key(scene))) scenes.push_back(scene);
  };
  for (mpm::Scene scene : study.scenes)
    for (int i = 0; i <= lattice.intervals; ++i) {
      critical.set(scene, lattice.value(i));
      add(scene);
      if (scene.measures.stop != mpm::Stop::decided) continue;
      mpm::Scene whole = scene;  // as an audit runs it
      whole.measures.stop = mpm::Stop::end_time;
      add(whole);
    }
  return scenes;
}

}  // namespace mpmstudy
