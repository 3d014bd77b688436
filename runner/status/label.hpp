#pragma once
#include <cstddef>
#include <cstdint>
#include <span>
#include <string>
#include <string_view>

#include "libmpm/scene/scene.hpp"

namespace mpmstudy {

/// What tells a job from its neighbours: "cavity_radius = 1 um, impact_speed = 200 m/s". Names that the
/// scene does not know are left out.
std::string label_of(const mpm::Scene&, std::span<const std::string> swept);

/// The first digits of a job's key: what every verb prints of it, so that one can be found in the other's
/// output. 12 digits tell a million jobs apart.
inline constexpr std::size_t shown_key_digits = 12;
std::string short_key(const std::string& key);

/// No line about one job is longer [columns]: what a wide terminal or a log shows in one row.
inline constexpr std::size_t line_columns = 120;

/// The first columns of a text, never half a code point.
std::string text_start(std::string_view text, std::size_t columns);
/// The text, or as much of it as leaves room for "..." at its end.
std::string cut_text(std::string_view text, std::size_t columns);
/// Up to the first line feed.
std::string first_line(std::string_view text);

/// "1 job", "2 jobs".
std::string counted(std::int64_t number, const std::string& noun);

/// "8 s", "2 min 05 s", "1 h 02 min"
std::string readable_duration(double seconds);

/// "8 s (5 s to 13 s)"; factor 1: without an interval.
std::string readable_prediction(double seconds, double factor);

/// "6.1 M/s": particle updates per second.
std::string readable_rate(double updates_per_second);

}  // namespace mpmstudy
