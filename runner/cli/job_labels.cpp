#include "runner/cli/job_labels.hpp"

#include <algorithm>

#include "runner/status/label.hpp"

namespace mpmstudy {

JobLabels::JobLabels(const std::vector<Study>& studies) {
  for (const Study& study : studies) {
    std::vector<std::string> names;  // the searched value first: no line is too short for it
    if (study.search) names.push_back(study.search->critical);
    names.insert(names.end(), study.swept.begin(), study.swept.end());
    if (study.ladder.cells > 1 && std::ranges::find(names, "cell_size") == names.end())
      names.emplace_back("cell_size");
    names_.push_back(std::move(names));
  }
}

void JobLabels::add(const std::vector<Job>& jobs, std::size_t study) {
  if (names_.size() == 1) return;
  std::lock_guard lock(mutex_);
  for (const Job& job : jobs) study_of_.emplace(job.key, study);
}

std::string JobLabels::operator()(const Job& job) const {
  const auto study = [&] {
    std::lock_guard lock(mutex_);
    const auto found = study_of_.find(job.key);
    return found == study_of_.end() ? 0 : found->second;
  }();
  return label_of(job.scene, names_.at(study));
}

}  // namespace mpmstudy
