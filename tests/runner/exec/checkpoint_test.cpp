// Long jobs go on from where they were killed or stopped, and end with the bits of those that nobody
// disturbed.
#include <gmock/gmock.h>
#include <sys/wait.h>
#include <unistd.h>

#include <atomic>
#include <csignal>

#include "libmpm/io/vtkhdf.hpp"
#include "runner/catalog/query.hpp"
#include "runner/exec/run_studies.hpp"
#include "tests/runner/fakes.hpp"
#include "tests/runner/rows_of.hpp"
#include "tests/runner/study/study_text.hpp"

namespace mpmstudy {
namespace {

namespace fs = std::filesystem;

constexpr double often = 0.01;  ///< processor time between checkpoints: a few dozen over a job [s]

const std::string text =
    study_text({{"cavity_radius", "[\"1.5 um\", \"2 um\"]"}, {"end_time", "\"4 ns\""}},
               "[numerics]\ncell_size = \"0.25 um\"\n[measure]\nsnapshots = [\"0.2 ns\", \"3 ns\"]\n");

/// Counts the steps that are taken, and does something after one of them.
class Counter {
 public:
  std::function<void()> after;
  std::int64_t at = -1;
  std::atomic<std::int64_t> steps{0};

  mpm::RunResult operator()(const mpm::Scene& scene, mpm::Observer& observer) {
    struct Between : mpm::Observer {
      Between(mpm::Observer& other, Counter& counter) : to(other), all(counter) {}
      bool on_step(const mpm::Progress& p) override {
        const bool go_on = to.on_step(p);
        if (++all.steps == all.at) all.after();
        return go_on;
      }
      void on_area(const mpm::AreaSample& a) override { to.on_area(a); }
      void on_snapshot(const mpm::Snapshot& s) override { to.on_snapshot(s); }
      mpm::Record* resume_from() override { return to.resume_from(); }
      bool wants_checkpoint() override { return to.wants_checkpoint(); }
      void on_checkpoint(const mpm::Record& r) override { to.on_checkpoint(r); }
      mpm::Observer& to;
      Counter& all;
    } between(observer, *this);
    return mpm::run(scene, between);
  }
};

class LongJobs : public testing::Test {
 protected:
  RunReport run(const fs::path& results, Counter& counter, double checkpoint_s, std::uint64_t memory = 0) {
    const Study study = read_text(text);
    const PlannedStudy planned{make_plan(study), study.title, {}};
    CatalogWriter writer(results);
    Status status;
    ExecutorOptions options;
    options.results = results;
    options.workers = 1;
    options.checkpoint_s = checkpoint_s;
    options.limits.memory = memory;
    const Simulate simulate = std::ref(counter);
    return run_studies(std::span(&planned, 1), false, writer, status, simulate, mpm::write_vtkhdf, flag,
                       options);
  }
  std::int64_t undisturbed() {
    Counter counter;
    EXPECT_EQ(run(calm, counter, 0).executed.done, 2);
    return counter.steps;
  }
  /// Asked to stop after a quarter of all steps.
  RunReport interrupted(std::int64_t all, double checkpoint_s = often) {
    Counter counter;
    counter.at = all / 4;
    counter.after = [&] { flag.ask(SIGTERM); };
    RunReport report = run(results, counter, checkpoint_s);
    flag.clear();
    return report;
  }
  /// Begins all steps anew, and ends as if nothing had been.
  void expect_begun_anew(std::int64_t all) {
    Counter counter;
    EXPECT_EQ(run(results, counter, often).left(), 0);
    EXPECT_EQ(counter.steps, all);
    expect_same_end(results);
  }
  void expect_same_end(const fs::path& results) {
    EXPECT_EQ(rows_of(results), rows_of(calm));
    for (const auto& entry : fs::recursive_directory_iterator(results / "fields"))
      EXPECT_NE(entry.path().extension(), ".h5") << "no checkpoint stays";
  }
  bool has_checkpoint(const fs::path& results) {
    std::error_code none;
    for (const auto& entry : fs::recursive_directory_iterator(results / "fields", none))
      if (entry.path().filename() == "checkpoint.h5") return true;
    return false;
  }

  fakes::TemporaryFolder folder;
  const fs::path calm = folder.path() / "calm", results = folder.path() / "results";
  StopFlag flag;
};

TEST_F(LongJobs, go_on_after_a_kill) {
  const std::int64_t all = undisturbed();
  const pid_t child = fork();
  if (child == 0) {
    Counter counter;
    counter.at = 3 * all / 4;
    counter.after = [] { kill(getpid(), SIGKILL); };
    run(results, counter, often);
    _exit(0);
  }
  int end = 0;
  waitpid(child, &end, 0);
  ASSERT_TRUE(WIFSIGNALED(end));
  ASSERT_TRUE(has_checkpoint(results));
  // What its process died of is run in a process of its own; there no counter sees it.
  Counter counter;
  EXPECT_EQ(run(results, counter, often).left(), 0);
  expect_same_end(results);
  const auto spent = query(results, "SELECT min(cpu_s) FROM jobs");
  EXPECT_GT(std::get<double>(spent.rows[0][0]), 0);
}

TEST_F(LongJobs, go_on_after_a_stop) {
  const std::int64_t all = undisturbed();
  EXPECT_EQ(interrupted(all).left(), 2);
  ASSERT_TRUE(has_checkpoint(results));
  Counter second;
  EXPECT_EQ(run(results, second, often).left(), 0);
  EXPECT_LT(second.steps, all) << "begun anew";
  expect_same_end(results);
}

TEST_F(LongJobs, begin_anew_when_a_file_of_theirs_is_gone) {
  const std::int64_t all = undisturbed();
  interrupted(all);
  int removed = 0;
  for (const auto& entry : fs::recursive_directory_iterator(results / "fields"))
    if (entry.path().extension() == ".vtkhdf") removed += fs::remove(entry.path());
  ASSERT_EQ(removed, 1);
  expect_begun_anew(all);
}

TEST_F(LongJobs, begin_anew_when_the_checkpoint_is_damaged) {
  const std::int64_t all = undisturbed();
  interrupted(all);
  for (const auto& entry : fs::recursive_directory_iterator(results / "fields"))
    if (entry.path().filename() == "checkpoint.h5") fs::resize_file(entry.path(), 1000);
  expect_begun_anew(all);
}

TEST_F(LongJobs, keep_nothing_when_told_so) {
  const std::int64_t all = undisturbed();
  interrupted(all, 0);
  EXPECT_FALSE(has_checkpoint(results));
}

}  // namespace
}  // namespace mpmstudy
