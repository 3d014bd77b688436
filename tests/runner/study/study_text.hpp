#pragma once
/// Studies as text, for tests.
#include <unistd.h>

#include <filesystem>
#include <fstream>
#include <string>
#include <utility>
#include <vector>

#include "runner/study/study.hpp"

namespace mpmstudy {

/// A file with this text, gone when it leaves its scope.
class TemporaryStudy {
 public:
  explicit TemporaryStudy(const std::string& text)
      : path_(std::filesystem::temp_directory_path() /
              ("study-test-" + std::to_string(::getpid()) + ".toml")) {
    std::ofstream(path_) << text;
  }
  ~TemporaryStudy() { std::filesystem::remove(path_); }
  TemporaryStudy(const TemporaryStudy&) = delete;
  TemporaryStudy& operator=(const TemporaryStudy&) = delete;
  const std::filesystem::path& path() const { return path_; }

 private:
  std::filesystem::path path_;
};

/// A valid study of one job; `changes` replace or add lines of [parameters], `rest` follows.
inline std::string study_text(const std::vector<std::pair<std::string, std::string>>& changes = {},
                              const std::string& rest = "") {
  std::vector<std::pair<std::string, std::string>> lines = {
      {"material", "\"aluminium\""}, {"impact_speed", "\"200 m/s\""}, {"block_width", "\"10 um\""},
      {"block_height", "\"6 um\""},  {"cavity_radius", "\"1.5 um\""}, {"cavity_center_height", "\"3 um\""},
      {"end_time", "\"16 ns\""}};
  for (const auto& [key, value] : changes) {
    bool replaced = false;
    for (auto& line : lines)
      if (line.first == key) {
        line.second = value;
        replaced = true;
      }
    if (!replaced) lines.emplace_back(key, value);
  }
  std::string text = "schema = 1\nname = \"test\"\nscene = \"cavity-impact\"\n[parameters]\n";
  for (const auto& [key, value] : lines)
    if (!value.empty()) text += key + " = " + value + "\n";
  if (rest.find("[numerics]") == std::string::npos) text += "[numerics]\ncell_size = \"0.1 um\"\n";
  return text + rest;
}

inline Study read_text(const std::string& text, const ReadOptions& options = {}) {
  return read_study(TemporaryStudy(text).path(), options);
}

/// What read_study says of it; empty if it is valid.
inline std::string problems_of(const std::string& text, const ReadOptions& options = {}) {
  try {
    read_text(text, options);
  } catch (const StudyError& error) {
    return error.what();
  }
  return "";
}

}  // namespace mpmstudy
