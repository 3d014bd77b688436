// The program as a user has it: exit codes, what it prints, signals, the same rows for any -j.
#include <SQLiteCpp/SQLiteCpp.h>
#include <gmock/gmock.h>

#include <chrono>
#include <csignal>
#include <fstream>
#include <nlohmann/json.hpp>

#include "runner/catalog/connection.hpp"
#include "runner/catalog/query.hpp"
#include "tests/runner/cli/program.hpp"
#include "tests/runner/rows_of.hpp"

namespace mpmstudy {
namespace {

namespace fs = std::filesystem;
using testing::HasSubstr;

TEST_F(Program, runs_asks_and_exports) {
  ASSERT_EQ(run({"run", smoke, "--results", results, "-j", "2"}), 0) << output;
  EXPECT_THAT(output, HasSubstr("M/s updates"));
  EXPECT_THAT(output, HasSubstr("2 done, 0 failed, 0 reused, 0 left"));
  ASSERT_EQ(run({"run", smoke, "--results", results, "-q"}), 0) << output;
  EXPECT_THAT(output, HasSubstr("2 reused"));

  EXPECT_EQ(run({"status", smoke, "--results", results}), 0) << output;
  EXPECT_EQ(run({"status", "smoke", "--json", "--results", results}), 0);
  EXPECT_EQ(nlohmann::json::parse(output)["studies"][0]["jobs"]["done"], 2);

  EXPECT_EQ(run({"query", "SELECT key, cavity_radius_m FROM jobs ORDER BY 2", "--format", "json", "--results",
                 results}),
            0);
  EXPECT_EQ(nlohmann::json::parse(output)[1]["cavity_radius_m"], 2e-6);
  EXPECT_EQ(run({"query", "SELECT 1 AS one, 'a,b' AS two", "--format", "csv", "--results", results}), 0);
  EXPECT_EQ(output, "one,two\r\n1,\"a,b\"\r\n");

  const auto exported = folder.path() / "exported";
  ASSERT_EQ(
      run({"export", "--what", "all", "--study", "smoke", "-o", exported.string(), "--results", results}), 0)
      << output;
  for (const char* name :
       {"jobs.csv", "metrics.csv", "area_history.csv", "fits.csv", "critical_speed.csv", "snapshots.csv"})
    EXPECT_GT(fs::file_size(exported / name), 0u) << name;
  ASSERT_EQ(run({"export", "--what", "area_history", "--format", "json", "--results", results}), 0);
  const auto rows = query(results, "SELECT area_m2 FROM area_history ORDER BY key, time_s").rows;
  const auto json = nlohmann::json::parse(output);
  ASSERT_EQ(json.size(), rows.size());
  for (std::size_t i = 0; i < rows.size(); ++i)  // bit for bit, through the text
    EXPECT_EQ(json[i]["area_m2"].get<double>(), std::get<double>(rows[i][0]));
}

TEST_F(Program, plan_says_what_is_done_already) {
  ASSERT_EQ(run({"run", smoke, "--results", results, "-q", "--set", "cavity_radius=1 um"}), 0) << output;
  ASSERT_EQ(run({"plan", smoke, "--results", results}), 0) << output;
  EXPECT_THAT(output, HasSubstr("1 of 2 done already in " + results));
  const auto json = [&] {
    return nlohmann::json::parse(output.substr(output.find('{')));
  };  // behind warnings
  ASSERT_EQ(run({"plan", smoke, "--json", "--results", results}), 0) << output;
  EXPECT_EQ(json()["done_already"], 1);
  // A value without an effect is no other job.
  ASSERT_EQ(run({"plan", smoke, "--json", "--results", results, "--set", "detached_for=2 ns"}), 0) << output;
  EXPECT_EQ(json()["done_already"], 1);
}

TEST_F(Program, a_study_of_another_file_is_named) {
  const auto other = folder.path() / "other.toml";
  fs::copy_file(smoke, other);
  ASSERT_EQ(run({"run", smoke, "--results", results, "-q"}), 0) << output;
  EXPECT_THAT(output, testing::Not(HasSubstr("the place of")));
  const std::string named = " the place of the study of this name that was run before from " + smoke;
  ASSERT_EQ(run({"run", "-n", other.string(), "--results", results, "-q"}), 0) << output;
  EXPECT_THAT(output, HasSubstr("smoke: would take" + named + "; `--set name=...` keeps both\n"));
  ASSERT_EQ(run({"run", other.string(), "--results", results, "-q", "--set", "cavity_radius=1.5 um"}), 0)
      << output;
  EXPECT_THAT(output, HasSubstr("smoke: takes" + named + ": "));
  EXPECT_EQ(output.find("the place of"), output.rfind("the place of")) << output;  // said once
  // The same file by another way is the same.
  const auto link = folder.path() / "link.toml";
  fs::create_symlink(other, link);
  ASSERT_EQ(run({"run", link.string(), "--results", results, "-q"}), 0) << output;
  EXPECT_THAT(output, testing::Not(HasSubstr("run before from")));
}

TEST_F(Program, any_number_of_workers_gives_the_same_rows) {
  std::string texts[2];
  for (const int workers : {1, 2}) {
    const auto here = results + std::to_string(workers);
    ASSERT_EQ(run({"run", smoke, "--results", here, "-j", std::to_string(workers)}), 0) << output;
    texts[workers - 1] = rows_of(here);
  }
  EXPECT_GT(texts[0].size(), 5000u);
  EXPECT_EQ(texts[0], texts[1]);
}

TEST_F(Program, what_cannot_be_used_ends_with_2_and_says_why) {
  std::ofstream(folder.path() / "file") << "x";
  EXPECT_EQ(run({"run", smoke, "--results", (folder.path() / "file").string()}), 2);
  EXPECT_THAT(output, HasSubstr("cannot be used as the results folder"));
  EXPECT_EQ(run({"query", "SELECT 1", "--results", results}), 2);
  EXPECT_THAT(output, HasSubstr("there is no catalog"));
  EXPECT_EQ(run({"export", "--what", "nonsense", "--results", results}), 2);
  EXPECT_EQ(run({"run", "--results", results}), 2);
  EXPECT_EQ(run({"run", smoke, "-j", "0", "--results", results}), 2);
  EXPECT_FALSE(fs::exists(results));
}

TEST_F(Program, a_newer_catalog_is_refused_with_2) {
  open_for_writing(results)->exec("PRAGMA user_version = 99");
  for (const Arguments& arguments :
       {Arguments{"run", smoke}, Arguments{"status"}, Arguments{"query", "SELECT 1"}, Arguments{"export"}}) {
    auto all = arguments;
    all.insert(all.end(), {"--results", results});
    EXPECT_EQ(run(all), 2) << arguments[0];
    EXPECT_THAT(output, HasSubstr("newer mpmstudy (catalog version 99"));
  }
}

TEST_F(Program, rows_that_are_lost_end_with_1) {
  open_for_writing(results);
  for (const char* verb : {"query 'SELECT 1'", "status", "export --what jobs"}) {
    const std::string command =
        std::string(PROGRAM " ") + verb + " --results " + results + " > /dev/full 2> " + log;
    EXPECT_EQ(WEXITSTATUS(std::system(command.c_str())), 1) << verb;
    std::ifstream file(log);
    std::stringstream text;
    text << file.rdbuf();
    EXPECT_THAT(text.str(), HasSubstr("standard output could not be written")) << verb;
  }
}

TEST_F(Program, jobs_that_no_study_has_are_listed_and_counted) {
  ASSERT_EQ(run({"run", smoke, "--results", results, "-q"}), 0) << output;
  {
    const auto db = open_for_writing(results);
    db->exec("UPDATE job SET status = 'failed', reason = 'broke' WHERE id = 1");
    db->exec("DELETE FROM study_job WHERE job_id = 1");
  }
  ASSERT_EQ(run({"status", "--results", results}), 0) << output;
  EXPECT_THAT(output, testing::ContainsRegex("smoke +0 +0 +1 +0 +0\n\\(no study\\) +0 +0 +0 +1 +0\n"));
  EXPECT_THAT(output, testing::ContainsRegex("failed\n  [0-9a-f]{12}  \\(no study\\)  broke"));
  ASSERT_EQ(run({"status", "--json", "--results", results}), 0) << output;
  const auto json = nlohmann::json::parse(output);
  EXPECT_EQ(json["no_study"]["failed"], 1);
  EXPECT_TRUE(json["failed"][0]["study"].is_null());
  // Of a study that is named, only its own jobs.
  ASSERT_EQ(run({"status", "smoke", "--results", results}), 0) << output;
  EXPECT_THAT(output, testing::Not(HasSubstr("no study")));
}

TEST_F(Program, set_name_keeps_the_jobs_of_both_runs) {
  const auto count = [&](const std::string& study) {
    return query(results, "SELECT key FROM jobs WHERE study = '" + study + "'").rows.size();
  };
  ASSERT_EQ(run({"run", smoke, "--results", results, "-q"}), 0) << output;
  ASSERT_EQ(run({"run", smoke, "--results", results, "-q", "--set", "impact_speed=300 m/s", "--set",
                 "name=faster", "--set", "title=Smoke, faster"}),
            0)
      << output;
  EXPECT_EQ(count("smoke"), 2u);
  EXPECT_EQ(count("faster"), 2u);
  EXPECT_EQ(
      std::get<std::string>(query(results, "SELECT title FROM studies WHERE name = 'faster'").rows[0][0]),
      "Smoke, faster");
}

TEST_F(Program, query_that_would_write_ends_with_2) {
  open_for_writing(results);
  for (const char* sql : {"DELETE FROM job", "ATTACH 'x.db' AS x", "SELECT load_extension('x')",
                          "PRAGMA user_version = 1", "SELECT 1; SELECT 2", "nonsense"})
    EXPECT_EQ(run({"query", sql, "--results", results}), 2) << sql;
}

TEST_F(Program, unknown_studies_end_with_2) {
  open_for_writing(results);
  EXPECT_EQ(run({"status", "nobody", "--results", results}), 2);
  EXPECT_THAT(output, HasSubstr("there is no study 'nobody'; known: none"));
  EXPECT_EQ(run({"export", "--study", "nobody", "--results", results}), 2);
}

class Stops : public Program {
 protected:
  /// Starts jobs that would last for minutes; returns once the catalog has such a row.
  pid_t start_long_run(const std::string& sql = "SELECT 1 FROM jobs WHERE status = 'running'") {
    const pid_t child = start({"run", smoke, "--results", results, "--set", "cell_size=0.02 um", "-j", "2"});
    for (int i = 0; i < 1000; ++i) {
      usleep(10'000);
      try {
        if (!query(results, sql).rows.empty()) break;
      } catch (const std::exception&) {  // not there yet
      }
    }
    return child;
  }
  std::size_t count(const std::string& where) {
    return query(results, "SELECT key FROM jobs WHERE " + where).rows.size();
  }
};

TEST_F(Stops, ctrl_c_ends_with_130_within_two_seconds) {
  const pid_t child = start_long_run();
  const auto asked = std::chrono::steady_clock::now();
  kill(child, SIGINT);
  EXPECT_EQ(wait_for(child), 130) << output;
  EXPECT_LT(std::chrono::steady_clock::now() - asked, std::chrono::seconds(2));
  EXPECT_EQ(count("status = 'planned'"), 2u);
  EXPECT_THAT(output, HasSubstr("stopped: interrupted; run again to go on"));
}

TEST_F(Stops, termination_ends_with_75) {
  const pid_t child = start_long_run();
  kill(child, SIGTERM);
  EXPECT_EQ(wait_for(child), 75) << output;
  EXPECT_EQ(count("status = 'planned'"), 2u);
}

TEST_F(Stops, every_signal_that_asks_for_an_end_ends_in_order_with_75) {
  for (const int number : {SIGHUP, SIGQUIT, SIGUSR1, SIGUSR2, SIGXCPU, SIGPWR}) {
    const pid_t child = start_long_run();
    kill(child, number);
    EXPECT_EQ(wait_for(child), 75) << output;
    EXPECT_THAT(output, HasSubstr(std::string("stopped: asked to end by SIG") + sigabbrev_np(number)));
    EXPECT_EQ(count("status = 'planned' AND crashes = 0"), 2u) << sigabbrev_np(number);
  }
}

TEST_F(Stops, one_wish_that_is_sent_twice_ends_in_order) {  // as timeout(1) and systemd do
  const pid_t child = start_long_run();
  for (const int number : {SIGTERM, SIGTERM, SIGHUP, SIGCONT}) kill(child, number);
  EXPECT_EQ(wait_for(child), 75) << output;
  EXPECT_EQ(count("status = 'planned' AND crashes = 0"), 2u);
}

TEST_F(Stops, a_hangup_does_not_end_what_was_started_with_nohup) {
  signal(SIGHUP, SIG_IGN);  // a child inherits it
  const pid_t child = start_long_run();
  signal(SIGHUP, SIG_DFL);
  kill(child, SIGHUP);
  usleep(300'000);
  EXPECT_EQ(waitpid(child, nullptr, WNOHANG), 0);
  kill(child, SIGTERM);
  EXPECT_EQ(wait_for(child), 75) << output;
}

TEST_F(Stops, a_run_that_is_stopped_and_goes_on_keeps_its_jobs) {
  const pid_t child = start_long_run();
  kill(child, SIGSTOP);
  usleep(100'000);
  ASSERT_EQ(run({"status", "--json", "--results", results}), 75);  // work is left
  EXPECT_THAT(output, HasSubstr("\"gone\": null"));
  kill(child, SIGCONT);
  kill(child, SIGINT);
  EXPECT_EQ(wait_for(child), 130) << output;
  EXPECT_EQ(count("status = 'planned' AND crashes = 0"), 2u);
}

TEST_F(Program, a_reader_that_goes_ends_the_printing_and_not_the_run) {
  const std::string command = std::string(PROGRAM " run -v ") + smoke + " --results " + results +
                              " -j 1 2> " + log + "; echo $? > " + log + ".code) | head -1 > /dev/null";
  ASSERT_EQ(std::system(("(" + command).c_str()), 0);
  int code = -1;
  std::ifstream(log + ".code") >> code;
  EXPECT_EQ(code, 0);
  std::stringstream said;
  said << std::ifstream(log).rdbuf();
  EXPECT_THAT(said.str(), HasSubstr("the reader of standard output has gone"));
  EXPECT_EQ(query(results, "SELECT key FROM jobs WHERE status = 'done' AND attempt = 1").rows.size(), 2u);
}

TEST_F(Stops, a_killed_run_is_taken_up) {
  const pid_t child = start_long_run();
  kill(child, SIGKILL);
  EXPECT_EQ(wait_for(child), 1000 + SIGKILL);
  EXPECT_GT(count("status = 'running'"), 0u);
  ASSERT_EQ(run({"status", "--results", results}), 75);
  EXPECT_THAT(output, HasSubstr("attempt 1: its process has gone"));
  EXPECT_THAT(output, HasSubstr("`mpmstudy run` of a study takes up its jobs whose process has gone"));
  ASSERT_EQ(run({"status", "--json", "--results", results}), 75);
  EXPECT_THAT(output, HasSubstr("\"gone\": \"its process has gone\""));
  const pid_t again = start_long_run("SELECT 1 FROM events WHERE reason LIKE 'process % is gone'");
  kill(again, SIGINT);
  EXPECT_EQ(wait_for(again), 130) << output;
  EXPECT_THAT(output, HasSubstr("taken up from a process that is gone"));
  EXPECT_EQ(count("status = 'planned'"), 2u);
}

}  // namespace
}  // namespace mpmstudy
