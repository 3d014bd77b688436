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

/// "; intervals of at most 1.2 %": of the collapsibilities for cells of size 0; empty without several cells.
std::string largest_interval(const Evidence& e, const std::string& study) {
  const auto share = e.largest_relative_error(study, "collapsibility");
  return share ? fmt::format("; intervals of at most {:.1f} %", 100 * *share) : "";
}

}  // namespace

std::vector<ValueWithError> collapsibilities(const Evidence& e, const std::string& study,
                                             const std::string& parameter) {
  std::vector<ValueWithError> all;
  for (const ResultAt& one : e.results(study, "collapsibility", parameter))
    if (one.flags.empty()) all.push_back(one.result);
  return all;
}

Claim falls_with_radius(const Evidence& e) {
  Claim c = claim("collapsibility-falls-with-radius",
                  "The collapsibility becomes larger when the cavity is smaller", "collapsibility-radius");
  const auto phi = collapsibilities(e, c.study, "cavity_radius");
  if (phi.size() > 1)
    judge(c, falls(phi),
          fmt::format("{:.3f} to {:.3f}", phi.front().value, phi.back().value) + largest_interval(e, c.study),
          "at every radius");
  return c;
}

Claim falls_with_yield(const Evidence& e) {
  Claim c = claim("collapsibility-falls-with-yield",
                  "The collapsibility decreases parabolically with the initial yield stress",
                  "collapsibility-yield");
  const auto phi = collapsibilities(e, c.study, "yield_stress");
  const auto fits = e.fits(c.study, "collapsibility");
  const auto r2 = fits.empty() ? std::nullopt : fits.front().r2;
  const auto chi2 = fits.empty() ? std::nullopt : fits.front().reduced_chi2;
  if (!fits.empty() && !r2)
    judge(c, Truth::open, "a parabola through as many points as it has coefficients", says_nothing);
  if (phi.size() > 1 && r2) {
    const Truth parabola = *r2 > 0.99 ? Truth::yes : chi2 && *chi2 <= 1 ? Truth::open : Truth::no;
    judge(
        c, both(falls(phi), parabola),
        fmt::format("{:.3f} to {:.3f}; parabola with r2 = {:.4f}", phi.front().value, phi.back().value, *r2) +
            largest_interval(e, c.study),
        "from one yield stress to the next, and r2 above 0.99");
  }
  return c;
}

Claim scale_invariance(const Evidence& e) {
  Claim c = claim("scale-invariance",
                  "The behaviour is the same if spatial and temporal scales are magnified alike",
                  "scale-invariance");
  const auto phi = collapsibilities(e, c.study, "");
  if (phi.size() > 1)
    judge(c, std::ranges::all_of(phi, [&](const ValueWithError& p) { return p.value == phi[0].value; }),
          fmt::format("{:.17g} at {} scales", phi[0].value, phi.size()), "to the last bit");
  return c;
}

}  // namespace mpmstudy
