#include "libmpm/scene/dispatch.hpp"

#include <cmath>
#include <stdexcept>

#include "libmpm/measure/hot_spots.hpp"
#include "libmpm/scene/build.hpp"
#include "libmpm/scene/kinds/kind.hpp"
#include "libmpm/shape/bspline2.hpp"
#include "libmpm/shape/bspline3.hpp"
#include "libmpm/shape/cpdi.hpp"
#include "libmpm/shape/gimp.hpp"
#include "libmpm/step/apic.hpp"
#include "libmpm/step/fast/fast_stepper.hpp"
#include "libmpm/step/flip_pic.hpp"
#include "libmpm/step/reference_stepper.hpp"

namespace mpm {

namespace {

template <ShapeFunctions Shape, class Space>
std::unique_ptr<Stepper> reference_stepper_in(const Scene& s) {
  if (s.numerics.transfer == Transfer::apic)
    return std::make_unique<ReferenceStepper<Shape, Apic, Space>>(build_material(s));
  const double f = s.numerics.pic_fraction;
  if (f == 0) return std::make_unique<ReferenceStepper<Shape, Flip, Space>>(build_material(s));
  return std::make_unique<ReferenceStepper<Shape, FlipPic, Space>>(build_material(s), FlipPic{f});
}

template <ShapeFunctions Shape>
std::unique_ptr<Stepper> reference_stepper_on(const Scene& s) {
  return space::with_space(s.space, [&]<class Space>(Space) -> std::unique_ptr<Stepper> {
    if constexpr (!Space::has_hoop || HoopShape<Shape>) return reference_stepper_in<Shape, Space>(s);
    throw std::logic_error("a scheme that this space does not have");
  });
}

std::unique_ptr<Stepper> reference_stepper(const Scene& s) {
  switch (s.numerics.scheme) {
    case ShapeFunction::gimp:
      return reference_stepper_on<Gimp>(s);
    case ShapeFunction::bspline2:
      return reference_stepper_on<BSpline2>(s);
    case ShapeFunction::cpdi:
      return reference_stepper_on<Cpdi>(s);
    case ShapeFunction::bspline3:
      return reference_stepper_on<BSpline3>(s);
  }
  throw std::logic_error("a scheme that is not compiled");
}

template <class Real>
std::unique_ptr<Stepper> fast_stepper_of(const Scene& s) {
  using Fast = fast::FastStepper<Real>;
  const bool gimp = s.numerics.scheme == ShapeFunction::gimp;
  return std::make_unique<Fast>(build_material(s), gimp ? Fast::Shape::gimp : Fast::Shape::bspline2, s.space);
}

/// Every material, and what fast_step_has(); find_problems() refuses the rest.
std::unique_ptr<Stepper> fast_stepper(const Scene& s) {
  return s.numerics.precision == Precision::single_precision ? fast_stepper_of<float>(s)
                                                             : fast_stepper_of<double>(s);
}

}  // namespace

bool fast_step_has(const Numerics& n) {
  return (n.scheme == ShapeFunction::gimp || n.scheme == ShapeFunction::bspline2) &&
         n.transfer == Transfer::flip && n.pic_fraction == 0;
}

std::unique_ptr<Stepper> stepper_for(const Scene& s) {
  switch (s.numerics.kernel) {
    case Kernel::fast:
      return fast_stepper(s);
    case Kernel::reference:
      return reference_stepper(s);
  }
  throw std::logic_error("a kernel that is not compiled");
}

std::vector<std::unique_ptr<Measurement>> measurements_for(const Scene& s, const State& state) {
  Measurements all = kind_of(s).measurements(s, state);
  all.push_back(std::make_unique<HotSpots>(Temperature(s.material)));
  return all;
}

}  // namespace mpm
