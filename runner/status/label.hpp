#pragma once
#include <span>
#include <string>

#include "libmpm/scene/scene.hpp"

namespace mpmstudy {

/// What tells a job from its neighbours: "cavity_radius = 1 um, impact_speed = 200 m/s". Names that the
/// scene does not know are left out.
std::string label_of(const mpm::Scene&, std::span<const std::string> swept);

/// "8 s", "2 min 05 s", "1 h 02 min"
std::string readable_duration(double seconds);

/// "6.1 M/s": particle updates a second.
std::string readable_rate(double updates_per_second);

}  // namespace mpmstudy
