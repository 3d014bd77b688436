#include "runner/paper/subjects.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <string>
#include <vector>

#include "runner/finish/evidence.hpp"
#include "runner/paper/verdict.hpp"

namespace mpmstudy {
namespace {

/// Critical speeds for cells of size 0, by wall thickness.
std::vector<Measured> extrapolated_speeds(const Evidence& e, const std::string& study) {
  return e.with_errors(study,
                       "SELECT extrapolated_m_s, interval_m_s FROM critical_speed WHERE study = ?1 AND "
                       "extrapolated_m_s IS NOT NULL AND " +
                           undoubted_sql() + " ORDER BY wall_thickness_m");
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

}  // namespace

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

}  // namespace mpmstudy
