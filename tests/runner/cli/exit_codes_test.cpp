// What `run` can end with: the table of runner/exec/README.md, line by line. Signals are in program_test.cpp.
#include <gmock/gmock.h>

#include <fstream>

#include <SQLiteCpp/SQLiteCpp.h>
#include "runner/catalog/connection.hpp"
#include "runner/catalog/query.hpp"
#include "tests/runner/cli/program.hpp"

namespace mpmstudy {
namespace {

using testing::HasSubstr;

class ExitCodes : public Program {
 protected:
  int run_smoke(Arguments more = {}) {
    more.insert(more.begin(), {"run", smoke, "--results", results, "-j", "1", "-q"});
    return run(more);
  }
};

TEST_F(ExitCodes, all_decided_0) {
  EXPECT_EQ(run_smoke(), 0) << output;
  EXPECT_EQ(run_smoke(), 0) << "nothing left to do: " << output;
  EXPECT_EQ(run_smoke({"-n"}), 0) << output;
}

TEST_F(ExitCodes, failed_jobs_1) {
  EXPECT_EQ(run_smoke({"--timeout", "1 ms"}), 1) << output;
  EXPECT_THAT(output, HasSubstr("ran longer than 0.001 s"));
  EXPECT_EQ(run_smoke(), 1) << "left so: " << output;
  EXPECT_EQ(run_smoke({"--retry-failed"}), 0) << output;
}

TEST_F(ExitCodes, wrong_use_2) {
  EXPECT_EQ(run({"run", "none.toml", "--results", results}), 2);
  EXPECT_EQ(run_smoke({"--set", "impact_speed=3 kg"}), 2);
  EXPECT_EQ(run_smoke({"--timeout", "soon"}), 2);
  EXPECT_EQ(run_smoke({"--heartbeat", "0 s"}), 2);
  EXPECT_EQ(run_smoke({"--only", "no-file"}), 2);
  EXPECT_EQ(run_smoke({"--nonsense"}), 2);
  EXPECT_FALSE(std::filesystem::exists(results));
  open_for_writing(results)->exec("PRAGMA user_version = 99");
  EXPECT_EQ(run_smoke(), 2) << output;
}

TEST_F(ExitCodes, work_left_75) {
  EXPECT_EQ(run_smoke({"--budget", "1 ms"}), 75) << output;
  EXPECT_THAT(output, HasSubstr("stopped: the budget is spent"));
}

TEST_F(ExitCodes, output_that_is_lost_1) {
  const std::string command =
      std::string(PROGRAM " run ") + smoke + " --results " + results + " > /dev/full 2> " + log;
  EXPECT_EQ(WEXITSTATUS(std::system(command.c_str())), 1);
  EXPECT_EQ(query(results, "SELECT key FROM jobs WHERE status = 'done'").rows.size(), 2u)
      << "and nothing else";
}

}  // namespace
}  // namespace mpmstudy
