#pragma once
/// Which points of a sweep become jobs, and how many do not.
#include <cstdint>
#include <string>
#include <vector>

#include "runner/study/job_values.hpp"
#include "runner/study/scenes.hpp"

namespace mpmstudy {

/// Keeps references.
class WantedPoints {
 public:
  WantedPoints(const SceneRequest& request, const JobValues& value) : request_(request), value_(value) {}

  /// Whether all requirements hold for the job that `value` is at; counts it as skipped where one does not.
  bool wants(Mistakes&);
  /// Counts a point as skipped. `of`: null where it has no scene.
  void skip(const std::string& why, const std::string& first, const Requirement* of = nullptr);
  /// What was skipped; a mistake unless that is allowed and something is left.
  std::vector<SkippedPoints> end(bool nothing_left, std::uint64_t points, Mistakes&);

 private:
  std::string values_of(const Requirement&) const;

  const SceneRequest& request_;
  const JobValues& value_;
  std::vector<SkippedPoints> skipped_;
  std::vector<const Requirement*> requirements_;  ///< of skipped_; null: it has no scene
};

}  // namespace mpmstudy
