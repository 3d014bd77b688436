#include "runner/ladder/ladder_planner.hpp"

#include <utility>

#include "runner/study/ladder.hpp"

namespace mpmstudy {

LadderPlanner::LadderPlanner(const Plan& plan) : request_(plan.ladder), first_(first_jobs(plan)) {
  for (std::size_t position = 0; position < plan.ladders.size(); ++position) {
    Ladder ladder{plan.ladders[position], std::vector<RungState>(first_cells)};
    for (std::size_t k = first_cells; k < ladder.rungs.size(); ++k) {
      ladder.rungs[k].rung_of = static_cast<std::int64_t>(position);
      ladder.rungs[k].finer = true;
    }
    ladders_.push_back(std::move(ladder));
  }
}

std::vector<Job> LadderPlanner::next(const Answers& answers) {
  if (!first_.empty()) return std::exchange(first_, {});
  std::vector<Job> wanted;
  for (Ladder& ladder : ladders_) climb(ladder, answers, wanted);
  return wanted;
}

void LadderPlanner::look(Ladder& ladder, const Answers& answers) const {
  for (std::size_t i = 0; i < ladder.states.size(); ++i) {
    RungState& state = ladder.states[i];
    const Job& rung = ladder.rungs[i];
    if (state.decided || !answers.of(rung.key)) continue;
    state.decided = true;
    if (const auto reading = answers.reading(rung.key, request_.quantity))
      state.point = {rung.scene.numerics.cell_size, reading->value, reading->error};
  }
}

void LadderPlanner::climb(Ladder& ladder, const Answers& answers, std::vector<Job>& wanted) const {
  look(ladder, answers);
  const Climb climb = next_step(request_, ladder.states);
  if (climb.step != NextStep::climb) return;
  wanted.push_back(ladder.rungs[ladder.states.size()]);
  wanted.back().reason = climb.reason;
  ladder.states.emplace_back();
}

}  // namespace mpmstudy
