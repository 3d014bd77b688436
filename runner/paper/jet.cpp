#include "runner/paper/subjects.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <optional>
#include <string>
#include <vector>

#include "runner/finish/evidence.hpp"
#include "runner/paper/snapshots.hpp"
#include "runner/paper/verdict.hpp"

namespace mpmstudy {
namespace {

/// A result of the planar impact at the speed of the two bodies.
std::optional<ValueWithError> at_1500(const Evidence& e, const std::string& result) {
  for (const ResultAt& one : e.results("planar-impact", result, "impact_speed"))
    if (one.parameter == 1500) return one.result;
  return std::nullopt;
}

}  // namespace

Claim initial_pressure(const Evidence& e) {
  Claim c = claim("initial-pressure", "Two bodies at 1500 m/s each: the initial pressure is about 30 GPa",
                  "planar-impact");
  if (const auto p = at_1500(e, "shock_pressure_Pa"))
    judge(c, is_within(*p, 30e9, 0.05), fmt::format("{:.2f} GPa", p->value / 1e9),
          "planar impact at the same particle speed; within 5 % counts");
  return c;
}

Claim shock_outruns_wall(const Evidence& e) {
  Claim c = claim("shock-outruns-wall",
                  "The shock at the sides of the cavity is faster than the deforming upstream wall",
                  "planar-impact");
  const auto shock = at_1500(e, "plastic_wave_speed_m_s"), surface = at_1500(e, "free_surface_speed_m_s");
  if (shock && surface)
    judge(c, shock->value > surface->value,
          fmt::format("shock {:.0f} m/s, free surface {:.0f} m/s, both against the material ahead",
                      shock->value, surface->value),
          "the wall at first moves as the free surface of a planar shock; later the jet is faster, see the "
          "next claim");
  return c;
}

Claim jet_overtakes(const Evidence& e) {
  Claim c =
      claim("jet-overtakes-shock",
            "The tip of the jet catches up with the shock at its sides, then exceeds it", "two-body-jet");
  const auto lead = e.result(c.study, "jet_lead_m"), jet = e.result(c.study, "jet_impact_time_s");
  // From the contact to the height of the cavity's far side.
  const auto job = e.first_done(c.study, {"cavity_center_height", "cavity_radius"});
  const auto speed = at_1500(e, "plastic_wave_speed_m_s");
  if (!lead || !jet || !job || !speed) return c;
  const double way = number_of(job->parameters[0]).value() + number_of(job->parameters[1]).value();
  const double shock = way / speed->value;
  judge(c, *lead > 0,
        fmt::format("the jet is at the far wall at {:.2f} ns, the shock at the sides passed it at {:.2f} ns",
                    *jet * 1e9, shock * 1e9),
        "holds if the tip is ahead at any time before it strikes, after the shock has passed it; by scale "
        "invariance only the distances between cavities and to the surfaces, which the paper does not give, "
        "could change it");
  return c;
}

Claim jet_hot_spot(const Evidence& e) {
  Claim c =
      claim("hot-spot-at-jet-tip", "At 2 ns the hot spot is in the region of the jet's tip", "two-body-jet");
  const auto impact = e.result(c.study, "jet_impact_time_s");
  for (const HotSpot& s : hot_spots_of(e, c.study))
    if (impact && s.time < *impact) {
      c.measured = fmt::format("at {:.1f} ns, {:.2f} um off the axis", s.time * 1e9, s.x * 1e6);
      c.verdict = s.x < 0.5e-6 ? holds : does_not_hold;
      c.note =
          "hottest thousandth of the mass by plastic work, in the last snapshot before the impact; within "
          "0.5 um counts";
    }
  return c;
}

Claim vortex_hot_spots(const Evidence& e) {
  Claim c = claim("hot-spots-in-vortices",
                  "After the impact the hot spots are at the centres of a pair of vortices", "two-body-jet");
  auto spots = hot_spots_of(e, c.study);
  const auto impact = e.result(c.study, "jet_impact_time_s");
  if (!impact) return c;
  std::erase_if(spots, [&](const HotSpot& s) { return s.time < *impact; });
  if (spots.empty()) return c;
  double turned = 0, nearest = spots.front().x;
  for (std::size_t i = 1; i < spots.size(); ++i) {
    turned += 0.5 * (spots[i].rotation + spots[i - 1].rotation) * (spots[i].time - spots[i - 1].time);
    nearest = std::min(nearest, spots[i].x);
  }
  judge(c, nearest > 0.2e-6 && std::abs(turned) > 1,
        fmt::format(
            "{:.2f} um on either side of the axis at {:.1f} ns; what is around them turns by {:.1f} rad "
            "from {:.1f} ns on, one to the left, the other to the right",
            spots.back().x * 1e6, spots.back().time * 1e9, std::abs(turned), spots.front().time * 1e9),
        "hottest thousandth of the mass by plastic work; more than 0.2 um off the axis in every snapshot "
        "after the impact, and more than a radian, count");
  return c;
}

}  // namespace mpmstudy
