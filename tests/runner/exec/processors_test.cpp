// How many processors a process may use: less than the machine has where it is bound, in a container, in a
// job.
#include "runner/exec/processors.hpp"

#include <gmock/gmock.h>
#include <sched.h>

#include <cstdlib>
#include <fstream>

#include "tests/runner/fakes.hpp"

namespace mpmstudy {
namespace {

namespace fs = std::filesystem;

class Processors : public testing::Test {
 protected:
  void put(const std::string& file, const std::string& text) {
    const auto path = folder.path() / file;
    fs::create_directories(path.parent_path());
    std::ofstream(path) << text << "\n";
  }
  int granted(const std::string& self) const { return cgroup_processors(self, folder.path()); }
  void TearDown() override {
    for (const char* name : {"SLURM_JOB_ID", "SLURM_CPUS_PER_TASK", "SLURM_CPUS_ON_NODE"}) unsetenv(name);
  }
  fakes::TemporaryFolder folder;
};

TEST_F(Processors, of_control_groups_are_the_least_of_all_above) {
  EXPECT_EQ(granted("0::/a/b\n"), 0) << "no bound";
  put("a/b/cpu.max", "max 100000");
  EXPECT_EQ(granted("0::/a/b\n"), 0) << "none either";
  put("a/cpu.max", "350000 100000");
  EXPECT_EQ(granted("0::/a/b\n"), 4) << "3.5 keep four busy";
  put("cpu.max", "200000 100000");
  EXPECT_EQ(granted("0::/a/b\n"), 2);
  EXPECT_EQ(granted("0::/\n"), 2) << "as in a container";
  put("cpu.max", "10000 100000");
  EXPECT_EQ(granted("0::/a/b\n"), 1);
}

TEST_F(Processors, of_control_groups_of_version_1) {
  put("cpu,cpuacct/a/cpu.cfs_quota_us", "300000");
  put("cpu,cpuacct/a/cpu.cfs_period_us", "100000");
  put("cpu,cpuacct/cpu.cfs_quota_us", "-1");
  put("cpu,cpuacct/cpu.cfs_period_us", "100000");
  EXPECT_EQ(granted("5:memory:/a\n4:cpu,cpuacct:/a/b\n1:name=systemd:/c\n0::/d\n"), 3);
  EXPECT_EQ(granted("4:cpu,cpuacct:/\n"), 0);
  EXPECT_EQ(granted("damaged\n::\n"), 0);
}

TEST_F(Processors, are_those_that_the_process_is_bound_to) {
  cpu_set_t before, one;
  ASSERT_EQ(sched_getaffinity(0, sizeof before, &before), 0);
  CPU_ZERO(&one);
  for (std::size_t i = 0; i < CPU_SETSIZE && CPU_COUNT(&one) == 0; ++i)
    if (CPU_ISSET(i, &before)) CPU_SET(i, &one);
  ASSERT_EQ(sched_setaffinity(0, sizeof one, &one), 0);
  EXPECT_EQ(usable_processors(), 1);
  ASSERT_EQ(sched_setaffinity(0, sizeof before, &before), 0);
  EXPECT_GE(usable_processors(), 1);
  EXPECT_LE(usable_processors(), CPU_COUNT(&before));
}

TEST_F(Processors, of_a_slurm_job_are_those_of_its_task) {
  const int all = usable_processors();
  setenv("SLURM_CPUS_PER_TASK", "1", 1);
  EXPECT_EQ(usable_processors(), all) << "a variable that is left over";
  setenv("SLURM_JOB_ID", "4711", 1);
  EXPECT_EQ(usable_processors(), 1);
  unsetenv("SLURM_CPUS_PER_TASK");
  setenv("SLURM_CPUS_ON_NODE", "1", 1);
  EXPECT_EQ(usable_processors(), 1);
  setenv("SLURM_CPUS_ON_NODE", "100000", 1);
  EXPECT_EQ(usable_processors(), all) << "no more than there are";
}

}  // namespace
}  // namespace mpmstudy
