// A fresh quick run against the committed tables: of the full reproduction, within the error bars of both,
// and of the quick one, within what a single run leaves open.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <fstream>
#include <map>
#include <sstream>
#include <string>
#include <vector>

#include "runner/catalog/query.hpp"
#include "tests/temporary_folder.hpp"

namespace {

namespace fs = std::filesystem;

/// A row of a table in results/reference, by the names of its columns.
using Row = std::map<std::string, std::string>;

std::vector<std::string> cells_of(std::string line) {
  if (line.ends_with('\r')) line.pop_back();  // RFC 4180 ends lines so
  std::vector<std::string> cells;
  std::istringstream in(line);
  for (std::string cell; std::getline(in, cell, ',');) cells.push_back(cell);
  return cells;
}

std::vector<Row> reference(const std::string& table) {
  std::ifstream file(SOURCE_DIR "/results/reference/" + table + ".csv");
  std::string line;
  std::getline(file, line);
  const auto names = cells_of(line);
  std::vector<Row> rows;
  while (std::getline(file, line)) {
    const auto cells = cells_of(line);
    EXPECT_EQ(cells.size(), names.size()) << line;
    Row& row = rows.emplace_back();
    for (std::size_t i = 0; i < std::min(cells.size(), names.size()); ++i) row[names[i]] = cells[i];
  }
  return rows;
}

TEST(Reference, AQuickRunAgreesWithinTheErrorBars) {
  const TemporaryFolder folder;
  const fs::path& results = folder.path();
  std::string command = std::string(MPMSTUDY) + " run -q --cells 1.4 --results " + results.string();
  for (const char* study : {"weak-collapse", "collapsibility-radius", "collapsibility-yield"})
    command += std::string(" " SOURCE_DIR "/studies/paper/") + study + ".toml";
  ASSERT_EQ(std::system((command + " > /dev/null").c_str()), 0);
  const auto compare = [&](const std::string& table, const std::string& error_column) {
    int compared = 0;
    for (const Row& row : reference(table)) {
      const mpmstudy::SqlValue parameters[] = {row.at("study"), std::int64_t(std::stoi(row.at("position")))};
      const auto found = mpmstudy::query(
          results,
          "SELECT a.value, a." + error_column +
              " FROM accuracy a JOIN jobs j ON j.key = a.key AND j.study = a.study WHERE j.study = ?1 AND "
              "j.position = ?2 AND a.quantity = 'collapsibility'",
          parameters);
      EXPECT_EQ(found.rows.size(), 1u) << row.at("study") << ' ' << row.at("position");
      if (found.rows.size() != 1) continue;
      const double value = std::get<double>(found.rows[0][0]), error = std::get<double>(found.rows[0][1]);
      EXPECT_NEAR(value, std::stod(row.at("value")), std::hypot(error, std::stod(row.at(error_column))))
          << table << ' ' << row.at("study") << ' ' << row.at("position");
      ++compared;
    }
    EXPECT_EQ(compared, 13) << table;
  };
  compare("collapsibility", "error");
  compare("collapsibility-quick", "measuring_error");
}

TEST(Reference, EveryPointOfFig8IsWithinTwoPerCent) {
  const auto rows = reference("collapsibility");
  EXPECT_EQ(rows.size(), 13u);
  for (const Row& row : rows) EXPECT_LT(std::stod(row.at("error")), 0.02 * std::stod(row.at("value")));
}

}  // namespace
