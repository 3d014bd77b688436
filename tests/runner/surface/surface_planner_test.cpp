// The runs that a [surface] adds, for a made-up material whose collapse is known everywhere.
#include "runner/surface/surface_planner.hpp"

#include <gmock/gmock.h>

#include <cmath>
#include <functional>
#include <map>
#include <set>

#include "runner/surface/surface_state.hpp"
#include "tests/runner/study/study_text.hpp"

namespace mpmstudy {
namespace {

using testing::HasSubstr;
using testing::StartsWith;

std::string text(const std::string& sweep, const std::string& surface) {
  return study_text({{"impact_speed", "{ from = 100, to = 400, unit = \"m/s\" }"},
                     {"cavity_radius", "{ from = 0.5, to = 1.5, unit = \"um\" }"}},
                    "[sweep]\n" + sweep + "\n[surface]\nof = \"collapsibility\"\n" + surface);
}
const std::string sobol = "mode = \"sobol\"\nsamples = 12\nseed = 1";

/// Closed from a speed on: a plane with a bend.
double with_a_bend(const mpm::Scene& scene) {
  return std::min(1.0, 0.3 + (scene.impact_speed - 100) / 200 - 0.1 * scene.cavity_radius * 1e6);
}
/// Over four quantities: closed from a speed on that depends on the others.
double bent(const mpm::Scene& scene) {
  const double speed = (scene.impact_speed - 100) / 300, radius = scene.cavity_radius * 1e6 - 0.5,
               yield = (scene.material.yield_stress - 60e6) / 240e6, height = scene.block_height * 1e6 - 6;
  return std::min(1.0, 0.3 + speed * (1 - 0.5 * yield) - 0.2 * radius * radius + 0.1 * height);
}
double smooth(const mpm::Scene& scene) {
  return 0.3 + 0.4 * std::sin(scene.impact_speed / 150) * std::exp(-scene.cavity_radius * 1e6);
}

/// Decides jobs that it is told of.
class Oracle : public Answers {
 public:
  explicit Oracle(std::function<double(const mpm::Scene&)> value) : value_(std::move(value)) {}
  void decide(const Job& job, bool done = true) {
    answers_[job.key] = {done, done ? "partial" : "", 0};
    if (done) readings_[job.key] = {value_(job.scene), 0};
  }
  void flag(const Job& job) { flags_[job.key] = "cavity open to the outside"; }
  std::optional<Answer> of(const std::string& key) const override {
    const auto found = answers_.find(key);
    return found == answers_.end() ? std::nullopt : std::optional(found->second);
  }
  std::optional<Reading> reading(const std::string& key, const std::string&) const override {
    const auto found = readings_.find(key);
    return found == readings_.end() ? std::nullopt : std::optional(found->second);
  }
  std::string flags(const std::string& key) const override {
    const auto found = flags_.find(key);
    return found == flags_.end() ? "" : found->second;
  }

