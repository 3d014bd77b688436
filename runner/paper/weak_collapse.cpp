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

constexpr double height_beyond_fig_5 = 1.95e-6;  ///< of the middle of a cavity [m]; Fig. 5 has 1.9 um

}  // namespace

Claim incomplete(const Evidence& e) {
  Claim c =
      claim("incomplete-collapse", "At 200 m/s the cavity is not collapsed completely", "weak-collapse");
  const auto phi = collapsibilities(e, c.study, "");
  const auto job = e.first_done(c.study);
  if (phi.empty()) return c;
  // A share has no room above 1: only a cavity that was seen to close is collapsed completely.
  const Truth below = is_below(phi[0], 1);
  const bool closed = job && job->outcome == "collapsed";
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
  if (const auto ratio = e.results(c.study, "aspect_ratio"); !ratio.empty())
    judge(c, is_below(ratio[0].result, 1), "width / height " + with_interval(ratio[0].result, 3),
          "by the markers on its surface, at 16 ns");
  return c;
}

Claim lower_part(const Evidence& e) {
  Claim c =
      claim("lower-part-collapses-more",
            "The lower part of the cavity collapses more, the more so nearer the impact face than in Fig. 5",
            "symmetry");
  std::vector<ValueWithError> ratios;
  for (const ResultAt& one : e.results(c.study, "lower_upper_area_ratio", "cavity_center_height"))
    if (one.parameter < height_beyond_fig_5) ratios.push_back(one.result);
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
  std::vector<ValueWithError> ratios;
  for (const ResultAt& one : e.results(c.study, "aspect_ratio", "cavity_center_height"))
    if (one.parameter > height_beyond_fig_5) ratios.push_back(one.result);
  if (ratios.empty()) return c;
  const auto distance = [](const ValueWithError& r) { return std::abs(std::log(r.value)); };
  const ValueWithError roundest = *std::ranges::min_element(ratios, {}, distance);
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
  const auto spots = hot_spots_of(e, c.study);
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

}  // namespace mpmstudy
