// The scripts that Slurm runs: good shell, whatever names they hold, and no option that makes others wait.
#include "runner/slurm/script.hpp"

#include <gmock/gmock.h>

#include <cstdlib>
#include <fstream>

#include "tests/runner/fakes.hpp"

namespace mpmstudy {
namespace {

using testing::HasSubstr;

SlurmScripts scripts() {
  SlurmScripts s;
  s.study = "s";
  s.program = "/opt/my programs/mpmstudy";
  s.folder = "/share/it's here/s-1";
  s.results = "/share/it's here";
  s.shards = 5;
  s.workers = 3;
  s.run = {"--set", "cell_size=0.1 um"};
  s.options = {"--partition=long"};
  return s;
}

TEST(SlurmScript, is_good_shell) {
  const fakes::TemporaryFolder folder;
  for (const auto& text : {array_script(scripts()), merge_script(scripts())}) {
    const auto path = folder.path() / "script.sh";
    std::ofstream(path) << text;
    EXPECT_EQ(std::system(("bash -O extglob -n " + path.string()).c_str()), 0) << text;
  }
}

TEST(SlurmScript, asks_for_what_the_shards_need) {
  const std::string text = array_script(scripts());
  EXPECT_THAT(text, HasSubstr("#SBATCH --array=0-4\n"));
  EXPECT_THAT(text, HasSubstr("#SBATCH --cpus-per-task=3\n"));
  EXPECT_THAT(text, HasSubstr(" --set 'cell_size=0.1 um' "));
}

// Slurm holds what it may requeue and cannot start; the merge would wait for it without end.
TEST(SlurmScript, lets_no_element_be_held_unless_told_so) {
  for (const auto& text : {array_script(scripts()), merge_script(scripts())}) {
    const auto mine = text.find("#SBATCH --no-requeue\n"), given = text.find("#SBATCH --partition=long\n");
    ASSERT_NE(mine, std::string::npos);
    ASSERT_NE(given, std::string::npos);
    EXPECT_LT(mine, given) << "the later option counts";
  }
}

TEST(SlurmScript, quotes_words) {
  EXPECT_EQ(shell_word("plain-1.5"), "plain-1.5");
  EXPECT_EQ(shell_word("it's"), "'it'\\''s'");
  EXPECT_EQ(shell_word(""), "''");
}

}  // namespace
}  // namespace mpmstudy
