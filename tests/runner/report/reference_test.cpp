// A fresh quick run against the committed tables of the last reproduction, within the error bars of both.
#include <gtest/gtest.h>
#include <stdlib.h>

#include <array>
#include <cmath>
#include <cstdio>
#include <filesystem>
#include <fstream>
#include <map>
#include <sstream>

#include "runner/catalog/query.hpp"

namespace {

namespace fs = std::filesystem;

/// A row of results/reference/collapsibility.csv.
struct Row {
  std::string study;
  int position;
  double value, error;
};

std::vector<Row> reference() {
  std::ifstream file(SOURCE_DIR "/results/reference/collapsibility.csv");
  std::string line;
  std::getline(file, line);
  if (line.ends_with('\r')) line.pop_back();  // RFC 4180 ends lines so
  EXPECT_EQ(line, "study,position,cell_size_m,collapsibility,collapsibility_error");
  std::vector<Row> rows;
  while (std::getline(file, line)) {
    std::istringstream cells(line);
    std::string study, position, cell, value, error;
    std::getline(cells, study, ',');
    std::getline(cells, position, ',');
    std::getline(cells, cell, ',');
    std::getline(cells, value, ',');
    std::getline(cells, error, ',');
    rows.push_back({study, std::stoi(position), std::stod(value), std::stod(error)});
  }
  return rows;
}

TEST(Reference, AQuickRunAgreesWithinTheErrorBars) {
  std::array<char, 40> name{"/tmp/reference-test-XXXXXX"};
  const fs::path results = mkdtemp(name.data());
  const std::string studies =
      SOURCE_DIR "/studies/weak-collapse.toml " SOURCE_DIR "/studies/collapsibility-radius.toml";
  const std::string command =
      std::string(MPMSTUDY) + " run -q --cells 1.4 " + studies + " --results " + results.string();
  ASSERT_EQ(std::system((command + " > /dev/null").c_str()), 0);
  int compared = 0;
  for (const Row& row : reference()) {
    const mpmstudy::SqlValue parameters[] = {row.study, std::int64_t(row.position)};
    const auto found = mpmstudy::query(
        results, "SELECT collapsibility, collapsibility_error FROM jobs WHERE study = ?1 AND position = ?2",
        parameters);
    if (found.rows.empty()) continue;
    const double error = std::get<double>(found.rows[0][1]);
    EXPECT_NEAR(std::get<double>(found.rows[0][0]), row.value, std::hypot(row.error, error))
        << row.study << row.position;
    ++compared;
  }
  EXPECT_EQ(compared, 5);
  fs::remove_all(results);
}

}  // namespace
