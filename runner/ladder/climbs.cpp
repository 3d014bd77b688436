#include "runner/ladder/climbs.hpp"

#include "runner/study/ladder.hpp"

namespace mpmstudy {

Climbs::Climbs(CatalogWriter& writer, std::filesystem::path results, bool retry_failed)
    : writer_(writer), results_(std::move(results)), retry_failed_(retry_failed) {}

void Climbs::add(const Plan& plan) {
  if (!plan.ladder.accuracy) return;
  for (std::size_t position = 0; position < plan.ladders.size(); ++position) {
    Ladder ladder{plan.study, plan.ladder, plan.ladders[position], std::vector<RungState>(first_cells)};
    for (Job& rung : ladder.rungs) rung.rung_of = static_cast<std::int64_t>(position);
    ladders_.push_back(std::move(ladder));
  }
}

std::vector<Job> Climbs::next() {
  std::vector<Job> to_run;
  for (Ladder& ladder : ladders_) climb(ladder, to_run);
  return to_run;
}

void Climbs::look(Ladder& ladder) const {
  for (std::size_t i = 0; i < ladder.states.size(); ++i)
    if (!ladder.states[i].decided)
      ladder.states[i] = recorded(results_, ladder.rungs[i], ladder.request.quantity);
}

void Climbs::climb(Ladder& ladder, std::vector<Job>& to_run) {
  look(ladder);
  while (next_step(ladder.request, ladder.states) == NextStep::climb) {
    const Job& job = ladder.rungs[ladder.states.size()];
    const JobStatus status = writer_.add_finer(ladder.study, job, retry_failed_);
    ladder.states.emplace_back();
    if (status == JobStatus::done)
      ++reused_;
    else if (status == JobStatus::failed)
      ++left_failed_;
    else if (given_.insert(job.key).second)
      to_run.push_back(job);
    look(ladder);
  }
}

}  // namespace mpmstudy
