#include "libmpm/measure/jet.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

namespace mpm {
namespace {

constexpr ResultRow rows[] = {
    {.name = "jet_speed_m_s",
     .unit = "m/s",
     .meaning = "largest speed of the jet's tip (the cavity's upstream pole) up to its impact, against the "
                "material ahead; a planar shock leaves a surface with twice the impact speed"},
    {.name = "jet_lead_m",
     .unit = "m",
     .meaning =
         "largest height of the tip above the shock at the sides of the block; negative: it never overtook",
     .always = false},
    {.name = "jet_impact_time_s",
     .unit = "s",
     .symbol = "t",
     .meaning = "when less than a cell was left between the tip and the far wall",
     .always = false},
    {.name = "jet_overtake_time_s",
     .unit = "s",
     .symbol = "t",
     .meaning = "when the tip passed the shock at the sides",
     .always = false},
};

}  // namespace

template <int axes>
std::span<const ResultRow> BasicJet<axes>::results() {
  return rows;
}

template <int axes>
BasicJet<axes>::BasicJet(const Scene& s)
    : impact_speed_(s.impact_speed),
      side_(s.block_width / 2 - 2 * s.numerics.cell_size),
      cell_(s.numerics.cell_size) {}

template <int axes>
double BasicJet<axes>::shock_height(const BasicState<axes>& s) const {
  const auto& ps = s.particles;
  double shocked = -std::numeric_limits<double>::infinity(), highest = shocked;
  for (std::size_t p = 0; p < ps.size(); ++p) {
    double across = std::abs(ps.position[p].x());
    if constexpr (axes == 3) across = std::max(across, std::abs(ps.position[p].z()));
    if (across < side_) continue;
    const double y = ps.position[p].y();
    highest = std::max(highest, y);
    if (ps.velocity[p].y() > -0.5 * impact_speed_) shocked = std::max(shocked, y);
  }
  return highest - shocked < cell_ ? std::numeric_limits<double>::infinity() : shocked;
}

template <int axes>
void BasicJet<axes>::sample(const BasicState<axes>& s, double tip, double target) {
  if (impact_time_ >= 0) return;
  const double gap = target - tip;
  const double shock = shock_height(s);
  const double lead = tip - shock;
  if (time_ >= 0) {
    const double step = s.time - time_;
    if (gap < cell_) impact_time_ = time_ + step * (gap_ - cell_) / (gap_ - gap);
    speed_ = std::max(speed_, (tip - tip_) / step + impact_speed_);
    if (passed_ && std::isfinite(lead)) {
      if (lead > 0 && overtake_time_ < 0)
        overtake_time_ = std::isfinite(lead_) && lead_ < 0 ? time_ + step * lead_ / (lead_ - lead) : s.time;
      most_lead_ = led_ ? std::max(most_lead_, lead) : lead;
      led_ = true;
    }
  }
  passed_ |= lead <= 0;
  time_ = s.time;
  tip_ = tip;
  gap_ = gap;
  lead_ = lead;
}

template <int axes>
void BasicJet<axes>::finish(RunResult& result) const {
  auto& m = result.metrics;
  m.push_back(metric(row_of(rows, "jet_speed_m_s"), speed_));
  if (led_) m.push_back(metric(row_of(rows, "jet_lead_m"), most_lead_));
  if (impact_time_ >= 0) m.push_back(metric(row_of(rows, "jet_impact_time_s"), impact_time_));
  if (overtake_time_ >= 0) m.push_back(metric(row_of(rows, "jet_overtake_time_s"), overtake_time_));
}

template <int axes>
void BasicJet<axes>::carry(Archive& a) {
  a.number("time", time_), a.number("tip", tip_), a.number("gap", gap_), a.number("lead", lead_);
  a.number("speed", speed_), a.number("most_lead", most_lead_);
  a.number("impact_time", impact_time_), a.number("overtake_time", overtake_time_);
  a.integer("passed", passed_), a.integer("led", led_);
}

template class BasicJet<2>;
template class BasicJet<3>;

}  // namespace mpm
