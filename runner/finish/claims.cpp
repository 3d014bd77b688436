#include "runner/finish/claims.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <string>
#include <vector>

#include "runner/finish/evidence.hpp"
#include "runner/finish/verdict.hpp"

namespace mpmstudy {
namespace {

Claim claim(std::string name, std::string sentence, std::string study) {
  return {std::move(name), std::move(sentence), std::move(study), "", not_run, ""};
}

/// Of a fit without a point to spare.
constexpr const char* says_nothing = "such a curve goes through any points, and says nothing of their course";

/// "0.965 ± 0.012"; the value alone where no interval is known.
std::string with_interval(const Measured& number, int decimals) {
  if (!number.error) return fmt::format("{:.{}f}", number.value, decimals);
  return fmt::format("{:.{}f} ± {:.{}f}", number.value, decimals, *number.error, decimals);
}

/// Whether a number is within `share` of a reference.
Truth is_within(const Measured& number, double reference, double share) {
  return is_below({std::abs(number.value / reference - 1),
                   number.error ? std::optional(*number.error / reference) : std::nullopt},
                  share);
}

Claim initial_pressure(const Evidence& e) {
  Claim c = claim("initial-pressure", "Two bodies at 1500 m/s each: the initial pressure is about 30 GPa",
                  "planar-impact");
  const auto p = e.measured(c.study, "shock_pressure_Pa", "position", "j.impact_speed_m_s = 1500");
  if (!p.empty())
    judge(c, is_within(p[0], 30e9, 0.05), fmt::format("{:.2f} GPa", p[0].value / 1e9),
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
  const auto lead = e.metric(c.study, "jet_lead_m"), jet = e.metric(c.study, "jet_impact_time_s");
  // From the contact to the height of the cavity's far side.
  const auto way = e.number(c.study,
                            "SELECT cavity_center_height_m + cavity_radius_m FROM jobs WHERE study = ?1 AND "
                            "status = 'done' ORDER BY position LIMIT 1");
  const auto speed = e.metric("planar-impact", "plastic_wave_speed_m_s", "j.impact_speed_m_s = 1500");
  if (!lead || !jet || !way || !speed) return c;
  const double shock = *way / *speed;
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
  const auto impact = e.metric(c.study, "jet_impact_time_s");
  for (const HotSpot& s : e.hot_spots(c.study))
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
  auto spots = e.hot_spots(c.study);
  const auto impact = e.metric(c.study, "jet_impact_time_s");
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

/// "1375 ± 80 m/s": the critical speed of the wall that is 3 um thick.
std::string critical_speed_at_3_um(const Evidence& e, const std::string& study, const std::string& spall) {
  const std::string where =
      "FROM critical_speed c JOIN jobs j ON j.key = c.upper_key AND j.study = c.study WHERE c.study = ?1 AND "
      "abs(c.wall_thickness_m - 3e-6) < 1e-9 AND c.extrapolated_m_s IS NOT NULL AND " +
      undoubted_sql("c.flags") + " AND " + spall;
  const auto u = e.number(study, "SELECT c.extrapolated_m_s " + where);
  const auto interval = e.number(study, "SELECT c.interval_m_s " + where);
  return u && interval ? fmt::format("{:.0f} ± {:.0f} m/s", *u, *interval) : "not run";
}

Claim wall_broken(const Evidence& e) {
  Claim c = claim("wall-broken", "At 1120 m/s the jet breaks the downstream wall, d = 3 um thick",
                  "strong-collapse");
  const auto outcome = e.text(
      c.study, "SELECT outcome FROM jobs WHERE study = ?1 AND status = 'done' ORDER BY position LIMIT 1");
  const auto margin = e.metric(c.study, "decision_margin"),
             open = e.metric(c.study, "cavity_joined_outside_time_s");
  const auto cell = e.number(
      c.study, "SELECT cell_size_m FROM jobs WHERE study = ?1 AND status = 'done' ORDER BY position LIMIT 1");
  if (!outcome || !cell) return c;
  // The wall parts where particles are farther apart than a cell: one that is whole on a coarse cell may be
  // broken on a finer one.
  constexpr double finest_cell = 0.0505e-6;  // of the reference, with room for rounding
  const Truth whole = *cell > finest_cell ? Truth::open : Truth::no;
  judge(
      c, open || *outcome == "ejected" ? Truth::yes : whole,
      (open ? fmt::format("cavity open to the outside from {:.1f} ns on", *open * 1e9)
            : fmt::format("the wall stays whole on cells of {:.3g} um", *cell * 1e6)) +
          "; what is above it is " + *outcome +
          (margin ? fmt::format(", by {:+.0f} % of the impact speed", 100 * *margin) : "") +
          ". Ejection takes " + critical_speed_at_3_um(e, "critical-speed", "1") +
          ", with a spall strength of 1 GPa " +
          critical_speed_at_3_um(e, "critical-speed-spall", "j.spall_strength_Pa = 1e9") + ", of 3 GPa " +
          critical_speed_at_3_um(e, "critical-speed-spall", "j.spall_strength_Pa = 3e9"),
      "broken: the cavity is open, or material is ejected. The paper has no failure model: its wall parts by "
      "the grid, and so does ours, later on coarser cells. Critical speeds for cells of size 0");
  return c;
}

/// The snapshot, after the jet has struck, in which least is empty; end() if the jet does not strike.
std::vector<Cavities>::const_iterator filled(const Evidence& e, const std::vector<Cavities>& cavities,
                                             const std::string& study) {
  const auto impact = e.metric(study, "jet_impact_time_s");
  const auto after =
      std::ranges::find_if(cavities, [&](const Cavities& at) { return impact && at.time > *impact; });
  return std::ranges::min_element(after, cavities.end(), {}, &Cavities::total);
}

Claim new_cavities(const Evidence& e) {
  Claim c = claim("new-cavities",
                  "Rarefaction from the free surface opens new cavities around the place of the old one",
                  "strong-collapse");
  const auto cavities = e.cavities(c.study);
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
  const auto cavities = e.cavities(c.study);
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

/// Critical speeds for cells of size 0, by wall thickness.
std::vector<Measured> extrapolated_speeds(const Evidence& e, const std::string& study) {
  return e.with_errors(study,
                       "SELECT extrapolated_m_s, interval_m_s FROM critical_speed WHERE study = ?1 AND "
                       "extrapolated_m_s IS NOT NULL AND " +
                           undoubted_sql() + " ORDER BY wall_thickness_m");
}

Claim parabola(const Evidence& e) {
  Claim c = claim("critical-speed-parabola",
                  "The critical impact speed increases parabolically with the wall's thickness d",
                  "critical-speed");
  const std::string where = "FROM fits WHERE study = ?1 AND quantity = 'critical_speed_extrapolated' ";
  const auto r2 = e.number(c.study, "SELECT r2 " + where + "LIMIT 1"),
             chi2 = e.number(c.study, "SELECT reduced_chi2 " + where + "LIMIT 1"),
             c2 = e.number(c.study, "SELECT value " + where + "AND coefficient = 'c2'"),
             error = e.number(c.study, "SELECT standard_error " + where + "AND coefficient = 'c2'");
  const auto finest = e.numbers(
      c.study,
      "SELECT 0.5 * (lower_m_s + upper_m_s) FROM critical_speed WHERE study = ?1 AND extrapolated_m_s "
      "IS NOT NULL AND " +
          undoubted_sql() + " ORDER BY wall_thickness_m");
  const auto speeds = extrapolated_speeds(e, c.study);
  if (!c2 || speeds.empty()) return c;
  if (!r2) {
    judge(c, Truth::open, "a parabola through as many points as it has coefficients", says_nothing);
    return c;
  }
  double widest = 0;
  for (const Measured& u : speeds) widest = std::max(widest, u.error.value_or(0));
  const bool seen = *r2 > 0.95 && std::ranges::is_sorted(finest) && *c2 > error.value_or(0);
  // Scatter that the intervals allow says nothing against a parabola.
  const bool allowed = chi2 && *chi2 <= 1;
  judge(
      c,
      seen      ? Truth::yes
      : allowed ? Truth::open
                : Truth::no,
      fmt::format(
          "weighted r2 = {:.4f}; curvature {:.1f}, standard error {:.1f} (m/s)/um^2; intervals of up "
          "to ± {:.0f} m/s{}",
          *r2, *c2 * 1e-12, error.value_or(0) * 1e-12, widest,
          chi2 ? fmt::format(", of which the scatter about the parabola is {:.2g}", std::sqrt(*chi2)) : ""),
      "holds: critical speeds that grow on the finest cell, r2 above 0.95 for the parabola through those for "
      "cells of size 0, and a curvature beyond its standard error. Not decided: one of these is not so, but "
      "the scatter is within the intervals");
  return c;
}

Claim incomplete(const Evidence& e) {
  Claim c =
      claim("incomplete-collapse", "At 200 m/s the cavity is not collapsed completely", "weak-collapse");
  const auto phi = e.collapsibilities(c.study, "position");
  const auto outcome = e.text(
      c.study, "SELECT outcome FROM jobs WHERE study = ?1 AND status = 'done' ORDER BY position LIMIT 1");
  if (phi.empty()) return c;
  // A share has no room above 1: only a cavity that was seen to close is collapsed completely.
  const Truth below = is_below(phi[0], 1);
  const bool closed = outcome && *outcome == "collapsed";
  judge(c,
        below == Truth::yes ? Truth::yes
        : closed            ? Truth::no
                            : Truth::open,
        "collapsibility " + with_interval(phi[0], 3),
        "for the height of the block that its study states; see block-height");
  return c;
}

Claim less_along_shock(const Evidence& e) {
  Claim c =
      claim("less-collapse-along-shock",
            "Near the impact face the cavity collapses less along the shock than across it", "weak-collapse");
  if (const auto ratio = e.measured(c.study, "aspect_ratio", "position"); !ratio.empty())
    judge(c, is_below(ratio[0], 1), "width / height " + with_interval(ratio[0], 3),
          "by the markers on its surface, at 16 ns");
  return c;
}

Claim lower_part(const Evidence& e) {
  Claim c =
      claim("lower-part-collapses-more",
            "The lower part of the cavity collapses more, the more so nearer the impact face than in Fig. 5",
            "symmetry");
  const auto ratios = e.measured(c.study, "lower_upper_area_ratio", "cavity_center_height_m",
                                 "j.cavity_center_height_m < 1.95e-6");
  if (ratios.size() != 2) return c;
  judge(c, both(falls(std::vector{ratios[1], ratios[0]}), is_below(ratios[1], 1)),
        fmt::format("area below / above its middle: {} tangent to the face, {} where Fig. 5 has it",
                    with_interval(ratios[0], 3), with_interval(ratios[1], 3)),
        "by the markers on its surface, at 16 ns. Far from the face the lower part collapses more too: the "
        "shock comes from there");
  return c;
}

Claim isotropic(const Evidence& e) {
  Claim c = claim("isotropic-far-away", "Farther from the impact face the collapse is nearly isotropic",
                  "symmetry");
  const auto ratios =
      e.measured(c.study, "aspect_ratio", "cavity_center_height_m", "j.cavity_center_height_m > 1.95e-6");
  if (ratios.empty()) return c;
  const auto distance = [](const Measured& r) { return std::abs(std::log(r.value)); };
  const Measured roundest = *std::ranges::min_element(ratios, {}, distance);
  const std::optional<double> relative =
      roundest.error ? std::optional(*roundest.error / roundest.value) : std::nullopt;
  judge(c, is_below({distance(roundest), relative}, std::log(1.25)),
        fmt::format("width / height {} where it is roundest, {} farthest", with_interval(roundest, 3),
                    with_interval(ratios.back(), 3)),
        "places farther than that of Fig. 5; within a quarter of 1 counts. Where the paper's cavity is, it "
        "does not say");
  return c;
}

Claim hottest_below(const Evidence& e) {
  Claim c = claim("hottest-below", "The hottest region is below the cavity", "weak-collapse");
  const auto spots = e.hot_spots(c.study);
  if (spots.empty()) return c;
  // Of the shadow of the cavity (1.9 um high, 1.5 um in radius), what lies between its middle and the wall.
  const auto below =
      std::ranges::count_if(spots, [](const HotSpot& s) { return s.y < 1.9e-6 && s.x < 1.5e-6; });
  const HotSpot& first = spots.front();
  judge(c, below == std::ssize(spots),
        fmt::format("in {} of {} snapshots; at {:.1f} ns {:.2f} um above the wall, {:.2f} um off the axis",
                    below, spots.size(), first.time * 1e9, first.y * 1e6, first.x * 1e6),
        "hottest thousandth of the mass by plastic work");
  return c;
}

Claim falls_with_radius(const Evidence& e) {
  Claim c = claim("collapsibility-falls-with-radius",
                  "The collapsibility becomes larger when the cavity is smaller", "collapsibility-radius");
  const auto phi = e.collapsibilities(c.study, "cavity_radius_m");
  if (phi.size() > 1)
    judge(c, falls(phi),
          fmt::format("{:.3f} to {:.3f}", phi.front().value, phi.back().value) + e.largest_interval(c.study),
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
  const auto chi2 = e.number(
      c.study, "SELECT reduced_chi2 FROM fits WHERE study = ?1 AND quantity = 'collapsibility' LIMIT 1");
  const auto fitted =
      e.number(c.study, "SELECT value FROM fits WHERE study = ?1 AND quantity = 'collapsibility' LIMIT 1");
  if (fitted && !r2)
    judge(c, Truth::open, "a parabola through as many points as it has coefficients", says_nothing);
  if (phi.size() > 1 && r2) {
    const Truth parabola = *r2 > 0.99 ? Truth::yes : chi2 && *chi2 <= 1 ? Truth::open : Truth::no;
    judge(
        c, both(falls(phi), parabola),
        fmt::format("{:.3f} to {:.3f}; parabola with r2 = {:.4f}", phi.front().value, phi.back().value, *r2) +
            e.largest_interval(c.study),
        "from one yield stress to the next, and r2 above 0.99");
  }
  return c;
}

Claim scale_invariance(const Evidence& e) {
  Claim c = claim("scale-invariance",
                  "The behaviour is the same if spatial and temporal scales are magnified alike",
                  "scale-invariance");
  const auto phi = e.collapsibilities(c.study, "position");
  if (phi.size() > 1)
    judge(c, std::ranges::all_of(phi, [&](const Measured& p) { return p.value == phi[0].value; }),
          fmt::format("{:.17g} at {} scales", phi[0].value, phi.size()), "to the last bit");
  return c;
}

/// By what share critical speeds change from the last cell but one to the last, on average over the
/// thicknesses: "7 % (plain)".
std::string change_with_cell(const Evidence& e, const std::string& study, const std::string& spall,
                             const std::string& label) {
  const auto change = e.number(
      study,
      "WITH b AS (SELECT c.wall_thickness_m d, c.cell_size_m h, 0.5 * (c.lower_m_s + c.upper_m_s) u FROM "
      "critical_speed c JOIN jobs j ON j.key = c.upper_key AND j.study = c.study WHERE c.study = ?1 AND " +
          spall +
          "), r AS (SELECT *, row_number() OVER (PARTITION BY d ORDER BY h) n FROM b) SELECT avg(abs(x.u - "
          "y.u) / x.u) FROM r x JOIN r y ON x.d = y.d AND x.n = 1 AND y.n = 2");
  return change ? fmt::format("{:.0f} % ({})", 100 * *change, label) : "";
}

Claim critical_values(const Evidence& e) {
  Claim c = claim("critical-speed-values", "Fig. 4: the values of the critical speed", "critical-speed");
  const auto of_points = [&](const std::string& what) {
    return e.numbers(c.study, "SELECT " + what +
                                  " FROM critical_speed WHERE study = ?1 AND extrapolated_m_s "
                                  "IS NOT NULL AND " +
                                  undoubted_sql() + " ORDER BY wall_thickness_m");
  };
  const auto d = of_points("1e6 * wall_thickness_m"), u = of_points("extrapolated_m_s"),
             interval = of_points("interval_m_s"), found = of_points("0.5 * (lower_m_s + upper_m_s)");
  if (u.empty()) return c;
  c.verdict = not_comparable;
  c.measured = fmt::format(
      "{:.0f} ± {:.0f} m/s at d = {:.3g} um to {:.0f} ± {:.0f} m/s at {:.3g} um; on the finest cell "
      "{:.0f} to {:.0f} m/s",
      u.front(), interval.front(), d.front(), u.back(), interval.back(), d.back(), found.front(),
      found.back());
  std::vector<std::string> changes = {
      change_with_cell(e, c.study, "1", "plain"),
      change_with_cell(e, "critical-speed-spall", "j.spall_strength_Pa = 1e9", "1 GPa"),
      change_with_cell(e, "critical-speed-spall", "j.spall_strength_Pa = 3e9", "3 GPa")};
  std::erase(changes, "");
  if (!changes.empty())
    c.measured += fmt::format("; the last cell changed them by {}", fmt::join(changes, ", "));
  c.note =
      "the paper's numbers are in its figure only; cell, height and what counts as ejected are not given. "
      "What changes "
      "with the cell is a property of the mesh";
  return c;
}

}  // namespace

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
    if (const auto flags =
            e.text(c.study,
                   "SELECT flags FROM jobs WHERE study = ?1 AND status = 'done' AND flags <> '' "
                   "ORDER BY position LIMIT 1");
        flags && own.standing == Standing::whole) {
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
