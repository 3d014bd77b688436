#include "libmpm/step/stress_update.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "libmpm/core/deviator_numbers.hpp"
#include "libmpm/material/list.hpp"

namespace mpm {
namespace {

Gradient<double> gradient_of(const Mat2& l) { return {l(0, 0), l(0, 1), l(1, 0), l(1, 1)}; }
FullGradient<double> gradient_of(const Mat3& l) {
  return {l(0, 0), l(0, 1), l(0, 2), l(1, 0), l(1, 1), l(1, 2), l(2, 0), l(2, 1), l(2, 2)};
}

/// Of the particles of one material; adds to the report.
template <class Space, class Model>
void update(BasicState<Space::axes>& state, const Model& model,
            typename BasicParticles<Space::axes>::Range range, double dt,
            BasicStepReport<Space::axes>& report) {
  BasicParticles<Space::axes>& ps = state.particles;
  using Deviator = typename Space::template Deviator<double>;
  static_assert(MaterialModelOver<Model, double, Space>);
  ps.keep(Model::state);
  const OwnNumbers own_numbers(ps, Model::state);
  const Validity<double> valid = model.validity();
  double lowest = 0, highest = 0, fastest = 0, overpressed = 0, overstrained = 0, kinetic = 0;
  bool finite = true;  // std::max would lose a NaN
  for (std::size_t p = range.first; p < range.last; ++p) {
    const auto strain = [&] {
      const Mat<Space::axes> l = dt * state.velocity_gradient[p];
      if constexpr (Space::has_hoop)
        return strain_over<double, Space>(ps.dilation[p], gradient_of(l), model, dt * state.hoop_rate[p]);
      else
        return strain_over<double, Space>(ps.dilation[p], gradient_of(l), model);
    }();
    Deviator s = numbers_of(ps.deviator[p]);
    double own[most_own_numbers<double, Space::axes>];
    own_numbers.read(p, own);
    const Point<double, Deviator> point{ps.dilation[p], ps.energy[p],           s,
                                        ps.pressure[p], ps.viscous_pressure[p], own};
    model.shear(point, strain, 1 / dt);
    const Signal<double> speeds = model.bulk(point, strain, 1 / dt);
    ps.deviator[p] = tensor_of(s);
    own_numbers.write(p, own);

    const double speed = ps.velocity[p].cwiseAbs().maxCoeff(), viscous = speeds.viscous;
    const double signal = speed + viscous + std::sqrt(viscous * viscous + speeds.longitudinal_square);
    finite &= std::isfinite(signal) && std::isfinite(ps.pressure[p]) && std::isfinite(ps.energy[p]);
    fastest = std::max(fastest, signal);
    const double dilation = ps.dilation[p];
    if (ps.pressure[p] > valid.pressure_limit) overpressed += ps.mass[p];
    if (dilation < valid.least_dilation || dilation >= valid.most_dilation) overstrained += ps.mass[p];
    kinetic += ps.kinetic_energy(p);
    lowest = std::min(lowest, dilation);
    highest = std::max(highest, dilation);
  }
  if (!finite)
    report.largest_signal = std::numeric_limits<double>::quiet_NaN();
  else if (!std::isnan(report.largest_signal))
    report.largest_signal = std::max(report.largest_signal, fastest);
  report.overpressed_mass += overpressed;
  report.overstrained_mass += overstrained;
  report.kinetic_energy += kinetic;
  report.smallest_dilation = std::min(report.smallest_dilation, lowest);
  report.largest_dilation = std::max(report.largest_dilation, highest);
}

}  // namespace

template <int axes>
void update_stress(BasicState<axes>& state, const MaterialModels& materials, double dt,
                   BasicStepReport<axes>& report) {
  for (std::size_t m = 0; m < materials.of.size(); ++m)
    with_model<double>(materials.of[m], [&](const auto& model, std::size_t) {
      const auto range = state.particles.range_of(m);
      space::with_space<axes>(state.space,
                              [&]<class Space>(Space) { update<Space>(state, model, range, dt, report); });
    });
}

template void update_stress(BasicState<2>&, const MaterialModels&, double, BasicStepReport<2>&);
template void update_stress(BasicState<3>&, const MaterialModels&, double, BasicStepReport<3>&);

}  // namespace mpm
