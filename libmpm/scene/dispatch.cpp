#include "libmpm/scene/dispatch.hpp"

#include <cmath>
#include <stdexcept>

#include "libmpm/measure/gauges.hpp"
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
std::unique_ptr<BasicStepper<Space::axes>> reference_stepper_in(const Scene& s) {
  if constexpr (!ShapeIn<Shape, Space>) {
    throw std::logic_error("a scheme that this space does not have");
  } else {
    if (s.numerics.transfer == Transfer::apic)
      return std::make_unique<ReferenceStepper<Shape, Apic, Space>>(build_materials(s));
    const double f = s.numerics.pic_fraction;
    if (f == 0) return std::make_unique<ReferenceStepper<Shape, Flip, Space>>(build_materials(s));
    return std::make_unique<ReferenceStepper<Shape, FlipPic, Space>>(build_materials(s), FlipPic{f});
  }
}

template <class Space>
std::unique_ptr<BasicStepper<Space::axes>> reference_stepper(const Scene& s) {
  switch (s.numerics.scheme) {
    case ShapeFunction::gimp:
      return reference_stepper_in<Gimp, Space>(s);
    case ShapeFunction::bspline2:
      return reference_stepper_in<BSpline2, Space>(s);
    case ShapeFunction::cpdi:
      return reference_stepper_in<Cpdi, Space>(s);
    case ShapeFunction::bspline3:
      return reference_stepper_in<BSpline3, Space>(s);
  }
  throw std::logic_error("a scheme that is not compiled");
}

template <class Real>
std::unique_ptr<Stepper> fast_stepper_of(const Scene& s) {
  using Fast = fast::FastStepper<Real>;
  const bool gimp = s.numerics.scheme == ShapeFunction::gimp;
  return std::make_unique<Fast>(build_materials(s), gimp ? Fast::Shape::gimp : Fast::Shape::bspline2,
                                s.space);
}

/// Every material, and what fast_step_has(); find_problems() refuses the rest.
std::unique_ptr<Stepper> fast_stepper(const Scene& s) {
  return s.numerics.precision == Precision::single_precision ? fast_stepper_of<float>(s)
                                                             : fast_stepper_of<double>(s);
}

}  // namespace

bool fast_step_has(const Scene& s) {
  const Numerics& n = s.numerics;
  return s.space != Space::three_d &&
         (n.scheme == ShapeFunction::gimp || n.scheme == ShapeFunction::bspline2) &&
         n.transfer == Transfer::flip && n.pic_fraction == 0;
}

template <>
std::unique_ptr<Stepper> stepper_for<2>(const Scene& s) {
  switch (s.numerics.kernel) {
    case Kernel::fast:
      return fast_stepper(s);
    case Kernel::reference:
      return space::with_space(s.space, [&]<class Space>(Space) { return reference_stepper<Space>(s); });
  }
  throw std::logic_error("a kernel that is not compiled");
}

template <>
std::unique_ptr<BasicStepper<3>> stepper_for<3>(const Scene& s) {
  return reference_stepper<space::ThreeD>(s);
}

template <int axes>
BasicMeasurements<axes> measurements_for(const Scene& s, const BasicState<axes>& state) {
  BasicMeasurements<axes> all = kind_of(s).in<axes>().measurements(s, state);
  all.push_back(std::make_unique<BasicHotSpots<axes>>(temperatures_of(s)));
  if (!s.measures.gauges.empty()) all.push_back(std::make_unique<BasicGauges<axes>>(s, state));
  return all;
}

template BasicMeasurements<2> measurements_for(const Scene&, const State&);
template BasicMeasurements<3> measurements_for(const Scene&, const BasicState<3>&);

}  // namespace mpm
