// The examples that are composed of bodies, run by the program on coarse cells: every job is done, figures
// are there, and so is what the studies call their own.
#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <sys/wait.h>

#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <iterator>

#include "runner/catalog/query.hpp"
#include "tests/temporary_folder.hpp"

namespace mpmstudy {
namespace {

namespace fs = std::filesystem;

std::int64_t whole(const fs::path& results, const std::string& sql) {
  return std::get<std::int64_t>(query(results, sql).rows.at(0).at(0));
}
double number(const fs::path& results, const std::string& sql) {
  return std::get<double>(query(results, sql).rows.at(0).at(0));
}

struct Example {
  std::string name;
  std::string options;
  int jobs;
  int own;  ///< parameters
};

void PrintTo(const Example& e, std::ostream* out) { *out << e.name; }

class Examples : public testing::TestWithParam<Example> {
 protected:
  /// Runs the program; its exit code.
  int run(const std::string& more = "", const std::string& verb = "run") const {
    const Example& e = GetParam();
    const std::string command = "cd '" + folder.path().string() + "' && '" PROGRAM "' " + verb +
                                " '" SOURCE_DIR "/studies/examples/" + e.name + ".toml' " + e.options + more +
                                " > out 2> err";
    const int status = std::system(command.c_str());
    return WIFEXITED(status) ? WEXITSTATUS(status) : -1;
  }
  std::string text_of(const std::string& file) const {
    std::ifstream stream(folder.path() / file);
    return {std::istreambuf_iterator<char>(stream), {}};
  }
  TemporaryFolder folder;
};

TEST_P(Examples, Run) {
  ASSERT_EQ(run(), 0);
  const fs::path results = folder.path() / "results";
  EXPECT_EQ(whole(results, "SELECT count(*) FROM jobs WHERE status = 'done'"), GetParam().jobs);
  EXPECT_EQ(whole(results, "SELECT count(*) FROM parameters"), GetParam().jobs * GetParam().own);
  EXPECT_FALSE(fs::is_empty(results / "figures" / GetParam().name));
  // the same jobs are found again
  ASSERT_EQ(run(), 0);
  EXPECT_EQ(whole(results, "SELECT max(attempt) FROM jobs"), 1);
}

INSTANTIATE_TEST_SUITE_P(Bodies, Examples,
                         testing::Values(Example{"two-cavities", "--cells 2", 2, 6},
                                         Example{"ellipse", "--cells 2", 4, 4},
                                         Example{"inclusion", "--cells 2", 2, 3},
                                         Example{"flyer", "--cells 2", 3, 3},
                                         Example{"pressed-cavity", "--cells 2", 3, 3},
                                         Example{"taylor-bar", "--set cells_across=4", 1, 4}),
                         [](const auto& info) {
                           std::string name = info.param.name;
                           std::erase(name, '-');
                           return name;
                         });

/// Points of a file; what is skipped is said by plan, check and the end of a run.
class Design : public Examples {};
TEST_P(Design, SaysWhatIsSkipped) {
  ASSERT_EQ(run(), 0);
  EXPECT_EQ(whole(folder.path() / "results", "SELECT count(*) FROM jobs WHERE status = 'done'"), 8);
  const std::string said = "2 of 10 points of the sweep are skipped";
  EXPECT_NE(text_of("out").find(said), std::string::npos);
  for (const char* verb : {"plan", "check"}) {
    ASSERT_EQ(run("", verb), 0);
    EXPECT_NE(text_of("out").find(said), std::string::npos) << verb;
  }
}
INSTANTIATE_TEST_SUITE_P(Sweeps, Design, testing::Values(Example{"design", "", 8, 0}));

// Length and foot of the bar against what other codes agree on (21.42 mm, 7.23 mm), as far as four cells go.
class TaylorBar : public Examples {};
TEST_P(TaylorBar, HasItsLengthAndFoot) {
  ASSERT_EQ(run(), 0);
  const fs::path results = folder.path() / "results";
  EXPECT_NEAR(number(results, "SELECT value FROM metrics WHERE name = 'length.end'"), 21.42e-3, 0.6e-3);
  EXPECT_NEAR(number(results, "SELECT value FROM metrics WHERE name = 'foot.max'"), 7.23e-3, 0.6e-3);
}
INSTANTIATE_TEST_SUITE_P(Bodies, TaylorBar,
                         testing::Values(Example{"taylor-bar", "--set cells_across=4", 1, 4}));

}  // namespace
}  // namespace mpmstudy
