#include "runner/paper/claims.hpp"

#include <string>
#include <vector>

#include "runner/finish/evidence.hpp"
#include "runner/paper/subjects.hpp"
#include "runner/paper/verdict.hpp"

namespace mpmstudy {

std::vector<Claim> judge_claims(const std::filesystem::path& results, const std::vector<Study>& studies) {
  const Evidence e(results, studies);
  std::vector<Claim> claims = {
      initial_pressure(e),  shock_outruns_wall(e), jet_overtakes(e),   jet_hot_spot(e), vortex_hot_spots(e),
      wall_broken(e),       new_cavities(e),       coalescence(e),     parabola(e),     critical_values(e),
      incomplete(e),        less_along_shock(e),   lower_part(e),      isotropic(e),    hottest_below(e),
      falls_with_radius(e), falls_with_yield(e),   scale_invariance(e)};
  for (Claim& c : claims) {
    if (c.verdict != not_run) continue;
    const StudyStanding& own = e.standing(c.study);
    if (own.standing == Standing::undecided) c.verdict = "not decided";
    c.measured = own.why;
    if (const auto flags = e.flags(c.study)) {
      c.verdict = "not decided";
      c.measured = *flags;
    }
    // The jet is held against the shock of another study.
    if (c.name == "jet-overtakes-shock" && own.standing == Standing::whole)
      c.measured = "planar-impact: " + e.standing("planar-impact").why;
  }
  return claims;
}

const std::vector<std::string>& studies_of_claims() {
  static const std::vector<std::string> names = {
      "planar-impact",        "two-body-jet",    "strong-collapse", "critical-speed",
      "critical-speed-spall", "weak-collapse",   "symmetry",        "collapsibility-radius",
      "collapsibility-yield", "scale-invariance"};
  return names;
}

}  // namespace mpmstudy
