// The scripts that Slurm runs: valid shell, whatever names they hold, and no option that makes others wait.
#include "runner/slurm/script.hpp"

#include <gmock/gmock.h>

#include <cstdlib>
#include <fstream>

#include "runner/slurm/shell_word.hpp"
#include "tests/runner/fakes.hpp"

namespace mpmstudy {
namespace {

using testing::HasSubstr;

SlurmScripts scripts() {
  SlurmScripts s;
  s.study = "s";
  s.job_name = "mpmstudy-s-1-00c0ffee";
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

/// The value of a line of #SBATCH as sbatch reads it: quotes and backslashes taken away.
std::string value_of(const std::string& script, const std::string& option) {
  const auto begin = script.find("#SBATCH --" + option + "=") + 11 + option.size();
  std::string value;
  char quote = 0;
  for (std::size_t i = begin; i < script.size() && script[i] != '\n'; ++i) {
    const char c = script[i];
    if (c == '\\')
      value += script[++i];
    else if (quote != 0 ? c == quote : c == '"' || c == '\'')
      quote = quote != 0 ? 0 : c;
    else if (quote == 0 && (c == ' ' || c == '#'))
      break;
    else
      value += c;
  }
  return value;
}

// In names of logs, Slurm takes '%' and a letter for a text of its own; "%%" is a '%'.
TEST(SlurmScript, names_its_log_in_any_folder) {
  SlurmScripts s = scripts();
  s.folder = "/home/xu/my runs/50%j it's \"5\" #1/s-1";
  const std::string log = "/home/xu/my runs/50%%j it's \"5\" #1/s-1/log-";
  EXPECT_EQ(value_of(array_script(s), "output"), log + "%a.txt");
  EXPECT_EQ(value_of(merge_script(s), "output"), log + "merge.txt");
  s.folder = "/plain/s-1";
  EXPECT_THAT(array_script(s), HasSubstr("#SBATCH --output=/plain/s-1/log-%a.txt\n")) << "no quotes unasked";
}

TEST(SlurmScript, has_a_job_name_of_its_own) {
  EXPECT_EQ(value_of(array_script(scripts()), "job-name"), "mpmstudy-s-1-00c0ffee");
  EXPECT_EQ(value_of(merge_script(scripts()), "job-name"), "mpmstudy-s-1-00c0ffee-merge");
}

// The shell of the user has taken the quotes away.
TEST(SlurmScript, quotes_values_of_options) {
  const std::vector<std::pair<std::string, std::string>> cases = {
      {"--partition=long", "--partition=long"},
      {"--comment=a b", "--comment=\"a b\""},
      {"--comment=no 5 #1", "--comment=\"no 5 #1\""},
      {"--constraint=a&b|c", "--constraint=a&b|c"},
      {"--comment='a b'", "--comment='a b'"},
      {"-p long", "-p long"},
      {"--time 10", "--time 10"},
      {"--time=10 --partition=long", "--time=10 --partition=long"},
  };
  for (const auto& [option, line] : cases) {
    SlurmScripts s = scripts();
    s.options = {option};
    EXPECT_THAT(array_script(s), HasSubstr("\n#SBATCH " + line + "\n"));
  }
}

TEST(SlurmScript, knows_the_clusters_that_options_name) {
  EXPECT_EQ(clusters_of({"--partition=long"}), "");
  EXPECT_EQ(clusters_of({"--clusters=a,b"}), "a,b");
  EXPECT_EQ(clusters_of({"--clusters a"}), "a");
  EXPECT_EQ(clusters_of({"-M a"}), "a");
  EXPECT_EQ(clusters_of({"-Ma"}), "a");
}

TEST(SlurmScript, refuses_what_it_cannot_say) {
  EXPECT_EQ(wrong_option("--partition=long"), "");
  EXPECT_NE(wrong_option("--comment=a\nb"), "");
  EXPECT_NE(wrong_option("--array=0-3"), "");
  EXPECT_NE(wrong_option("partition=long"), "");
  EXPECT_EQ(wrong_path("/a b/%j"), "");
  EXPECT_NE(wrong_path("/a\nb"), "");
  EXPECT_NE(wrong_path("/a\\b"), "");
}

TEST(SlurmScript, quotes_words) {
  EXPECT_EQ(shell_word("plain-1.5"), "plain-1.5");
  EXPECT_EQ(shell_word("it's"), "'it'\\''s'");
  EXPECT_EQ(shell_word(""), "''");
}

}  // namespace
}  // namespace mpmstudy
