#include "libmpm/measure/works.hpp"

#include "libmpm/contact/contacts.hpp"
#include "libmpm/measure/energy.hpp"

namespace mpm {
namespace {

constexpr ResultRow rows[] = {
    {.name = "gravity_work_fraction",
     .unit = "1",
     .meaning = "work of gravity / (initial energy + size of all work done on the bodies)",
     .lower = -1,
     .upper = 1,
     .always = false},
    {.name = "contact_heat_fraction",
     .unit = "1",
     .meaning = "kinetic energy that contact between bodies turned into heat, over the same",
     .lower = -1,
     .upper = 1,
     .always = false},
    {.name = "friction_heat_fraction",
     .unit = "1",
     .meaning = "part of that which is the work of friction",
     .lower = -1,
     .upper = 1,
     .always = false},
    {.name = "rigid_work_fraction",
     .unit = "1",
     .meaning = "work of rigid bodies on the others, over the same",
     .lower = -1,
     .upper = 1,
     .always = false},
};

}  // namespace

template <int axes>
std::span<const ResultRow> BasicWorks<axes>::results() {
  return rows;
}

template <int axes>
bool BasicWorks<axes>::measures(const Scene& s) {
  return s.composition.has_gravity() || has_contact(s);
}

template <int axes>
BasicWorks<axes>::BasicWorks(const Scene& scene, const State& s)
    : has_gravity_(scene.composition.has_gravity()),
      has_contact_(has_contact(scene)),
      initial_energy_(energy_of(s.particles).total()),
      loads_(Loads::of(s)) {}

template <int axes>
void BasicWorks<axes>::after_step(const State&, const StepReport& report, double) {
  loads_.add(report);
  gravity_work_ += report.gravity_work;
  contact_heat_ += report.contact_heat;
  friction_heat_ += report.friction_heat;
  rigid_work_ += report.rigid_work;
}

template <int axes>
void BasicWorks<axes>::finish(const State&, RunResult& result) const {
  const double scale = initial_energy_ + loads_.gross_work;
  if (!(scale > 0)) return;  // nothing has happened yet
  if (has_gravity_)
    result.metrics.push_back(metric(row_of(rows, "gravity_work_fraction"), gravity_work_ / scale));
  if (!has_contact_) return;
  result.metrics.push_back(metric(row_of(rows, "contact_heat_fraction"), contact_heat_ / scale));
  result.metrics.push_back(metric(row_of(rows, "friction_heat_fraction"), friction_heat_ / scale));
  result.metrics.push_back(metric(row_of(rows, "rigid_work_fraction"), rigid_work_ / scale));
}

template <int axes>
void BasicWorks<axes>::carry(Archive& a) {
  loads_.carry(a);
  a.number("gravity_work", gravity_work_), a.number("contact_heat", contact_heat_);
  a.number("friction_heat", friction_heat_), a.number("rigid_work", rigid_work_);
}

template class BasicWorks<2>;
template class BasicWorks<3>;

}  // namespace mpm
