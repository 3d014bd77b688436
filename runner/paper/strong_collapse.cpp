#include "runner/paper/subjects.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <string>
#include <vector>

#include "runner/finish/evidence.hpp"
#include "runner/paper/snapshots.hpp"
#include "runner/paper/verdict.hpp"

namespace mpmstudy {
namespace {

/// The snapshot, after the jet has struck, in which least is empty; end() if the jet does not strike.
std::vector<Cavities>::const_iterator filled(const Evidence& e, const std::vector<Cavities>& cavities,
                                             const std::string& study) {
  const auto impact = e.result(study, "jet_impact_time_s");
  const auto after =
      std::ranges::find_if(cavities, [&](const Cavities& at) { return impact && at.time > *impact; });
  return std::ranges::min_element(after, cavities.end(), {}, &Cavities::total);
}

}  // namespace

Claim wall_broken(const Evidence& e) {
  Claim c = claim("wall-broken", "At 1120 m/s the jet breaks the downstream wall, d = 3 um thick",
                  "strong-collapse");
  const auto job = e.first_done(c.study, {"cell_size"});
  const auto margin = e.result(c.study, "decision_margin"),
             open = e.result(c.study, "cavity_joined_outside_time_s");
  if (!job || job->outcome.empty()) return c;
  const std::string& outcome = job->outcome;
  const double cell = number_of(job->parameters[0]).value();
  // The wall parts where particles are farther apart than a cell: one that is whole on a coarse cell may be
  // broken on a finer one.
  constexpr double finest_cell = 0.0505e-6;  // of the reference, with room for rounding
  const Truth whole = cell > finest_cell ? Truth::open : Truth::no;
  judge(
      c, open || outcome == "ejected" ? Truth::yes : whole,
      (open ? fmt::format("cavity open to the outside from {:.1f} ns on", *open * 1e9)
            : fmt::format("the wall stays whole on cells of {:.3g} um", cell * 1e6)) +
          "; what is above it is " + outcome +
          (margin ? fmt::format(", by {:+.0f} % of the impact speed", 100 * *margin) : "") +
          ". Ejection takes " + critical_speed_at_3_um(e, "critical-speed", {}) +
          ", with a spall strength of 1 GPa " + critical_speed_at_3_um(e, "critical-speed-spall", 1e9) +
          ", of 3 GPa " + critical_speed_at_3_um(e, "critical-speed-spall", 3e9),
      "broken: the cavity is open, or material is ejected. The paper has no failure model: its wall parts by "
      "the grid, and so does ours, later on coarser cells. Critical speeds for cells of size 0");
  return c;
}

Claim new_cavities(const Evidence& e) {
  Claim c = claim("new-cavities",
                  "Rarefaction from the free surface opens new cavities around the place of the old one",
                  "strong-collapse");
  const auto cavities = cavities_of(e, c.study);
  const auto least = filled(e, cavities, c.study);
  if (least == cavities.end()) return c;
  const auto most = std::ranges::max_element(least, cavities.end(), {}, &Cavities::total);
  judge(c, most->count > 0 && most->total > 10 * least->total,
        fmt::format("{:.2f} um^2 are empty at {:.1f} ns, {:.2f} um^2 at {:.1f} ns", least->total * 1e12,
                    least->time * 1e9, most->total * 1e12, most->time * 1e9),
        "closed empty regions of a cell or more in the snapshots, both halves of the block; ten times as "
        "much as when the old cavity is filled counts");
  return c;
}

Claim coalescence(const Evidence& e) {
  Claim c = claim("coalescence", "The new cavities coalesce into a larger one", "strong-collapse");
  const auto cavities = cavities_of(e, c.study);
  const auto least = filled(e, cavities, c.study);
  const auto apart = std::find_if(
      least, cavities.end(), [](const Cavities& at) { return at.count > 1 && at.largest < 0.75 * at.total; });
  const auto one =
      std::find_if(apart, cavities.end(), [](const Cavities& at) { return at.largest > 0.75 * at.total; });
  if (least == cavities.end()) return c;
  if (one == cavities.end())
    judge(c, false, apart == cavities.end() ? "never several" : "they stay apart", "");
  else
    judge(c, one->largest > apart->largest,
          fmt::format("{} at {:.1f} ns, the largest of {:.2f} um^2; at {:.1f} ns one of {:.2f} um^2, {:.0f} "
                      "% of what is empty",
                      apart->count, apart->time * 1e9, apart->largest * 1e12, one->time * 1e9,
                      one->largest * 1e12, 100 * one->largest / one->total),
          "counted as above; one that has three quarters of what is empty counts");
  return c;
}

}  // namespace mpmstudy