 private:
  std::function<double(const mpm::Scene&)> value_;
  std::map<std::string, Answer> answers_;
  std::map<std::string, Reading> readings_;
  std::map<std::string, std::string> flags_;
};

/// All rounds, each decided before the next is asked for.
std::vector<std::vector<Job>> rounds_of(const Study& study, Oracle& oracle) {
  SurfacePlanner planner(study, make_plan(study));
  std::vector<std::vector<Job>> rounds;
  for (auto jobs = planner.next(oracle); !jobs.empty(); jobs = planner.next(oracle)) {
    for (auto job = jobs.rbegin(); job != jobs.rend(); ++job) oracle.decide(*job);
    rounds.push_back(std::move(jobs));
  }
  return rounds;
}
std::vector<std::string> keys_of(const std::vector<std::vector<Job>>& rounds) {
  std::vector<std::string> keys;
  for (const auto& round : rounds)
    for (const Job& job : round) keys.push_back(job.key);
  return keys;
}

TEST(SurfacePlanner, BeginsWithTheDesignAndAddsBatchesUntilTheBudgetIsSpent) {
  const Study study = read_text(text(sobol, "tolerance = \"0.01 %\"\nbudget = 27\nbatch = 6"));
  Oracle oracle(with_a_bend);
  const auto rounds = rounds_of(study, oracle);
  ASSERT_EQ(rounds.size(), 4u);
  EXPECT_EQ(rounds[0].size(), 12u);
  EXPECT_EQ(rounds[1].size(), 6u);
  EXPECT_EQ(rounds[3].size(), 3u) << "27 in all";
  EXPECT_EQ(rounds[0][0].reason, "a point of the sweep");
  EXPECT_THAT(rounds[2][0].reason,
              StartsWith("round 2 of the surface, where a run tells it most: a run would be "
                         "within "));
  EXPECT_THAT(rounds[2][0].reason, HasSubstr(" of the places, wanted are 90 %"));
  const auto keys = keys_of(rounds);
  EXPECT_EQ(std::set(keys.begin(), keys.end()).size(), 27u) << "nothing twice";
}

TEST(SurfacePlanner, WaitsForAllOfARoundAndGoesOnWithTheSameRuns) {
  const Study study = read_text(text(sobol, "tolerance = \"0.01 %\"\nbudget = 24\nbatch = 4"));
  Oracle oracle(with_a_bend);
  const auto keys = keys_of(rounds_of(study, oracle));
  Oracle again(with_a_bend);
  SurfacePlanner planner(study, make_plan(study));
  const auto first = planner.next(again);
  for (std::size_t i = 0; i + 1 < first.size(); ++i) {
    again.decide(first[i]);
    EXPECT_TRUE(planner.next(again).empty()) << "waits";
  }
  again.decide(first.back());
  EXPECT_EQ(planner.next(again).front().key, keys[12]);
  // a run that was stopped: all answers are there already
  EXPECT_EQ(keys_of(rounds_of(study, oracle)), keys);
}

TEST(SurfacePlanner, EndsWhereTheToleranceHoldsAndItDoes) {
  const Study study = read_text(text(sobol, "tolerance = \"1 %\"\nbudget = 100"));
  Oracle oracle(smooth);
  const auto rounds = rounds_of(study, oracle);
  std::vector<SurfaceRun> runs;
  for (const auto& round : rounds)
    for (const Job& job : round) runs.push_back({&job.scene, smooth(job.scene), 0});
  EXPECT_LT(runs.size(), 60u);
  const SurfaceState state = surface_state(study, runs);
  ASSERT_TRUE(state.holds()) << readable_state(study, state);
  std::vector<const mpm::Scene*> scenes;
  for (const mpm::Scene& scene : study.surface->candidates) scenes.push_back(&scene);
  const Eigen::MatrixXd places = places_of(study, scenes);
  int within = 0;
  for (Eigen::Index i = 0; i < places.rows(); ++i)
    within += std::abs(state.process->at(places.row(i).transpose()).value -
                       smooth(*scenes[static_cast<std::size_t>(i)])) <= state.tolerance;
  EXPECT_GE(within, 0.9 * static_cast<double>(scenes.size()));
}

/// A surface of a few runs is sure of itself before it has seen how they scatter.
TEST(SurfacePlanner, BelievesNoToleranceBeforeTenRunsOfEachQuantity) {
  const Study study = read_text(text(sobol, "tolerance = \"40 %\"\nbudget = 100\nbatch = 4"));
  Oracle oracle(smooth);
  EXPECT_EQ(keys_of(rounds_of(study, oracle)).size(), 20u);
}

/// The same number of runs tells more where the planner put them than where the sequence goes on: root mean
/// square of the error over 1024 places, together of three designs.
TEST(SurfacePlanner, PutsRunsWhereTheyTellMost) {
  double added_errors = 0, sequence_errors = 0;
  for (const char* seed : {"1", "2", "3"}) {
    const Study study =
        read_text(study_text({{"impact_speed", "{ from = 100, to = 400, unit = \"m/s\" }"},
                              {"cavity_radius", "{ from = 0.5, to = 1.5, unit = \"um\" }"},
                              {"yield_stress", "{ from = 60, to = 300, unit = \"MPa\" }"},
                              {"block_height", "{ from = 6, to = 7, unit = \"um\" }"}},
                             std::string("[sweep]\nmode = \"sobol\"\nsamples = 24\nseed = ") + seed +
                                 "\n[surface]\nof = \"collapsibility\"\ntolerance = \"0.01 %\"\n"
                                 "budget = 80\n"));
    std::vector<const mpm::Scene*> all;
    for (const mpm::Scene& scene : study.surface->candidates) all.push_back(&scene);
    const Eigen::MatrixXd places = places_of(study, all);
    const auto error = [&](const std::vector<const mpm::Scene*>& scenes) {
      std::vector<SurfaceRun> runs;
      for (const mpm::Scene* scene : scenes) runs.push_back({scene, bent(*scene), 0});
      const SurfaceState state = surface_state(study, runs);
      double squares = 0;
      for (Eigen::Index i = 0; i < places.rows(); ++i)
        squares += std::pow(
            state.process->at(places.row(i).transpose()).value - bent(*all[static_cast<std::size_t>(i)]), 2);
      return std::sqrt(squares / static_cast<double>(places.rows()));
    };
    Oracle oracle(bent);
    const auto rounds = rounds_of(study, oracle);
    std::vector<const mpm::Scene*> added, sequence;
    for (const auto& round : rounds)
      for (const Job& job : round) added.push_back(&job.scene);
    for (std::size_t i = 0; i < added.size(); ++i) sequence.push_back(all[i]);
    added_errors += error(added);
    sequence_errors += error(sequence);
  }
  EXPECT_LT(added_errors, 0.9 * sequence_errors);
}

TEST(SurfacePlanner, LeavesOutWhatFailedOrHasNoMeaningAndCountsItsRuns) {
  const Study study = read_text(text(sobol, "tolerance = \"0.01 %\"\nbudget = 30"));
  Oracle oracle(with_a_bend);
  SurfacePlanner planner(study, make_plan(study));
  auto jobs = planner.next(oracle);
  for (std::size_t i = 0; i < jobs.size(); ++i) {
    oracle.decide(jobs[i], i != 3);
    if (i == 5) oracle.flag(jobs[i]);
  }
  std::size_t runs = jobs.size();
  for (jobs = planner.next(oracle); !jobs.empty(); jobs = planner.next(oracle)) {
    runs += jobs.size();
    for (const Job& job : jobs) oracle.decide(job);
  }
  EXPECT_EQ(runs, 30u);
  // where nothing shows the result there is no surface, and nothing is added
  Oracle broken(with_a_bend);
  SurfacePlanner lost(study, make_plan(study));
  for (const Job& job : lost.next(broken)) broken.decide(job, false);
  EXPECT_TRUE(lost.next(broken).empty());
}

/// A share of the range knows no scale: values in another unit, by a power of two, ask for the same runs.
TEST(SurfacePlanner, AsksForTheSameRunsAtAnotherScale) {
  const Study study = read_text(text(sobol, "tolerance = \"0.5 %\"\nbudget = 40"));
  Oracle one(with_a_bend), other([](const mpm::Scene&scene) { return 1024 * with_a_bend(scene); });
  EXPECT_EQ(keys_of(rounds_of(study, one)), keys_of(rounds_of(study, other)));
}

TEST(SurfaceRequest, IsReadWithItsPlaces) {
  const Study study = read_text(text(sobol, "tolerance = 0.02\nbudget = 40"));
  ASSERT_TRUE(study.surface);
  EXPECT_FALSE(study.surface->is_share);
  EXPECT_EQ(study.surface->tolerance, 0.02);
  EXPECT_EQ(study.surface->batch, 8);
  EXPECT_EQ(study.scenes.size(), 12u);
  EXPECT_EQ(study.surface->candidates.size(), 1024u);
  EXPECT_EQ(scene_text(study.surface->candidates[5]), scene_text(study.scenes[5])) << "the sequence goes on";
  EXPECT_EQ(make_plan(study).candidates.size(), 1012u);
  const Study hypercube = read_text(
      text("mode = \"latin-hypercube\"\nsamples = 12\nseed = 1", "tolerance = \"2 %\"\nbudget = 400"));
  EXPECT_TRUE(hypercube.surface->is_share);
  EXPECT_EQ(hypercube.surface->candidates.size(), 2048u);
  // jobs are those of the study without it
  EXPECT_EQ(job_key(study.scenes[0]),
            job_key(read_text(study_text({{"impact_speed", "{ from = 100, to = 400, unit = \"m/s\" }"},
                                          {"cavity_radius", "{ from = 0.5, to = 1.5, unit = \"um\" }"}},
                                         "[sweep]\n" + sobol))
                        .scenes[0]));
}

}  // namespace
}  // namespace mpmstudy
