#pragma once
/// How the bodies of a composition move, and how hot they are, at time 0.
#include <functional>
#include <string>

#include "libmpm/body/region.hpp"
#include "libmpm/scene/report.hpp"
#include "libmpm/scene/scene.hpp"

namespace mpm {

/// What of a body lies in the box.
template <int axes>
BasicRegion<axes> region_in(const Composition&, const ComposedBody&);

/// [m/s] at a place.
template <int axes>
std::function<Vec<axes>(const Vec<axes>& x)> velocity_at_start(const ComposedBody&);

/// Of all parts of all bodies; for a body that is hot, with all of its energy turned into motion [m/s].
double fastest_at_start(const Scene&);

/// What is wrong with the radial velocity and the energy of a body.
void check_start(const Scene&, const ComposedBody&, Report&);

/// "(0, 1e-06) m"
std::string vector_text(const Triple&, int axes, const char* unit);

}  // namespace mpm
