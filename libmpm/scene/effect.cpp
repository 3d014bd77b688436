#include "libmpm/scene/effect.hpp"

#include <cmath>

namespace mpm {
namespace {

bool plastic(const Scene& s) { return std::isfinite(s.material.yield_stress); }
bool hardens(const Scene& s) { return plastic(s) && s.material.hardening_modulus > 0; }
bool decides_ejection(const Scene& s) { return s.measures.decides == Decides::ejection; }

double zero(const Scene&) { return 0; }

/// Values of `inert` are those that every job had that named none: their keys stay.
constexpr Condition table[] = {
    {"spall_strength", "tension = \"cutoff\"",
     [](const Scene& s) { return s.material.tension == Tension::cutoff; }, zero},
    {"hardening_modulus", "a finite yield_stress", plastic, zero},
    {"hardening_measure", "hardening_modulus above 0 and a finite yield_stress", hardens, zero},
    {"kinematic_fraction", "hardening_modulus above 0 and a finite yield_stress", hardens, zero},
    {"detached_for", "decides = \"ejection\"", decides_ejection,
     [](const Scene& s) { return default_detached_for(s); }},
    {"stop", "decides = \"ejection\"", decides_ejection, zero},
};

}  // namespace

std::span<const Condition> conditions() { return table; }

const Condition* condition_of(std::string_view parameter) {
  for (const Condition& condition : table)
    if (condition.parameter == parameter) return &condition;
  return nullptr;
}

}  // namespace mpm
