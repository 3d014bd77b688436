#pragma once
#include "libmpm/body/region.hpp"
#include "libmpm/scene/composition.hpp"

namespace mpm {

inline Vec3 vector(const Triple& t) { return {t[0], t[1], t[2]}; }

/// The region that a shape is. Its numbers are as many as its form has.
template <int axes>
BasicRegion<axes> region_of(const Shape&);

}  // namespace mpm
