#pragma once
#include <gtest/gtest.h>

#include <cstdlib>
#include <fstream>
#include <map>
#include <sstream>
#include <string>
#include <vector>

/// A row of tests/data/reference/<name>: column name -> text. Lines that start with # are comments.
using CsvRow = std::map<std::string, std::string>;

inline std::vector<std::string> split_at_commas(const std::string& line) {
  std::vector<std::string> words;
  std::istringstream in(line);
  for (std::string word; std::getline(in, word, ',');) words.push_back(word);
  return words;
}

inline std::vector<CsvRow> read_reference(const std::string& name) {
  const std::string path = SOURCE_DIR "/tests/data/reference/" + name;
  std::ifstream in(path);
  if (!in) ADD_FAILURE() << "cannot open " << path;
  std::vector<std::string> header;
  std::vector<CsvRow> rows;
  for (std::string line; std::getline(in, line);) {
    if (line.starts_with('#')) continue;
    const std::vector<std::string> words = split_at_commas(line);
    if (header.empty()) {
      header = words;
      continue;
    }
    CsvRow row;
    for (std::size_t i = 0; i < words.size(); ++i) row[header.at(i)] = words[i];
    rows.push_back(row);
  }
  return rows;
}

inline double number(const CsvRow& row, const std::string& column) {
  return std::strtod(row.at(column).c_str(), nullptr);
}

/// Relative; the columns carry six or seven digits.
inline void expect_close(double value, const CsvRow& row, const std::string& column, double unit,
                         double tolerance) {
  const double expected = number(row, column) * unit;
  EXPECT_NEAR(value, expected, tolerance * std::abs(expected)) << column;
}
