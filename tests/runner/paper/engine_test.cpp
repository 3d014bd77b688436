// The engine does not depend on the paper: apart from main.cpp, which joins them, runner/ outside
// runner/paper includes nothing of it and names none of its figures, claims and studies.
#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>
#include <regex>
#include <string>
#include <vector>

#include "runner/paper/claims.hpp"

namespace mpmstudy {
namespace {

namespace fs = std::filesystem;

/// What the engine may not say. Two names of studies are words of the engine, too: a kind of scene, and a
/// key.
std::regex words_of_the_paper() {
  std::string words = R"(\bfig[0-9]|\bFigs?\. ?[0-9]|\bpaper('s)?\b|\bPaper('s)?\b|\bXu\b)";
  for (const std::string& name : studies_of_claims())
    if (name != "planar-impact" && name != "symmetry") words += "|\\b" + name + "\\b";
  return std::regex(words);
}

TEST(Engine, NamesNothingOfThePaper) {
  const std::regex names = words_of_the_paper();
  const fs::path runner = fs::path(SOURCE_DIR) / "runner";
  int files = 0;
  for (const auto& entry : fs::recursive_directory_iterator(runner)) {
    const fs::path path = entry.path().lexically_relative(runner);
    const std::string folder = path.begin()->string(), end = path.extension().string();
    const bool text = end == ".cpp" || end == ".hpp" || end == ".md";
    // The problems of `bench accuracy` bear the names that its tables always had.
    if (!text || folder == "paper" || folder == "bench" || path == "main.cpp") continue;
    ++files;
    std::ifstream file(entry.path());
    int number = 0;
    for (std::string line; std::getline(file, line);) {
      ++number;
      EXPECT_FALSE(std::regex_search(line, names)) << path << ":" << number << ": " << line;
    }
  }
  EXPECT_GT(files, 150);
}

// `claim` is a word of the catalog alone: of its view `claims`.
TEST(Engine, HasNoClaims) {
  const std::regex claims(R"(\b[cC]laims?\b)");
  const fs::path runner = fs::path(SOURCE_DIR) / "runner";
  for (const char* folder :
       {"cli", "exec", "finish", "ladder", "plan", "search", "slurm", "status", "study", "bench"})
    for (const auto& entry : fs::recursive_directory_iterator(runner / folder)) {
      std::ifstream file(entry.path());
      for (std::string line; std::getline(file, line);)
        EXPECT_FALSE(std::regex_search(line, claims)) << entry.path() << ": " << line;
    }
}

TEST(Engine, IsLinkedWithoutThePaper) {
  const fs::path runner = fs::path(SOURCE_DIR) / "runner";
  for (const auto& entry : fs::recursive_directory_iterator(runner)) {
    if (entry.path().filename() != "CMakeLists.txt" || entry.path().parent_path() == runner ||
        entry.path().parent_path() == runner / "paper")
      continue;
    std::ifstream file(entry.path());
    for (std::string line; std::getline(file, line);)
      EXPECT_EQ(line.find("paper"), std::string::npos) << entry.path() << ": " << line;
  }
}

}  // namespace
}  // namespace mpmstudy
