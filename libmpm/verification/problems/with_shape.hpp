#pragma once
#include <stdexcept>

#include "libmpm/scene/scene.hpp"
#include "libmpm/shape/bspline2.hpp"
#include "libmpm/shape/bspline3.hpp"
#include "libmpm/shape/cpdi.hpp"
#include "libmpm/shape/gimp.hpp"
#include "libmpm/shape/linear.hpp"

namespace mpm::verification {

/// Calls visit.operator()<Shape>() with the type of a shape function.
template <class Visit>
auto with_shape(mpm::ShapeFunction shape, const Visit& visit) {
  switch (shape) {
    case mpm::ShapeFunction::gimp:
      return visit.template operator()<mpm::Gimp>();
    case mpm::ShapeFunction::bspline2:
      return visit.template operator()<mpm::BSpline2>();
    case mpm::ShapeFunction::cpdi:
      return visit.template operator()<mpm::Cpdi>();
    case mpm::ShapeFunction::bspline3:
      return visit.template operator()<mpm::BSpline3>();
    case mpm::ShapeFunction::linear:
      return visit.template operator()<mpm::Linear>();
  }
  throw std::logic_error("a shape function that is not compiled");
}

}  // namespace mpm::verification
