// Predictions are for the processors that the program may use, not for all of the machine.
#include <cstdlib>

#include "tests/runner/cli/program.hpp"

namespace mpmstudy {
namespace {

using testing::HasSubstr;

TEST_F(Program, plans_for_the_processors_that_it_may_use) {
  setenv("SLURM_JOB_ID", "4711", 1);
  setenv("SLURM_CPUS_PER_TASK", "1", 1);
  EXPECT_EQ(run({"plan", smoke, "--json"}), 0) << output;
  EXPECT_THAT(output, HasSubstr("\"workers\": 1,"));
  EXPECT_EQ(run({"plan", smoke, "--json", "-j", "3"}), 0) << output;
  EXPECT_THAT(output, HasSubstr("\"workers\": 3,")) << "what is asked for counts";
  unsetenv("SLURM_JOB_ID");
  unsetenv("SLURM_CPUS_PER_TASK");
}

}  // namespace
}  // namespace mpmstudy
