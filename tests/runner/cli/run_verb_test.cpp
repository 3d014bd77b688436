// The verb `run` on a real study file, with a fake simulation behind it.
#include "runner/cli/run.hpp"

#include <gmock/gmock.h>

#include <csignal>
#include <fstream>

#include "runner/catalog/catalog_error.hpp"
#include "runner/catalog/query.hpp"
#include "runner/cli/amounts.hpp"
#include "tests/runner/fakes.hpp"

namespace mpmstudy {
namespace {

class RunVerb : public testing::Test {
 protected:
  RunVerb() {
    options.files = {SOURCE_DIR "/studies/examples/smoke.toml"};
    options.results = (folder.path() / "results").string();
    seams.simulate = [this](const mpm::Scene& s, mpm::Observer& o) {
      ++simulated;
      return fakes::simulate(s, o);
    };
    seams.write_snapshot = fakes::write_snapshot;
    seams.finish_study = [this](const Study& study, const std::filesystem::path& results,
                                CatalogWriter& writer) {
      finished.push_back(study.name);
      const auto rows = query(results, "SELECT count(*) FROM jobs WHERE status = 'done'").rows;
      done_when_finished = std::get<std::int64_t>(rows[0][0]);
      writer.replace_fits(study.name, {{"collapsibility", "cavity_radius", "linear", "c0", 1, {}, {}, "1"}});
      if (bad_figure) throw std::runtime_error("gnuplot is not there");
    };
  }
  int run() {
    testing::internal::CaptureStdout();
    testing::internal::CaptureStderr();
    struct Capture {
      std::string& text;
      ~Capture() { text = testing::internal::GetCapturedStdout() + testing::internal::GetCapturedStderr(); }
    } capture{output};
    return run_run(options, seams);
  }

