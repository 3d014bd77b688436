#pragma once
#include <cstddef>
#include <mutex>
#include <string>
#include <unordered_map>
#include <vector>

#include "runner/plan/plan.hpp"
#include "runner/study/study.hpp"

namespace mpmstudy {

/// What sets a job apart within its study, for the lines of a run of several: the names that its own study
/// sweeps, the searched one, and the cell where there is a ladder of them. Any thread may ask.
class JobLabels {
 public:
  explicit JobLabels(const std::vector<Study>&);

  /// Jobs that are wanted belong to the study at this place of the list; the first one that asks for a job
  /// has it.
  void add(const std::vector<Job>&, std::size_t study);
  std::string operator()(const Job&) const;

 private:
  std::vector<std::vector<std::string>> names_;  ///< of each study
  std::unordered_map<std::string, std::size_t> study_of_;
  mutable std::mutex mutex_;  ///< of study_of_
};

}  // namespace mpmstudy
