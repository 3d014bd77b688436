// README.md, command by command, in its order, on what ./reproduce.sh leaves behind, only coarser: every
// command ends with 0 and does what its comment says.
#include <filesystem>
#include <fstream>
#include <regex>
#include <sstream>

#include "runner/catalog/query.hpp"
#include "tests/runner/cli/program.hpp"

namespace mpmstudy {
namespace {

namespace fs = std::filesystem;
using testing::ContainsRegex;
using testing::HasSubstr;

std::string text_of(const fs::path& path) {
  std::ifstream file(path);
  std::ostringstream text;
  text << file.rdbuf();
  return text.str();
}

/// Commands of the blocks for a shell, without their comments; a line that ends in an open quote goes on.
std::vector<std::string> commands_of(const std::string& readme) {
  std::vector<std::string> commands;
  std::istringstream lines(readme);
  bool inside = false;
  std::string pending;
  for (std::string line; std::getline(lines, line);) {
    if (line.starts_with("```")) {
      inside = line == "```sh";
      continue;
    }
    if (!inside) continue;
    pending += (pending.empty() ? "" : "\n") + line;
    const std::string bare = std::regex_replace(pending, std::regex("(^|\\s)#.*"), "");
    if (std::ranges::count(bare, '"') % 2 == 1) continue;
    if (bare.find_first_not_of(" \n") != std::string::npos) commands.push_back(bare);
    pending.clear();
  }
  return commands;
}

/// Studies that reproduce.sh runs.
std::vector<std::string> reproduced() {
  const std::string script = text_of(SOURCE_DIR "/reproduce.sh");
  std::smatch found;
  EXPECT_TRUE(std::regex_search(script, found, std::regex("studies=\\(([^)]*)\\)")));
  std::istringstream names(found[1]);
  return {std::istream_iterator<std::string>(names), {}};
}

class Readme : public Program {
 protected:
  /// In a folder that has studies/ and gets results/, as a clone does.
  int shell(const std::string& command) {
    const std::string whole =
        "cd '" + folder.path().string() + "' && mpmstudy() { " PROGRAM " \"$@\"; } && " + command;
    const std::string file = (folder.path() / "command.sh").string();
    std::ofstream(file) << whole << "\n";
    const int end = std::system(("bash '" + file + "' > '" + log + "' 2>&1 < /dev/null").c_str());
    output = text_of(log);
    return WEXITSTATUS(end);
  }
  /// What ./reproduce.sh runs, with cells that take seconds.
  void reproduce() {
    fs::create_directory_symlink(SOURCE_DIR "/studies", folder.path() / "studies");
    std::string files, searches;
    for (const std::string& name : reproduced())
      (name.starts_with("critical-speed") ? searches : files) += " studies/paper/" + name + ".toml";
    EXPECT_EQ(shell("mpmstudy run -q" + files + " " + coarse), 0) << output;
    EXPECT_EQ(shell("mpmstudy run -q" + searches + " " + coarse_search), 0) << output;
    EXPECT_EQ(shell("mpmstudy report" + files + searches), 0) << output;
  }
  /// The command with cells that take seconds.
  static std::string coarser(std::string command) {
    if (const auto at = command.find("--cells 1.4"); at != std::string::npos)
      command.replace(at, 11, command.find("critical-speed") == std::string::npos ? coarse : coarse_search);
    return command;
  }
  std::size_t pictures() {
    const std::string page = text_of(fs::path(results) / "report.html");
    std::size_t count = 0;
    for (auto at = page.find("data:image/"); at != std::string::npos; at = page.find("data:image/", at + 1))
      ++count;
    return count;
  }
  std::int64_t number(const std::string& sql) {
    return std::get<std::int64_t>(query(results, sql).rows.at(0).at(0));
  }

