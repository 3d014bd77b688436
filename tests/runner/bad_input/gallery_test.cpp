/// The gallery: for every NAME.toml of this folder, `mpmstudy check NAME.toml` ends with exit code 2, says
/// exactly NAME.txt on stderr and nothing on stdout, and leaves no file behind.
#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <sys/wait.h>
#include <unistd.h>

#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <map>
#include <sstream>

#include "tests/temporary_folder.hpp"

namespace {

namespace fs = std::filesystem;
using testing::HasSubstr;
using testing::StartsWith;

const fs::path gallery = SOURCE_DIR "/tests/runner/bad_input";

std::string text_of(const fs::path& path) {
  std::ifstream stream(path, std::ios::binary);
  std::ostringstream text;
  text << stream.rdbuf();
  return text.str();
}

class Folder : public TemporaryFolder {
 public:
  std::map<std::string, std::string> contents() const {
    std::map<std::string, std::string> files;
    for (const auto& file : fs::recursive_directory_iterator(path()))
      files[file.path().string()] = file.is_regular_file() ? text_of(file.path()) : "";
    return files;
  }
};

struct Outcome {
  int exit_code;
  std::string out, err;
};

/// Runs `mpmstudy ARGUMENTS` inside `folder`.
Outcome run(const Folder& folder, const std::string& arguments) {
  const Folder streams;
  const fs::path out = streams.path() / "out", err = streams.path() / "err";
  const std::string command = "cd '" + folder.path().string() + "' && '" MPMSTUDY_PROGRAM "' " + arguments +
                              " > '" + out.string() + "' 2> '" + err.string() + "'";
  const int status = std::system(command.c_str());
  return {WIFEXITED(status) ? WEXITSTATUS(status) : -1, text_of(out), text_of(err)};
}

class Gallery : public testing::TestWithParam<std::string> {};

TEST_P(Gallery, HasItsMessage) {
  const Folder folder;
  const std::string file = GetParam() + ".toml";
  fs::copy_file(gallery / file, folder.path() / file);
  const auto before = folder.contents();
  const Outcome outcome = run(folder, "check " + file);
  EXPECT_EQ(outcome.exit_code, 2);
  EXPECT_EQ(outcome.err, text_of(gallery / (GetParam() + ".txt")));
  EXPECT_EQ(outcome.out, "");
  EXPECT_EQ(folder.contents(), before);
}

std::vector<std::string> names() {
  std::vector<std::string> names;
  for (const auto& file : fs::directory_iterator(gallery))
    if (file.path().extension() == ".toml") names.push_back(file.path().stem().string());
  std::sort(names.begin(), names.end());
  return names;
}
INSTANTIATE_TEST_SUITE_P(BadInput, Gallery, testing::ValuesIn(names()),
                         [](const auto& i) { return i.param; });

const char* const good_study = R"(schema = 1
name = "good"
scene = "cavity-impact"
[parameters]
material = "aluminium"
impact_speed = "200 m/s"
block_width = "10 um"
block_height = "5 um"
cavity_radius = "1.5 um"
cavity_center_height = "1.9 um"
end_time = "16 ns"
[numerics]
cell_size = "0.1 um"
)";

