#include "runner/paper/subjects.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <optional>
#include <string>
#include <vector>

#include "runner/finish/evidence.hpp"
#include "runner/paper/verdict.hpp"

namespace mpmstudy {
namespace {

/// Critical speeds that are known for cells of size 0, by wall thickness.
std::vector<CriticalSpeed> known_speeds(const Evidence& e, const std::string& study) {
  auto speeds = e.critical_speeds(study, "spall_strength");
  std::erase_if(speeds, [](const CriticalSpeed& u) { return !u.extrapolated || is_doubtful(u.flags); });
  return speeds;
}

double middle(const CriticalSpeed& u) { return 0.5 * (*u.lower + *u.upper); }

bool has(const CriticalSpeed& u, std::optional<double> spall_strength) {
  return u.proven && (!spall_strength || u.parameter == spall_strength);
}

/// By what share critical speeds change from the last cell but one to the last, on average over the
/// thicknesses: "7 % (plain)".
std::string change_with_cell(const Evidence& e, const std::string& study,
                             std::optional<double> spall_strength, const std::string& label) {
  std::map<double, std::vector<CriticalSpeed>> of_thickness;
  for (const CriticalSpeed& u : e.critical_speeds(study, "spall_strength"))
    if (has(u, spall_strength)) of_thickness[u.wall_thickness].push_back(u);
  double sum = 0;
  int count = 0;
  for (auto& [thickness, speeds] : of_thickness) {
    std::ranges::stable_sort(speeds, {}, &CriticalSpeed::cell_size);
    if (speeds.size() < 2 || !speeds[0].lower || !speeds[1].lower) continue;
    sum += std::abs(middle(speeds[0]) - middle(speeds[1])) / middle(speeds[0]);
    ++count;
  }
  return count > 0 ? fmt::format("{:.0f} % ({})", 100 * sum / count, label) : "";
}

}  // namespace

std::string critical_speed_at_3_um(const Evidence& e, const std::string& study,
                                   std::optional<double> spall_strength) {
  for (const CriticalSpeed& u : known_speeds(e, study))
    if (std::abs(u.wall_thickness - 3e-6) < 1e-9 && has(u, spall_strength) && u.interval)
      return fmt::format("{:.0f} ± {:.0f} m/s", *u.extrapolated, *u.interval);
  return "not run";
}

Claim parabola(const Evidence& e) {
  Claim c = claim("critical-speed-parabola",
                  "The critical impact speed increases parabolically with the wall's thickness d",
                  "critical-speed");
  const auto fits = e.fits(c.study, "critical_speed_extrapolated");
  const auto c2 = std::ranges::find(fits, "c2", &FitRow::coefficient);
  const auto speeds = known_speeds(e, c.study);
  if (c2 == fits.end() || speeds.empty()) return c;
  const auto r2 = c2->r2, chi2 = c2->reduced_chi2;
  const double error = c2->standard_error.value_or(0);
  if (!r2) {
    judge(c, Truth::open, "a parabola through as many points as it has coefficients", says_nothing);
    return c;
  }
  double widest = 0;
  for (const CriticalSpeed& u : speeds) widest = std::max(widest, u.interval.value_or(0));
  const bool seen = *r2 > 0.95 && std::ranges::is_sorted(speeds, {}, middle) && c2->value > error;
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
          *r2, c2->value * 1e-12, error * 1e-12, widest,
          chi2 ? fmt::format(", of which the scatter about the parabola is {:.2g}", std::sqrt(*chi2)) : ""),
      "holds: critical speeds that grow on the finest cell, r2 above 0.95 for the parabola through those for "
      "cells of size 0, and a curvature beyond its standard error. Not decided: one of these is not so, but "
      "the scatter is within the intervals");
  return c;
}

Claim critical_values(const Evidence& e) {
  Claim c = claim("critical-speed-values", "Fig. 4: the values of the critical speed", "critical-speed");
  const auto speeds = known_speeds(e, c.study);
  if (speeds.empty()) return c;
  const CriticalSpeed &first = speeds.front(), &last = speeds.back();
  c.verdict = not_comparable;
  c.measured = fmt::format(
      "{:.0f} ± {:.0f} m/s at d = {:.3g} um to {:.0f} ± {:.0f} m/s at {:.3g} um; on the finest cell "
      "{:.0f} to {:.0f} m/s",
      *first.extrapolated, first.interval.value_or(0), 1e6 * first.wall_thickness, *last.extrapolated,
      last.interval.value_or(0), 1e6 * last.wall_thickness, middle(first), middle(last));
  std::vector<std::string> changes = {change_with_cell(e, c.study, {}, "plain"),
                                      change_with_cell(e, "critical-speed-spall", 1e9, "1 GPa"),
                                      change_with_cell(e, "critical-speed-spall", 3e9, "3 GPa")};
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