  static constexpr const char* coarse = "--cells 2";
  static constexpr const char* coarse_search =
      "--cells 2 --set wall_thickness='[\"1 um\", \"2 um\", \"3 um\"]' --set cell_size='[\"0.28 um\", \"0.2 "
      "um\"]' --set "
      "tolerance='100 m/s'";
};

// studies/examples: each runs, coarser or with fewer samples here, and leaves a picture for every figure that
// it asks for.
TEST_F(Readme, ExamplesRunAndAreDrawn) {
  std::size_t examples = 0;
  for (const auto& file : fs::directory_iterator(SOURCE_DIR "/studies/examples")) {
    if (file.path().extension() != ".toml") continue;
    const std::string name = file.path().stem().string();
    const std::string less = name == "error-bars" ? "--set samples=2" : "--cells 1.6";
    ASSERT_EQ(shell("mpmstudy run '" + file.path().string() + "' " + less), 0) << name << "\n" << output;
    ++examples;
    EXPECT_EQ(output.find("not drawn"), std::string::npos) << output;
    EXPECT_FALSE(fs::is_empty(folder.path() / "results" / "figures" / name));
  }
  EXPECT_GE(examples, 6u);
  EXPECT_EQ(number("SELECT count(*) FROM jobs WHERE status <> 'done'"), 0);
  // The same cavity in axial symmetry and in three dimensions.
  EXPECT_LT(
      number("SELECT CAST(1000 * (max(collapsibility) - min(collapsibility)) AS INTEGER) FROM jobs WHERE "
             "study = 'solid'"),
      30);
  // A sphere closes sooner than a cylinder.
  EXPECT_GT(number("SELECT CAST(100 * min(collapsibility) AS INTEGER) FROM jobs WHERE study = 'sphere' AND "
                   "space = 'axisymmetric'"),
            number("SELECT CAST(100 * min(collapsibility) AS INTEGER) FROM jobs WHERE study = 'sphere' AND "
                   "space = 'plane-strain'"));
}

TEST_F(Readme, EveryCommandEndsWellAndDoesWhatItsCommentSays) {
  reproduce();
  const std::size_t before = pictures();
  EXPECT_GE(before, 39u);
  std::size_t done = 0;
  for (const std::string& command : commands_of(text_of(SOURCE_DIR "/README.md"))) {
    if (!command.starts_with("mpmstudy")) continue;  // ./reproduce.sh, ./test.sh, the alias
    ASSERT_EQ(shell(coarser(command)), 0) << command << "\n" << output;
    ++done;
    EXPECT_FALSE(output.empty()) << command;
    if (command.find(" explain ") != std::string::npos) {
      EXPECT_THAT(output, ContainsRegex("done: reused"));
    } else if (command.find(" forget ") != std::string::npos) {
      EXPECT_THAT(output, HasSubstr("smoke-300 forgotten: 2 of its 2 jobs no other study has"));
    } else if (command.find(" gc") != std::string::npos) {
      EXPECT_THAT(output, ContainsRegex("removed: [1-9][0-9]* jobs that no study has"));
    } else if (command.find(" verify ") != std::string::npos) {
      EXPECT_THAT(output, HasSubstr("5"));
    } else if (command.find(" figures") != std::string::npos) {
      EXPECT_THAT(output, HasSubstr("figures/weak-collapse/fig5.png"));
      EXPECT_THAT(output, HasSubstr("figures/smoke-300/smoke-area.png"));
    } else if (command.find(" query ") != std::string::npos) {
      EXPECT_GE(std::ranges::count(output, '\n'), 3) << command;
    }
  }
  EXPECT_GE(done, 10u);
  EXPECT_EQ(number("SELECT count(*) FROM jobs WHERE study = 'smoke' AND status = 'done'"), 2);
  EXPECT_EQ(
      number("SELECT count(*) FROM jobs WHERE study = 'smoke-300' OR key NOT IN (SELECT key FROM decisions)"),
      0)
      << "gc";
  EXPECT_EQ(number("SELECT count(*) FROM critical_speed WHERE study = 'critical-speed'"), 6);
  EXPECT_GT(pictures(), before) << "the page has the studies that were run since, too";
  // What the page shows of the paper is judged, none of it on other speeds or radii; the searches had
  // other walls.
  EXPECT_EQ(
      number("SELECT count(*) FROM claims WHERE verdict = 'not run' AND study NOT LIKE 'critical-speed%'"),
      0);
}

}  // namespace
}  // namespace mpmstudy