/// What no file of the gallery can show.
TEST(BadInput, CommandLines) {
  const Folder folder;
  std::ofstream(folder.path() / "good.toml") << good_study;
  fs::create_directory(folder.path() / "folder");
  for (const char* below : {"a", "b"}) {  // where studies may have been moved to
    fs::create_directory(folder.path() / below);
    std::ofstream(folder.path() / below / "both.toml") << good_study;
  }
  std::ofstream(folder.path() / "b" / "moved.toml") << good_study;
  const auto before = folder.contents();
  const struct {
    const char* arguments;
    const char* begins;  ///< of stderr
  } cases[] = {
      {"check absent.toml", "absent.toml: no such file; "},
      {"check moved.toml", "moved.toml: no such file; there is b/moved.toml\n"},
      {"run ./both.toml", "./both.toml: no such file; there is ./a/both.toml, ./b/both.toml\n"},
      {"plan '*.toml'", "*.toml: no such file; there is a/*.toml, b/*.toml\n"},
      {"check folder", "folder: is a directory; "},
      {"check good.toml --set impact_speed='200 kg'",
       "--set: impact_speed = \"200 kg\": 'kg' is not a unit of"},
      {"check good.toml --set cell_sise='1 um'",
       "--set: cell_sise = 1 um: unknown key; did you mean cell_size?"},
      {"check good.toml --set cell_size", "--set: cell_size: not KEY=VALUE; "},
      {"check good.toml --set cell_size='3 um'", "--set: cell_size = \"3 um\": cannot be run; "},
      {"check good.toml --set 'cavity_radius={ from = 1, to = 1.5, count = 1000001, unit = \"um\" }'",
       "--set: cavity_radius = { from = 1, to = 1.5, count = 1000001, unit = \"um\" }: makes 1000001 jobs, "
       "more than 1000000; sweep fewer values, or say --yes"},
      {"check good.toml --set mode=random --set samples=1000001 --set seed=1 "
       "--set 'cavity_radius={ from = 1, to = 1.5, unit = \"um\" }'",
       "--set: samples = 1000001: more than 1000000 jobs; "},
      {"plan absent.toml", "absent.toml: no such file; "},
      {"plan good.toml --set 'cavity_radius=[]'", "--set: cavity_radius = []: no values; "},
      {"check", "FILE is required"},
      {"plan good.toml -j 0", "--jobs: Value 0 not in range"},
      {"check good.toml --cells 0", "--cells: a factor is a number above 0, such as 0.5; not 0"},
      {"run good.toml --results ''", "--results: is empty; name a folder"},
      {"run good.toml good.toml", "good.toml: is given twice"},
      {"check good.toml --set MATERIAL=x", "--set: MATERIAL = x: unknown key; did you mean material?"},
      {"retry ''", "KEY: is empty"},
      {"check good.toml --cells 20",
       "good.toml:13:13: cell_size = \"0.1 um\": cannot be run: times --cells 20 it is 2 um; allowed: at "
       "most an "
       "eighth of block_width (1.25 um)\n"},
      {"check good.toml --cells 20 --set cell_size='[\"50 nm\", \"100 nm\"]'",
       "--set: cell_size = 100 nm: cannot be run: times --cells 20 it is 2000 nm; allowed: at most an eighth "
       "of "
       "block_width (1250 nm)\n"},
      {"check good.toml --cells 2 --set ladder=9",
       "--set: ladder = 9: makes a cell of 3.2 um, with --cells 2; allowed: fewer cells, or a cell_size "
       "whose "
       "ladder keeps cell_size at most an eighth of block_width (1.25 um)\n"},
      {"check good.toml --cells 1e-310",
       "good.toml:13:13: cell_size = \"0.1 um\": times --cells 1e-310 it is no"},
      {"check good.toml --set title='a\x1b[31mb'",
       "--set: title = \"a\\u001B[31mb\": holds U+001B, a control character; allowed: a line of text\n"},
      {"check good.toml --set 'cell\x9b\x1b=1'", "--set: cell\\u009B\\u001B = 1: unknown key"},
      {"check good.toml --cells inf", "--cells: a factor is a number above 0"},
      {"check good.toml --set impact_speed='200\u00a0m/s'",
       "--set: impact_speed = \"200\u00a0m/s\": '\u00a0m/s' is not a unit (it holds U+00A0, a no-break "
       "space); "},
      {"check good.toml --set impact_speed='\u2212200 m/s'",
       "--set: impact_speed = \"\u2212200 m/s\": not a number with a unit (it holds U+2212, a minus sign "
       "other "},
      {"check good.toml --set scene='cavity\u2011impact'",
       "--set: scene = \"cavity\u2011impact\": no such scene (it holds U+2011, a dash); "},
      {"chekc good.toml", "chekc: no verb of mpmstudy; did you mean check?"},
      {"run good.toml --slurm=--partition=x",
       "--slurm, --shard-time, --shards and --rounds are for --engine slurm"},
      {"run good.toml --audit '5 %'", "--audit 5 %: none of these studies has a [search]"},
      {"check good.toml --set name=q-audit", "--set: name = \"q-audit\": is kept for the runs that an audit"},
      {"", "Parameter studies"},
  };
  for (const auto& one : cases) {
    const Outcome outcome = run(folder, one.arguments);
    EXPECT_EQ(outcome.exit_code, 2) << one.arguments;
    EXPECT_THAT(outcome.err, StartsWith(one.begins)) << one.arguments;
    EXPECT_EQ(outcome.out, "") << one.arguments;
  }
  EXPECT_EQ(folder.contents(), before);
}

/// What stands in the results folder already stays as it is, and no folder comes into being.
TEST(BadInput, ARunThatIsRefusedLeavesTheResultsAlone) {
  for (const bool has_results : {false, true}) {
    const Folder folder;
    std::ofstream(folder.path() / "good.toml") << good_study;
    for (const char* file : {"too_many_jobs.toml", "unknown_key.toml"})
      fs::copy_file(gallery / file, folder.path() / file);
    if (has_results) {
      fs::create_directory(folder.path() / "results");
      std::ofstream(folder.path() / "results" / "catalog.db") << "not looked at";
    }
    const auto before = folder.contents();
    const struct {
      const char* arguments;
      const char* says;
    } cases[] = {
        {"run too_many_jobs.toml", "too_many_jobs.toml:1:1: jobs = 1001000: more than 1000000 jobs; "},
        {"run good.toml --set 'impact_speed={ from = 1, to = 2, count = 1000001, unit = \"m/s\" }'",
         "--set: impact_speed = "},
        {"run good.toml unknown_key.toml", "unknown_key.toml:"},
        {"run absent.toml", "absent.toml: no such file; "},
    };
    for (const auto& one : cases) {
      const Outcome outcome = run(folder, one.arguments);
      EXPECT_EQ(outcome.exit_code, 2) << one.arguments;
      EXPECT_THAT(outcome.err, StartsWith(one.says)) << one.arguments;
      EXPECT_EQ(outcome.out, "") << one.arguments;
      EXPECT_EQ(folder.contents(), before) << one.arguments;
    }
  }
}

