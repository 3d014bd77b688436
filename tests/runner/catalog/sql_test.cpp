// SQL stands in runner/catalog/ alone: whoever asks has a typed answer. `mpmstudy query` passes on the SQL
// that a person writes, and its help names a verb of SQL.
#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>
#include <regex>
#include <string>

namespace mpmstudy {
namespace {

namespace fs = std::filesystem;

TEST(Sql, StandsInTheCatalogAlone) {
  const std::regex sql(R"(\b(SELECT|INSERT INTO|DELETE FROM|ORDER BY|GROUP BY|JOIN|WHERE|PRAGMA)\b)");
  const fs::path runner = fs::path(SOURCE_DIR) / "runner";
  int files = 0, in_catalog = 0;
  for (const auto& entry : fs::recursive_directory_iterator(runner)) {
    const fs::path path = entry.path().lexically_relative(runner);
    if (path.extension() != ".cpp" && path.extension() != ".hpp") continue;
    const bool may = *path.begin() == "catalog" || path == fs::path("cli") / "query.cpp";
    ++files;
    std::ifstream file(entry.path());
    int number = 0;
    for (std::string line; std::getline(file, line);) {
      ++number;
      if (!std::regex_search(line, sql)) continue;
      in_catalog += may;
      EXPECT_TRUE(may) << path << ":" << number << ": " << line;
    }
  }
  EXPECT_GT(files, 150);
  EXPECT_GT(in_catalog, 100);
}

}  // namespace
}  // namespace mpmstudy
