// Wrong command lines, and exit codes of all verbs: the table of runner/cli/README.md.
#include <SQLiteCpp/SQLiteCpp.h>

#include "runner/catalog/connection.hpp"
#include "runner/catalog/query.hpp"
#include "tests/runner/cli/program.hpp"

namespace mpmstudy {
namespace {

using testing::ContainsRegex;
using testing::HasSubstr;
using testing::Not;

class Usage : public Program {
 protected:
  int verb(Arguments arguments) {
    arguments.insert(arguments.end(), {"--results", results});
    return run(arguments);
  }
  void write(const std::string& sql) { open_for_writing(results)->exec(sql); }
};

TEST_F(Usage, a_misspelt_verb_or_option_gets_the_nearest_one) {
  EXPECT_EQ(run({"rum", smoke}), 2);
  EXPECT_THAT(output, HasSubstr("rum: no verb of mpmstudy; did you mean run?"));
  EXPECT_EQ(run({"xyzzy"}), 2);
  EXPECT_THAT(output, HasSubstr("verbs: check, plan, run, show, predict, sensitivity, status, "));
  EXPECT_EQ(run({"run", smoke, "--retry-faild"}), 2);
  EXPECT_THAT(output, HasSubstr("--retry-faild: no option of mpmstudy run; did you mean --retry-failed?"));
  EXPECT_EQ(run({"run", smoke, "--result=x"}), 2);
  EXPECT_THAT(output, HasSubstr("--result: no option of mpmstudy run; did you mean --results?"));
  EXPECT_EQ(run({"run", "--resluts", "x"}), 2);
  EXPECT_THAT(output, HasSubstr("did you mean --results?"));
  EXPECT_EQ(run({"bench", "exakt"}), 2);
  EXPECT_THAT(output, HasSubstr("did you mean exact?"));
  EXPECT_EQ(run({"query", "SELECT", "1"}), 2);
  EXPECT_THAT(output, HasSubstr("quote the SQL"));
}

TEST_F(Usage, what_begins_like_an_option_is_said_to_be_taken_for_one) {
  open_for_writing(results);
  const std::string sql = "--radius\nSELECT 1 AS one";
  EXPECT_EQ(verb({"query", sql}), 2);
  EXPECT_THAT(output, HasSubstr("what begins with '-' is taken for an option; behind -- it is not: mpmstudy "
                                "query -- \"...\"\n  it was: --radius\n"));
  EXPECT_EQ(run({"query", "--results", results, "--", sql}), 0);
  EXPECT_THAT(output, HasSubstr("one\n"));
}

TEST_F(Usage, a_view_that_is_not_there_gets_the_nearest_one) {
  open_for_writing(results);
  EXPECT_EQ(verb({"export", "--what", "job"}), 2);
  EXPECT_THAT(output, HasSubstr("--what: job: there is no such view; did you mean jobs?"));
  EXPECT_EQ(verb({"export", "--what", "zzzzzzzz"}), 2);
  EXPECT_THAT(output, HasSubstr("claims, critical_speed, decisions, events, fits"));
}

TEST_F(Usage, exit_codes_say_how_the_studies_are) {
  EXPECT_EQ(verb({"status"}), 2) << "no catalog";
  ASSERT_EQ(verb({"run", smoke, "-q"}), 0) << output;
  const auto key = std::get<std::string>(query(results, "SELECT key FROM jobs LIMIT 1").rows[0][0]);
  struct Case {
    std::string state;
    int run, status, watch;  // watch: -1 where it is not tried
  };
  for (const Case& c : {Case{"done", 0, 0, 0}, Case{"failed", 1, 1, 1}, Case{"planned", 0, 75, 75},
                        Case{"running", 0, 75, -1}}) {
    write("UPDATE job SET status = '" + c.state + "', runner_id = 1 WHERE key = '" + key + "'");
    EXPECT_EQ(verb({"status"}), c.status) << c.state << output;
    EXPECT_EQ(verb({"status", "--json"}), c.status) << c.state;
    EXPECT_EQ(verb({"status", smoke}), c.status) << c.state;
    if (c.watch >= 0) {
      EXPECT_EQ(verb({"watch", "--every", "0.1"}), c.watch) << c.state << output;
    }
    if (c.watch == 75) {
      EXPECT_THAT(output, HasSubstr("nobody runs these studies now; `mpmstudy run STUDY`"));
    }
    EXPECT_EQ(verb({"run", smoke, "-q"}), c.run) << c.state << output;
    EXPECT_EQ(verb({"run", smoke, "-q"}), c.run) << "again: " << c.state << output;
  }
  // Work left goes before failures.
  write("UPDATE job SET status = CASE key WHEN '" + key + "' THEN 'failed' ELSE 'planned' END");
  EXPECT_EQ(verb({"status"}), 75);
  // Jobs that no study has are no study's state.
  write("DELETE FROM study_job");
  EXPECT_EQ(verb({"status"}), 0);
}

TEST_F(Usage, a_process_between_two_jobs_is_waited_for) {
  ASSERT_EQ(verb({"run", smoke, "-q"}), 0) << output;
  // As if the last run still drew a conclusion: the process is this one.
  std::ifstream stat("/proc/self/stat");
  std::string word, ticks;
  for (int i = 1; i <= 22 && stat >> word; ++i) ticks = word;  // no blank in the name of this program
  write("UPDATE runner SET ended_at = NULL, pid = " + std::to_string(getpid()) +
        ", process_start = " + ticks + " WHERE id = (SELECT max(id) FROM runner)");
  const pid_t child = start({"watch", "--every", "0.1", "--results", results});
  usleep(500'000);
  EXPECT_EQ(waitpid(child, nullptr, WNOHANG), 0) << "it goes on";
  write("UPDATE runner SET ended_at = heartbeat_at WHERE ended_at IS NULL");
  EXPECT_EQ(wait_for(child), 0);
}

TEST_F(Usage, what_is_not_found_ends_with_1) {
  ASSERT_EQ(verb({"run", smoke, "-q"}), 0) << output;
  write("UPDATE job SET status = 'failed' WHERE id = 1");
  const auto failed =
      std::get<std::string>(query(results, "SELECT key FROM jobs WHERE status = 'failed'").rows[0][0]);
  EXPECT_EQ(verb({"retry", failed, "zzz"}), 1);  // one of two
  EXPECT_THAT(output, HasSubstr("zzz: there is no such failed job"));
  EXPECT_THAT(output, HasSubstr("1 job planned again"));
  write("UPDATE job SET status = 'planned'");
  EXPECT_EQ(verb({"verify", "1"}), 1);
  EXPECT_THAT(output, HasSubstr("no job is done that this program could run again"));
}

TEST_F(Usage, an_accuracy_that_was_missed_is_seen_by_status) {
  ASSERT_EQ(verb({"run", smoke, "-q"}), 0) << output;
  write(
      "INSERT INTO interval (study_id, job_id, quantity, unit, value, error, extrapolated_value, "
      "extrapolated_error, method, cells, discretisation_error, measuring_error, wanted_error) VALUES "
      "(1, 1, 'collapsibility', '1', 0.5, 0.1, 0.5, 0.1, 'spread', 4, 0.1, 0, 0.01)");
  EXPECT_EQ(verb({"status"}), 1);
}

TEST_F(Usage, every_view_of_the_catalog_is_exported) {
  ASSERT_EQ(verb({"run", smoke, "-q"}), 0) << output;
  const auto views = query(results, "SELECT name FROM sqlite_master WHERE type = 'view'").rows;
  ASSERT_GE(views.size(), 11u);
  for (const char* study : {"", "smoke"}) {
    const auto to = folder.path() / (std::string("exported") + study);
    Arguments arguments = {"export", "--what", "all", "-o", to.string()};
    if (*study) arguments.insert(arguments.end(), {"--study", study});
    ASSERT_EQ(verb(arguments), 0) << output;
    for (const auto& row : views) {
      const auto name = std::get<std::string>(row[0]);
      EXPECT_GT(std::filesystem::file_size(to / (name + ".csv")), 0u) << name;
    }
  }
  ASSERT_EQ(verb({"export", "--what", "events", "--study", "smoke"}), 0);
  EXPECT_THAT(output, ContainsRegex("^key,from_status,to_status,"));
  EXPECT_THAT(output, HasSubstr(",done,"));
  ASSERT_EQ(verb({"export", "--what", "studies", "--study", "smoke"}), 0);
  EXPECT_THAT(output, HasSubstr("smoke,"));
}

TEST_F(Usage, the_catalog_is_named_once) {
  ASSERT_EQ(verb({"run", SOURCE_DIR "/tests/slurm/search.toml"}), 0) << output;
  const auto first = output.find("catalog: ");
  ASSERT_NE(first, std::string::npos);
  EXPECT_EQ(output.find("catalog: ", first + 1), std::string::npos) << output;
  // Every line counts to a total that it does not pass, and has the searched value.
  std::istringstream text(output);
  int ends = 0;
  for (std::string line; std::getline(text, line);) {
    int number = 0, of = 0;
    if (std::sscanf(line.c_str(), "[%d/%d] ", &number, &of) != 2) continue;
    ++ends;
    EXPECT_LE(number, of) << line;
    EXPECT_THAT(line, HasSubstr("impact_speed = "));
  }
  EXPECT_GT(ends, 5);
  EXPECT_THAT(output, ContainsRegex("\n" + std::to_string(ends) + " done, 0 failed, 0 reused, 0 left in "));
}

}  // namespace
}  // namespace mpmstudy
