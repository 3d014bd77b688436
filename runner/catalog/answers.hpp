#pragma once
/// What a catalog has, for planners.
#include <filesystem>
#include <memory>

#include "runner/plan/planner.hpp"

namespace mpmstudy {

/// Each call sees what is committed then. Jobs of every study are known, by key. For one thread.
class CatalogAnswers : public Answers {
 public:
  /// For a folder without a catalog every answer is empty. Throws CatalogError, as every call does.
  explicit CatalogAnswers(const std::filesystem::path& results);
  ~CatalogAnswers() override;

  std::optional<Answer> of(const std::string& key) const override;
  std::optional<Reading> reading(const std::string& key, const std::string& quantity) const override;
  std::string flags(const std::string& key) const override;

 private:
  struct Impl;
  std::unique_ptr<Impl> impl_;
};

}  // namespace mpmstudy