/// Too long and too large for any machine: asked for, and without a terminal refused.
TEST(BadInput, ARunThatTakesTooMuchIsRefused) {
  const Folder folder;
  std::ofstream(folder.path() / "good.toml") << good_study;
  const auto before = folder.contents();
  const Outcome outcome = run(folder, "run good.toml --set cell_size='1 nm' < /dev/null");
  EXPECT_EQ(outcome.exit_code, 2);
  EXPECT_THAT(outcome.err, StartsWith("run: would take about "));
  EXPECT_THAT(outcome.err, HasSubstr(" GB of memory, of which "));
  EXPECT_THAT(outcome.err, HasSubstr("(the largest job alone takes "));
  EXPECT_THAT(outcome.err, testing::ContainsRegex("and about [0-9]+ h [0-9]+ min"));
  EXPECT_THAT(outcome.err, HasSubstr("--yes"));
  EXPECT_EQ(folder.contents(), before);
  // `check` and `plan` do not ask.
  EXPECT_THAT(run(folder, "check good.toml --set cell_size='1 nm'").out, HasSubstr(" GB of memory each"));
  EXPECT_EQ(run(folder, "plan good.toml --set cell_size='1 nm'").exit_code, 0);
  EXPECT_EQ(run(folder, "run -n good.toml --set cell_size='1 nm'").exit_code, 0);
}

/// Warnings go to standard error and change no exit code.
TEST(GoodInput, IsWarnedOf) {
  const Folder folder;
  std::ofstream(folder.path() / "good.toml") << good_study;
  for (const char* verb : {"check", "plan", "run -n"}) {
    const Outcome outcome = run(folder, std::string(verb) + " good.toml --set spall_strength='1 GPa'");
    EXPECT_EQ(outcome.exit_code, 0) << verb;
    EXPECT_THAT(outcome.err, StartsWith("warning: --set: spall_strength: has no effect")) << verb;
  }
  const std::string json = run(folder, "plan good.toml --json --set spall_strength='1 GPa'").out;
  EXPECT_THAT(json, HasSubstr("\"warnings\": [\n    \"--set: spall_strength"));
  EXPECT_THAT(run(folder, "plan good.toml --json --set yield_stress=infinite").out,
              HasSubstr("\"yield_stress_Pa\": \"infinite\""));
}

TEST(BadInput, AResultsFolderThatCannotBeMade) {
  const Folder folder;
  std::ofstream(folder.path() / "good.toml") << good_study;
  const auto before = folder.contents();
  // /proc refuses everybody, also root.
  const Outcome outcome = run(folder, "run good.toml --results /proc/results");
  EXPECT_EQ(outcome.exit_code, 2);
  EXPECT_THAT(outcome.err, StartsWith("/proc/results: cannot be used as the results folder"));
  EXPECT_EQ(folder.contents(), before);
}

TEST(BadInput, OutputThatIsLostIsAFailure) {
  const Folder folder;
  std::ofstream(folder.path() / "good.toml") << good_study;
  for (const char* arguments : {"plan good.toml > /dev/full", "check good.toml > /dev/full",
                                "run good.toml -n > /dev/full", "--help > /dev/full"}) {
    const Folder streams;
    const std::string err = (streams.path() / "err").string();
    const std::string command =
        "cd '" + folder.path().string() + "' && '" MPMSTUDY_PROGRAM "' " + arguments + " 2> '" + err + "'";
    const int status = std::system(command.c_str());
    EXPECT_EQ(WEXITSTATUS(status), 1) << arguments;
    EXPECT_THAT(text_of(err), HasSubstr("standard output could not be written")) << arguments;
  }
}

TEST(BadInput, GoodFilesBesideBadOnes) {
  const Folder folder;
  std::ofstream(folder.path() / "good.toml") << good_study;
  const Outcome outcome = run(folder, "check good.toml absent.toml good.toml");
  EXPECT_EQ(outcome.exit_code, 2);
  const std::string line = "ok: good, 1 job, about 21.5 MB of memory each and 0.00057 CPU-hours\n";
  EXPECT_EQ(outcome.out, line + line);
  EXPECT_THAT(outcome.err, StartsWith("absent.toml: "));
}

TEST(GoodInput, EndsWithZero) {
  const Folder folder;
  std::ofstream(folder.path() / "good.toml") << good_study;
  const auto before = folder.contents();
  EXPECT_EQ(run(folder, "check good.toml").exit_code, 0);
  EXPECT_EQ(run(folder, "plan good.toml").exit_code, 0);
  EXPECT_THAT(run(folder, "plan good.toml --json").out, StartsWith("{\n  \"study\": \"good\""));
  EXPECT_EQ(run(folder, "--help").exit_code, 0);
  EXPECT_THAT(run(folder, "--version").out, HasSubstr("physics version"));
  EXPECT_EQ(folder.contents(), before);
}

}  // namespace