  fakes::TemporaryFolder folder;
  RunOptions options;
  RunSeams seams;
  std::atomic<int> simulated = 0;
  std::vector<std::string> finished;
  std::int64_t done_when_finished = 0;
  bool bad_figure = false;
  std::string output;
};

TEST_F(RunVerb, runs_and_finishes) {
  EXPECT_EQ(run(), exit_ok);
  EXPECT_EQ(simulated, 2);
  EXPECT_EQ(finished, std::vector<std::string>{"smoke"});
  EXPECT_EQ(done_when_finished, 2);
  EXPECT_EQ(query(options.results, "SELECT * FROM fits").rows.size(), 1u);
  EXPECT_THAT(output, testing::HasSubstr("2 done, 0 failed, 0 reused, 0 left"));
  EXPECT_THAT(output, testing::HasSubstr("cavity_radius = 1 um"));
  EXPECT_THAT(output, testing::HasSubstr("catalog.db"));
  EXPECT_EQ(run(), exit_ok);
  EXPECT_EQ(simulated, 2);
  EXPECT_THAT(output, testing::HasSubstr("0 done, 0 failed, 2 reused, 0 left"));
}

TEST_F(RunVerb, set_changes_the_jobs) {
  run();
  options.study.set = {"impact_speed=300 m/s"};
  EXPECT_EQ(run(), exit_ok);
  EXPECT_EQ(simulated, 4);
}

TEST_F(RunVerb, a_dry_run_writes_nothing) {
  options.dry_run = true;
  EXPECT_EQ(run(), exit_ok);
  EXPECT_FALSE(std::filesystem::exists(options.results));
  EXPECT_THAT(output, testing::HasSubstr("2 jobs would run"));
  options.dry_run = false;
  run();
  options.dry_run = true;
  run();
  EXPECT_THAT(output, testing::HasSubstr("0 jobs would run"));
  EXPECT_THAT(output, testing::HasSubstr("2 done"));
}

TEST_F(RunVerb, failures_end_with_1) {
  seams.simulate = [](const mpm::Scene&, mpm::Observer&) -> mpm::RunResult {
    throw std::runtime_error("step 3: J < 0");
  };
  EXPECT_EQ(run(), exit_failed);
  EXPECT_THAT(output, testing::HasSubstr("FAILED: step 3: J < 0"));
  EXPECT_EQ(finished.size(), 1u);
}

TEST_F(RunVerb, what_cannot_be_finished_ends_with_1) {
  bad_figure = true;
  EXPECT_EQ(run(), exit_failed);
  EXPECT_THAT(output, testing::HasSubstr("smoke: gnuplot is not there"));
}

TEST_F(RunVerb, stops_do_not_finish_the_study) {
  seams.simulate = [](const mpm::Scene& s, mpm::Observer& o) {
    std::raise(SIGINT);
    return fakes::simulate(s, o);
  };
  options.workers = 1;
  EXPECT_EQ(run(), exit_interrupted);
  EXPECT_TRUE(finished.empty());
}

TEST_F(RunVerb, a_disk_that_refuses_ends_with_75) {
  seams.write_snapshot = [](const std::filesystem::path&, const mpm::Snapshot&) {
    throw std::runtime_error("No space left on device");
  };
  EXPECT_EQ(run(), exit_stopped);
  EXPECT_THAT(output, testing::HasSubstr("stopped: No space left on device; run again to go on"));
}

TEST_F(RunVerb, limits_and_retries_reach_the_jobs) {
  std::atomic<int> failures = 1;
  seams.simulate = [&](const mpm::Scene& s, mpm::Observer& o) {
    if (failures-- > 0) throw std::runtime_error("unlucky");
    return fakes::simulate(s, o);
  };
  options.retries = 1;
  EXPECT_EQ(run(), exit_ok);
  EXPECT_THAT(output, testing::HasSubstr("retry 1 of 1: unlucky"));
  options.study.set = {"impact_speed=300 m/s"};
  options.timeout = "1 ms";
  seams.simulate = [](const mpm::Scene& s, mpm::Observer& o) {
    return fakes::simulate(s, o, std::chrono::milliseconds(2));
  };
  EXPECT_EQ(run(), exit_failed);
  EXPECT_THAT(output, testing::HasSubstr("ran longer than 0.001 s (step"));
}

TEST_F(RunVerb, amounts_that_are_none_are_refused_before_anything_is_written) {
  for (const char* bad : {"-1 s", "3 m", "soon", "0 s"}) {
    options.timeout = bad;
    EXPECT_THROW(run(), StudyError) << bad;
  }
  options.timeout.clear();
  for (const char* bad : {"-1 GB", "2 gb", "much", "1e30 TB"}) {
    options.memory = bad;
    EXPECT_THROW(run(), StudyError) << bad;
  }
  EXPECT_FALSE(std::filesystem::exists(options.results));
  EXPECT_EQ(read_duration("--budget", "1.5 h"), 5400);
  EXPECT_EQ(read_duration("--budget", "2h"), 7200);
  EXPECT_EQ(read_duration("--budget", "90"), 90);
  EXPECT_EQ(read_bytes("--memory", "1.5 GiB"), 1610612736u);
  EXPECT_EQ(read_bytes("--memory", "500MB"), 500000000u);
}

/// Of some jobs only, by a file of keys.
class Only : public RunVerb {
 protected:
  Only() {
    options.files = {SOURCE_DIR "/studies/examples/smoke.toml"};
    const Study study = read_study(options.files[0], options.study);
    for (const auto& job : make_plan(study).jobs) keys.push_back(job.key);
  }
  void choose(const std::vector<std::string>& some) {
    options.only = (folder.path() / "keys.txt").string();
    std::ofstream file(options.only);
    for (const auto& key : some) file << key << "\n";
  }
  std::size_t count(const std::string& where) {
    return query(options.results, "SELECT key FROM jobs WHERE study = 'smoke' AND " + where).rows.size();
  }
  std::vector<std::string> keys;
};

TEST_F(Only, all_jobs_are_registered_and_the_chosen_ones_run) {
  choose({keys[0]});
  EXPECT_EQ(run(), exit_ok);
  EXPECT_EQ(simulated, 1);
  EXPECT_EQ(count("status = 'done' AND key = '" + keys[0] + "'"), 1u);
  EXPECT_EQ(count("status = 'planned'"), 1u);
  EXPECT_THAT(output, testing::HasSubstr("1 done, 0 failed, 0 reused, 0 left"));
  EXPECT_TRUE(finished.empty());
  EXPECT_EQ(run(), exit_ok);
  EXPECT_EQ(count("status = 'planned'"), 1u) << "what others have planned stays planned";
}

TEST_F(Only, nothing_leaves_the_study) {
  run();
  choose({keys[1]});
  EXPECT_EQ(run(), exit_ok);
  EXPECT_EQ(simulated, 2);
  EXPECT_EQ(count("status = 'done'"), 2u);
}

TEST_F(Only, failed_jobs_that_are_not_chosen_stay_failed) {
  const auto simulate = seams.simulate;
  seams.simulate = [](const mpm::Scene&, mpm::Observer&) -> mpm::RunResult { throw std::runtime_error("x"); };
  run();
  seams.simulate = simulate;
  options.retry_failed = true;
  choose({keys[0]});
  EXPECT_EQ(run(), exit_ok);
  EXPECT_EQ(count("status = 'failed'"), 1u);
  EXPECT_EQ(simulated, 1);
}

TEST_F(Only, keys_that_no_study_has_are_named) {
  const std::string strange(32, 'e');
  choose({keys[0], strange});
  try {
    run();
    FAIL();
  } catch (const StudyError& error) {
    EXPECT_THAT(error.what(), testing::HasSubstr(options.only + ":2: " + strange));
    EXPECT_THAT(error.what(), testing::Not(testing::HasSubstr(keys[0])));
  }
  choose({});
  EXPECT_THROW(run(), StudyError);
  EXPECT_FALSE(std::filesystem::exists(options.results));
}

TEST_F(Only, a_dry_run_lists_the_chosen_ones) {
  choose({keys[0]});
  options.dry_run = true;
  EXPECT_EQ(run(), exit_ok);
  EXPECT_THAT(output, testing::HasSubstr("1 job would run"));
}

TEST_F(RunVerb, two_studies_need_two_names) {
  options.files.push_back(options.files[0]);
  EXPECT_THROW(run(), StudyError);
  EXPECT_FALSE(std::filesystem::exists(options.results));
}

TEST_F(RunVerb, a_bad_study_among_good_ones_writes_nothing) {
  options.files.push_back((folder.path() / "none.toml").string());
  EXPECT_THROW(run(), StudyError);
  EXPECT_FALSE(std::filesystem::exists(options.results));
}

}  // namespace
}  // namespace mpmstudy
