#include "libmpm/contact/contact_stepper.hpp"

#include "libmpm/body/fill.hpp"
#include "libmpm/contact/many_fields.hpp"
#include "libmpm/scene/build.hpp"
#include "libmpm/scene/with_scheme.hpp"
#include "libmpm/step/step.hpp"

namespace mpm {
namespace {

template <ShapeFunctions Shape, class Transfer, class Space>
class ContactStepper : public BasicStepper<Space::axes> {
 public:
  static constexpr int axes = Space::axes;

  ContactStepper(const Scene& s, const Transfer& transfer)
      : materials_(build_materials(s)),
        transfer_(transfer),
        table_(SurfaceTable::of<Shape>(0.5 / particles_per_edge(s.numerics, axes))),
        nodes_(Contacts(s)) {}
  BasicStepReport<axes> step(BasicState<axes>& state, double dt) override {
    return reference_step<Shape, Transfer, Space>(state, materials_, dt, transfer_, NoBodyForce{},
                                                  ManyFields<axes>{&nodes_, &table_});
  }

 private:
  MaterialModels materials_;
  Transfer transfer_;
  SurfaceTable table_;
  FieldNodes<axes> nodes_;
};

template <class Space>
std::unique_ptr<BasicStepper<Space::axes>> stepper_in(const Scene& s) {
  return with_scheme<Space>(s,
                            [&]<class Shape, class Transfer>(
                                const Transfer& transfer) -> std::unique_ptr<BasicStepper<Space::axes>> {
                              return std::make_unique<ContactStepper<Shape, Transfer, Space>>(s, transfer);
                            });
}

}  // namespace

template <int axes>
std::unique_ptr<BasicStepper<axes>> contact_stepper(const Scene& s) {
  return space::with_space<axes>(s.space, [&]<class Space>(Space) { return stepper_in<Space>(s); });
}
template std::unique_ptr<BasicStepper<2>> contact_stepper(const Scene&);
template std::unique_ptr<BasicStepper<3>> contact_stepper(const Scene&);

}  // namespace mpm
