// A fresh quick run against the committed table of the last full reproduction, within the error bars of both.
#include <gtest/gtest.h>
#include <stdlib.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <filesystem>
#include <fstream>
#include <map>
#include <sstream>
#include <string>
#include <vector>

#include "runner/catalog/query.hpp"

namespace {

namespace fs = std::filesystem;

/// A row of results/reference/collapsibility.csv, by the names of its columns.
using Row = std::map<std::string, std::string>;

std::vector<std::string> cells_of(std::string line) {
  if (line.ends_with('\r')) line.pop_back();  // RFC 4180 ends lines so
  std::vector<std::string> cells;
  std::istringstream in(line);
  for (std::string cell; std::getline(in, cell, ',');) cells.push_back(cell);
  return cells;
}

std::vector<Row> reference() {
  std::ifstream file(SOURCE_DIR "/results/reference/collapsibility.csv");
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
  std::array<char, 40> name{"/tmp/reference-test-XXXXXX"};
  const fs::path results = mkdtemp(name.data());
  std::string command = std::string(MPMSTUDY) + " run -q --cells 1.4 --results " + results.string();
  for (const char* study : {"weak-collapse", "collapsibility-radius", "collapsibility-yield"})
    command += std::string(" " SOURCE_DIR "/studies/") + study + ".toml";
  ASSERT_EQ(std::system((command + " > /dev/null").c_str()), 0);
  int compared = 0;
  for (const Row& row : reference()) {
    const mpmstudy::SqlValue parameters[] = {row.at("study"), std::int64_t(std::stoi(row.at("position")))};
    const auto found = mpmstudy::query(
        results,
        "SELECT a.extrapolated_value, a.extrapolated_error FROM accuracy a JOIN jobs j ON j.key = a.key AND "
        "j.study = a.study WHERE j.study = ?1 AND j.position = ?2 AND a.quantity = 'collapsibility'",
        parameters);
    ASSERT_EQ(found.rows.size(), 1u) << row.at("study") << ' ' << row.at("position");
    const double value = std::get<double>(found.rows[0][0]), error = std::get<double>(found.rows[0][1]);
    const double full = std::stod(row.at("extrapolated_value")),
                 full_error = std::stod(row.at("extrapolated_error"));
    const double both = std::hypot(error, full_error);
    EXPECT_NEAR(value, full, both) << row.at("study") << ' ' << row.at("position");
    EXPECT_LT(both, 0.05 * full) << "so wide that nothing would be seen";
    EXPECT_LT(full_error, 0.02 * full) << "the full reproduction is within 2 %";
    ++compared;
  }
  EXPECT_EQ(compared, 13);
  fs::remove_all(results);
}

}  // namespace
