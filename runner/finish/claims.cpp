#include "runner/finish/claims.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "runner/finish/evidence.hpp"

namespace mpmstudy {
namespace {

constexpr const char* not_run = "not run";

Claim claim(std::string name, std::string sentence, std::string study) {
  return {std::move(name), std::move(sentence), std::move(study), "", not_run, ""};
}

void judge(Claim& c, bool holds, std::string measured, std::string note) {
  c.verdict = holds ? "holds" : "does not";
  c.measured = std::move(measured);
  c.note = std::move(note);
}

Claim initial_pressure(const Evidence& e) {
  Claim c = claim("initial-pressure", "Two bodies at 1500 m/s each: the initial pressure is about 30 GPa",
                  "planar-impact");
  const auto p = e.metric(c.study, "shock_pressure_Pa", "j.impact_speed_m_s = 1500");
  if (p)
    judge(c, std::abs(*p / 30e9 - 1) < 0.05, fmt::format("{:.2f} GPa", *p / 1e9),
          "planar impact at the same particle speed; within 5 % counts");
  return c;
}

Claim shock_outruns_wall(const Evidence& e) {
  Claim c = claim("shock-outruns-wall",
                  "The shock at the sides of the cavity is faster than the deforming upstream wall",
                  "planar-impact");
  const std::string at_1500 = "j.impact_speed_m_s = 1500";
  const auto shock = e.metric(c.study, "plastic_wave_speed_m_s", at_1500),
             surface = e.metric(c.study, "free_surface_speed_m_s", at_1500);
  if (shock && surface)
    judge(c, *shock > *surface,
          fmt::format("shock {:.0f} m/s, free surface {:.0f} m/s, both against the material ahead", *shock,
                      *surface),
          "the wall at first moves as the free surface of a planar shock; later the jet is faster, see the "
          "next claim");
  return c;
}

Claim jet_overtakes(const Evidence& e) {
  Claim c =
      claim("jet-overtakes-shock",
            "The tip of the jet catches up with the shock at its sides, then exceeds it", "two-body-jet");
  const auto lead = e.metric(c.study, "jet_lead_m"), speed = e.metric(c.study, "jet_speed_m_s");
  if (lead && speed)
    judge(c, *lead > 0,
          fmt::format("largest lead {:+.2f} um; jet at {:.0f} m/s against the material ahead", *lead * 1e6,
                      *speed),
          "until the jet strikes the far wall or the shock leaves the block; depends on where the cavity is, "
          "which the paper does not say");
  return c;
}

Claim jet_hot_spot(const Evidence& e) {
  Claim c =
      claim("hot-spot-at-jet-tip", "At 2 ns the hot spot is in the region of the jet's tip", "two-body-jet");
  const auto impact = e.metric(c.study, "jet_impact_time_s");
  for (const HotSpot& s : e.hot_spots(c.study))
    if (impact && s.time < *impact) {
      c.measured = fmt::format("at {:.1f} ns, {:.2f} um off the axis", s.time * 1e9, s.x * 1e6);
      c.verdict = s.x < 0.5e-6 ? "holds" : "does not";
      c.note =
          "hottest thousandth of the mass by plastic work, in the last snapshot before the impact; within "
          "0.5 um counts";
    }
  return c;
}

Claim vortex_hot_spots(const Evidence& e) {
  Claim c = claim("hot-spots-in-vortices",
                  "After the impact the hot spots are at the centres of a pair of vortices", "two-body-jet");
  const auto spots = e.hot_spots(c.study);
  if (spots.empty()) return c;
  const HotSpot& s = spots.back();
  judge(c, s.x > 0.2e-6,
        fmt::format("at {:.1f} ns, {:.2f} um on either side of the axis", s.time * 1e9, s.x * 1e6),
        "two spots off the axis, more than 0.2 um from it; their rotation is not measured");
  return c;
}

Claim wall_broken(const Evidence& e) {
  Claim c = claim("wall-broken", "At 1120 m/s the jet breaks the downstream wall, d = 3 um thick",
                  "strong-collapse");
  const auto outcome = e.text(
      c.study, "SELECT outcome FROM jobs WHERE study = ?1 AND status = 'done' ORDER BY position LIMIT 1");
  const auto margin = e.metric(c.study, "decision_margin");
  if (!outcome) return c;
  judge(c, *outcome == "ejected",
        *outcome + (margin ? fmt::format(", by {:+.0f} % of the impact speed", 100 * *margin) : ""),
        "no failure model in the paper: its wall parts by the grid. See the critical speeds of walls of "
        "stated spall strength");
  return c;
}

Claim new_cavities(const Evidence& e) {
  Claim c = claim("new-cavities",
                  "Rarefaction from the free surface opens new cavities around the place of the old one",
                  "strong-collapse");
  const auto count = e.metric(c.study, "new_cavities"), time = e.metric(c.study, "new_cavities_time_s");
  if (count)
    judge(c, *count > 0,
          fmt::format("{:.0f} at one time{}", *count,
                      time ? fmt::format(", the first at {:.2f} ns", *time * 1e9) : ""),
          "closed empty regions of four nodes or more");
  return c;
}

Claim coalescence(const Evidence& e) {
  Claim c = claim("coalescence", "The new cavities coalesce into a larger one", "strong-collapse");
  const auto most = e.metric(c.study, "new_cavities"), end = e.metric(c.study, "cavities_at_end");
  if (most && end)
    judge(c, *most > 1 && *end < *most, fmt::format("{:.0f} at one time, {:.0f} at the end", *most, *end),
          "");
  return c;
}

Claim parabola(const Evidence& e) {
  Claim c = claim("critical-speed-parabola",
                  "The critical impact speed increases parabolically with the wall's thickness d",
                  "critical-speed");
  const std::string where = "FROM fits WHERE study = ?1 AND quantity = 'critical_speed_extrapolated' ";
  const auto r2 = e.number(c.study, "SELECT r2 " + where + "LIMIT 1");
  const auto c2 = e.number(c.study, "SELECT value " + where + "AND coefficient = 'c2'");
  const auto error = e.number(c.study, "SELECT standard_error " + where + "AND coefficient = 'c2'");
  const auto u =
      e.numbers(c.study,
                "SELECT extrapolated_m_s FROM critical_speed WHERE study = ?1 AND extrapolated_m_s "
                "IS NOT NULL ORDER BY wall_thickness_m");
  if (!r2 || !c2) return c;
  judge(c, *r2 > 0.95 && std::ranges::is_sorted(u),
        fmt::format("r2 = {:.4f}; curvature {:.1f} ± {:.1f} (m/s)/um^2", *r2, *c2 * 1e-12,
                    error.value_or(0) * 1e-12),
        "critical speeds for cells of size 0, growing, with r2 above 0.95; where the curvature is within its "
        "error of 0 a straight line does as well");
  return c;
}

Claim incomplete(const Evidence& e) {
  Claim c =
      claim("incomplete-collapse", "At 200 m/s the cavity is not collapsed completely", "weak-collapse");
  const auto phi =
      e.number(c.study, "SELECT collapsibility FROM jobs WHERE study = ?1 AND status = 'done' LIMIT 1");
  const auto error =
      e.number(c.study, "SELECT collapsibility_error FROM jobs WHERE study = ?1 AND status = 'done' LIMIT 1");
  if (phi && error)
    judge(c, *phi + *error < 1, fmt::format("collapsibility {:.3f} ± {:.3f}", *phi, *error),
          "for the height of the block that its study states; see block-height");
  return c;
}

Claim less_along_shock(const Evidence& e) {
  Claim c =
      claim("less-collapse-along-shock",
            "Near the impact face the cavity collapses less along the shock than across it", "weak-collapse");
  if (const auto ratio = e.metric(c.study, "aspect_ratio"))
    judge(c, *ratio < 1, fmt::format("width / height {:.3f}", *ratio),
          "by the markers on its surface, at 16 ns");
  return c;
}

Claim lower_part(const Evidence& e) {
  Claim c = claim("lower-part-collapses-more",
                  "The lower part of the cavity collapses more, the more so the nearer the impact face",
                  "symmetry");
  const auto ratios = e.metrics(c.study, "lower_upper_area_ratio", "cavity_center_height_m");
  if (ratios.size() < 2) return c;
  judge(c, ratios[0] < 1 && ratios[0] < ratios.back(),
        fmt::format("area below / above the middle: {:.2f} nearest, {:.2f} farthest", ratios.front(),
                    ratios.back()),
        "");
  return c;
}

Claim isotropic(const Evidence& e) {
  Claim c = claim("isotropic-far-away", "Farther from the impact face the collapse is nearly isotropic",
                  "symmetry");
  const auto ratios =
      e.metrics(c.study, "aspect_ratio", "cavity_center_height_m", "j.cavity_center_height_m > 1.95e-6");
  if (ratios.empty()) return c;
  const double roundest =
      *std::ranges::min_element(ratios, {}, [](double r) { return std::abs(std::log(r)); });
  judge(c, std::abs(std::log(roundest)) < std::log(1.25),
        fmt::format("width / height {:.3f} where it is roundest, {:.3f} farthest", roundest, ratios.back()),
        "places farther than that of Fig. 5; within a quarter of 1 counts. Where the paper's cavity is, it "
        "does not say");
  return c;
}

Claim hottest_below(const Evidence& e) {
  Claim c = claim("hottest-below", "The hottest region is below the cavity", "weak-collapse");
  const auto spots = e.hot_spots(c.study);
  if (spots.empty()) return c;
  const HotSpot& s = spots.front();
  constexpr double center = 1.9e-6;
  judge(c, s.y < center - 200 * s.time,
        fmt::format("at {:.1f} ns, {:.2f} um above the wall, {:.2f} um off the axis", s.time * 1e9, s.y * 1e6,
                    s.x * 1e6),
        "hottest thousandth of the mass by plastic work, against where the cavity's centre would be without "
        "the shock");
  return c;
}

Claim falls_with_radius(const Evidence& e) {
  Claim c = claim("collapsibility-falls-with-radius",
                  "The collapsibility becomes larger when the cavity is smaller", "collapsibility-radius");
  const auto phi = e.collapsibilities(c.study, "cavity_radius_m");
  if (phi.size() > 1)
    judge(c, std::ranges::is_sorted(phi, std::greater<>()),
          fmt::format("{:.3f} to {:.3f}", phi.front(), phi.back()) + e.largest_interval(c.study),
          "at every radius");
  return c;
}

Claim falls_with_yield(const Evidence& e) {
  Claim c = claim("collapsibility-falls-with-yield",
                  "The collapsibility decreases parabolically with the initial yield stress",
                  "collapsibility-yield");
  const auto phi = e.collapsibilities(c.study, "yield_stress_Pa");
  const auto r2 =
      e.number(c.study, "SELECT r2 FROM fits WHERE study = ?1 AND quantity = 'collapsibility' LIMIT 1");
  if (phi.size() > 1 && r2)
    judge(c, std::ranges::is_sorted(phi, std::greater<>()) && *r2 > 0.99,
          fmt::format("{:.3f} to {:.3f}; parabola with r2 = {:.4f}", phi.front(), phi.back(), *r2) +
              e.largest_interval(c.study),
          "");
  return c;
}

Claim scale_invariance(const Evidence& e) {
  Claim c = claim("scale-invariance",
                  "The behaviour is the same if spatial and temporal scales are magnified alike",
                  "scale-invariance");
  const auto phi = e.collapsibilities(c.study, "position");
  if (phi.size() > 1)
    judge(c, std::ranges::all_of(phi, [&](double p) { return p == phi[0]; }),
          fmt::format("{:.17g} at {} scales", phi[0], phi.size()), "to the last bit");
  return c;
}

Claim critical_values(const Evidence& e) {
  Claim c = claim("critical-speed-values", "Fig. 4: the values of the critical speed", "critical-speed");
  const auto u =
      e.numbers(c.study,
                "SELECT extrapolated_m_s FROM critical_speed WHERE study = ?1 AND extrapolated_m_s IS NOT "
                "NULL ORDER BY wall_thickness_m");
  if (u.empty()) return c;
  c.verdict = "not comparable";
  c.measured = fmt::format("{:.0f} to {:.0f} m/s", u.front(), u.back());
  c.note =
      "the paper's numbers are in its figure only; cell, height and what counts as ejected are not given";
  return c;
}

}  // namespace

std::vector<Claim> judge_claims(const std::filesystem::path& results) {
  const Evidence e(results);
  return {initial_pressure(e), shock_outruns_wall(e), jet_overtakes(e), jet_hot_spot(e),
          vortex_hot_spots(e), wall_broken(e),        new_cavities(e),  coalescence(e),
          parabola(e),         critical_values(e),    incomplete(e),    less_along_shock(e),
          lower_part(e),       isotropic(e),          hottest_below(e), falls_with_radius(e),
          falls_with_yield(e), scale_invariance(e)};
}

}  // namespace mpmstudy
