#pragma once
#include <stdexcept>

#include "libmpm/scene/scene.hpp"
#include "libmpm/shape/bspline2.hpp"
#include "libmpm/shape/bspline3.hpp"
#include "libmpm/shape/cpdi.hpp"
#include "libmpm/shape/gimp.hpp"
#include "libmpm/shape/linear.hpp"
#include "libmpm/step/apic.hpp"
#include "libmpm/step/flip_pic.hpp"

namespace mpm {

/// Calls make.operator()<Shape>(transfer) with the shape function and the transfer of a scene.
template <class Space, class Make>
auto with_scheme(const Scene& s, Make make) {
  using Result = decltype(make.template operator()<BSpline2>(Flip{}));
  const auto with_shape = [&]<class Shape>() -> Result {
    if constexpr (!ShapeIn<Shape, Space>) {
      throw std::logic_error("a scheme that this space does not have");
    } else {
      if (s.numerics.transfer == Transfer::apic) return make.template operator()<Shape>(Apic{});
      const double f = s.numerics.pic_fraction;
      if (f == 0) return make.template operator()<Shape>(Flip{});
      return make.template operator()<Shape>(FlipPic{f});
    }
  };
  switch (s.numerics.scheme) {
    case ShapeFunction::gimp:
      return with_shape.template operator()<Gimp>();
    case ShapeFunction::bspline2:
      return with_shape.template operator()<BSpline2>();
    case ShapeFunction::cpdi:
      return with_shape.template operator()<Cpdi>();
    case ShapeFunction::bspline3:
      return with_shape.template operator()<BSpline3>();
    case ShapeFunction::linear:
      return with_shape.template operator()<Linear>();
  }
  throw std::logic_error("a scheme that is not compiled");
}

}  // namespace mpm
