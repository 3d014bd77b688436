#pragma once
/// The ladders of a run that an accuracy makes climb: from what the catalog has of their rungs to the jobs
/// that come next. Which those are depends on results only, not on who ran them nor in which order.
#include <filesystem>
#include <set>
#include <string>
#include <vector>

#include "runner/catalog/writer.hpp"
#include "runner/ladder/climb.hpp"
#include "runner/plan/plan.hpp"

namespace mpmstudy {

class Climbs {
 public:
  /// The writer enters finer cells; rungs are read from the catalog in `results`.
  Climbs(CatalogWriter&, std::filesystem::path results, bool retry_failed);

  /// Adds the ladders of a registered study; those of a study without an accuracy do not climb.
  void add(const Plan&);

  /// The finer cells that are wanted now and not decided, each once in this run. Every ladder goes as high as
  /// what is known says. Ladders that wait for a rung, are inside, or are at their end give none. Throws
  /// CatalogError.
  std::vector<Job> next();

  std::int64_t reused() const { return reused_; }            ///< finer cells that were done before
  std::int64_t left_failed() const { return left_failed_; }  ///< ... that had failed before

 private:
  struct Ladder {
    std::string study;
    LadderRequest request;
    std::vector<Job> rungs;         ///< coarse to fine: all that there may be
    std::vector<RungState> states;  ///< of those that were asked for
  };
  void look(Ladder&) const;
  void climb(Ladder&, std::vector<Job>& to_run);

  CatalogWriter& writer_;
  std::filesystem::path results_;
  bool retry_failed_;
  std::vector<Ladder> ladders_;
  std::set<std::string> given_;  // keys that next() has given
  std::int64_t reused_ = 0, left_failed_ = 0;
};

}  // namespace mpmstudy
