#include "runner/paper/subjects.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <string>
#include <vector>

#include "runner/finish/evidence.hpp"
#include "runner/paper/verdict.hpp"

namespace mpmstudy {
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

}  // namespace mpmstudy
