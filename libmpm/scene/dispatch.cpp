#include "libmpm/scene/dispatch.hpp"

#include <cmath>
#include <stdexcept>

#include "libmpm/contact/contact_stepper.hpp"
#include "libmpm/contact/contacts.hpp"
#include "libmpm/measure/gauges.hpp"
#include "libmpm/measure/hot_spots.hpp"
#include "libmpm/scene/build.hpp"
#include "libmpm/scene/kinds/kind.hpp"
#include "libmpm/scene/with_scheme.hpp"
#include "libmpm/step/fast/fast_stepper.hpp"
#include "libmpm/step/reference_stepper.hpp"

namespace mpm {

namespace {

template <class Space>
std::unique_ptr<BasicStepper<Space::axes>> reference_stepper(const Scene& s) {
  return with_scheme<Space>(s,
                            [&]<class Shape, class Transfer>(
                                const Transfer& transfer) -> std::unique_ptr<BasicStepper<Space::axes>> {
                              return std::make_unique<ReferenceStepper<Shape, Transfer, Space>>(
                                  build_materials(s), transfer);
                            });
}

template <class Real, int axes>
std::unique_ptr<BasicStepper<axes>> fast_stepper_of(const Scene& s) {
  using Fast = fast::FastStepper<Real, axes>;
  const bool gimp = s.numerics.scheme == ShapeFunction::gimp;
  return std::make_unique<Fast>(build_materials(s), gimp ? Fast::Shape::gimp : Fast::Shape::bspline2,
                                s.space);
}

/// Every material, and what fast_step_has(); find_problems() refuses the rest.
template <int axes>
std::unique_ptr<BasicStepper<axes>> fast_stepper(const Scene& s) {
  return s.numerics.precision == Precision::single_precision ? fast_stepper_of<float, axes>(s)
                                                             : fast_stepper_of<double, axes>(s);
}

}  // namespace

bool fast_step_has(const Scene& s) {
  const Numerics& n = s.numerics;
  return (n.scheme == ShapeFunction::gimp || n.scheme == ShapeFunction::bspline2) &&
         n.transfer == Transfer::flip && n.pic_fraction == 0 && !s.composition.has_gravity() &&
         !has_contact(s);
}

template <int axes>
std::unique_ptr<BasicStepper<axes>> stepper_for(const Scene& s) {
  if (has_contact(s)) return contact_stepper<axes>(s);
  switch (s.numerics.kernel) {
    case Kernel::fast:
      return fast_stepper<axes>(s);
    case Kernel::reference:
      return space::with_space<axes>(s.space,
                                     [&]<class Space>(Space) { return reference_stepper<Space>(s); });
  }
  throw std::logic_error("a kernel that is not compiled");
}

template std::unique_ptr<BasicStepper<2>> stepper_for(const Scene&);
template std::unique_ptr<BasicStepper<3>> stepper_for(const Scene&);

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
