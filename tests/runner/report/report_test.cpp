// The report as a reader has it: opened in a browser it runs without errors and its animation advances; its
// numbers are those of the catalog; it loads nothing.
#include <fmt/format.h>
#include <gmock/gmock.h>

#include <array>
#include <cstdio>
#include <filesystem>
#include <fstream>
#include <optional>
#include <random>
#include <regex>
#include <sstream>

#include "runner/catalog/query.hpp"
#include "tests/temporary_folder.hpp"

namespace {

namespace fs = std::filesystem;
using testing::HasSubstr;
using testing::Not;

constexpr const char* study = R"(# A reading: "this" & that <so>.
schema = 1
name   = "page"
title  = "Two small collapses"
scene  = "cavity-impact"
[parameters]
material             = "aluminium"
impact_speed         = "200 m/s"
block_width          = "10 um"
block_height         = "6 um"
cavity_center_height = "3 um"
cavity_radius        = ["1 um", "2 um"]
end_time             = "1 ns"
[numerics]
cell_size = "0.25 um"
[measure]
snapshots = ["0.2 ns", "0.5 ns", "1 ns"]
[[figure]]
name  = "pressure"
kind  = "fields"
y     = "pressure"
[[figure]]
name  = "area"
kind  = "history"
)";

std::string output_of(const std::string& command) {
  std::string text;
  FILE* pipe = popen(command.c_str(), "r");
  std::array<char, 65536> buffer{};
  while (const std::size_t n = fread(buffer.data(), 1, buffer.size(), pipe)) text.append(buffer.data(), n);
  const int status = pclose(pipe);
  EXPECT_EQ(WEXITSTATUS(status), 0) << command << "\n" << text;
  return text;
}

std::string text_of(const fs::path& path) {
  std::ifstream file(path);
  std::ostringstream text;
  text << file.rdbuf();
  return text.str();
}

class Report : public testing::Test {
 protected:
  static void SetUpTestSuite() {
    own.emplace();
    folder = own->path();
    std::ofstream(folder / "page.toml") << study;
    const std::string options =
        (folder / "page.toml").string() + " --results " + (folder / "results").string();
    output_of(std::string(MPMSTUDY) + " run " + options + " 2>&1");
    output_of(std::string(MPMSTUDY) + " report " + options + " 2>&1");
    page = text_of(folder / "results" / "report.html");
  }
  static void TearDownTestSuite() { own.reset(); }

  /// The page after `milliseconds` in the browser, and what its console said.
  static std::string browse(int milliseconds, int width, std::string& console) {
    const fs::path log = folder / "console";
    const std::string dom = output_of(
        fmt::format("chromium-headless-shell --no-sandbox --disable-gpu --enable-logging=stderr --v=0 "
                    "--window-size={},900 "
                    "--virtual-time-budget={} --dump-dom file://{} 2>{}",
                    width, milliseconds, (folder / "results" / "report.html").string(), log.string()));
    console = text_of(log);
    return dom;
  }

  static inline std::optional<TemporaryFolder> own;
  static inline fs::path folder;
  static inline std::string page;
};

int frame_of(const std::string& dom) {
  std::smatch match;
  EXPECT_TRUE(std::regex_search(dom, match, std::regex("data-frame=\"([0-9]+)\"")));
  return match.empty() ? -1 : std::stoi(match[1]);
}

TEST_F(Report, RunsInABrowserWithoutErrorsAndItsAnimationAdvances) {
  for (const int width : {1280, 390}) {
    std::string early_console, late_console;
    const std::string early = browse(100, width, early_console), late = browse(1000, width, late_console);
    EXPECT_EQ(frame_of(early), 0);
    EXPECT_GT(frame_of(late), 0);
    EXPECT_TRUE(std::regex_search(late, std::regex("t = [0-9.]+ ns</output>")));  // it says which time shows
    for (const auto& console : {early_console, late_console}) {
      EXPECT_THAT(console, Not(HasSubstr("CONSOLE")));
      EXPECT_THAT(console, Not(HasSubstr("Uncaught")));
    }
  }
}

TEST_F(Report, TenNumbersAreThoseOfTheCatalog) {
  const std::regex row("<tr><td>([0-9a-f]{12})</td><td>([A-Za-z0-9_]+)</td><td>([^<]+)</td>");
  std::vector<std::smatch> rows;
  for (std::sregex_iterator i(page.begin(), page.end(), row), end; i != end; ++i) rows.push_back(*i);
  ASSERT_GE(rows.size(), 20u);
  std::mt19937 random(20260);
  for (int k = 0; k < 10; ++k) {
    const auto& cells = rows[random() % rows.size()];
    const auto found = mpmstudy::query(
        folder / "results", fmt::format("SELECT value FROM metrics WHERE key LIKE '{}%' AND name = '{}'",
                                        cells[1].str(), cells[2].str()));
    ASSERT_EQ(found.rows.size(), 1u) << cells[0];
    EXPECT_EQ(cells[3], fmt::format("{:.6g}", std::get<double>(found.rows[0][0]))) << cells[2];
  }
}

TEST_F(Report, LoadsNothingAndEscapesWhatItQuotes) {
  EXPECT_THAT(page, Not(HasSubstr("http://")));
  EXPECT_THAT(page, Not(HasSubstr("https://")));
  EXPECT_THAT(page, Not(HasSubstr("src=\"/")));
  EXPECT_THAT(page, HasSubstr("A reading: &quot;this&quot; &amp; that &lt;so&gt;."));
  std::size_t images = 0;
  for (std::size_t at = page.find("src=\"data:image/"); at != std::string::npos;
       at = page.find("src=\"data:image/", at + 1))
    ++images;
  EXPECT_EQ(images, 5u);  // two jobs of `fields`, each also in grey, and the history
  EXPECT_THAT(page, HasSubstr("physics version"));
}

TEST_F(Report, ClaimsReachTheCatalog) {
  const auto rows = mpmstudy::query(folder / "results", "SELECT name, verdict FROM claims");
  EXPECT_GE(rows.rows.size(), 15u);
  for (const auto& row : rows.rows)
    EXPECT_EQ(row[1], mpmstudy::SqlValue("not run")) << std::get<std::string>(row[0]);
}

}  // namespace
