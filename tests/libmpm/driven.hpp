#pragma once
/// A material point that is strained by hand.
#include <cmath>

#include "libmpm/material/list.hpp"

namespace driven {

/// A point in plane strain, strained by equal steps of dt L; its energy is that of the middle of the step, as
/// in a run.
class Driven {
 public:
  explicit Driven(const mpm::Material& m, double linear = 0, double quadratic = 0)
      : material_{m, {linear, quadratic, 1e-6}} {}

  void strain(const mpm::Gradient<double>& l, double dt, int steps) {
    mpm::with_model<double>(material_, [&](const auto& model, std::size_t) {
      for (int k = 0; k < steps; ++k) {
        const double before = work_rate(l);
        energy += 0.5 * before;  // to the middle, with the stress of the start
        const auto e = mpm::strain_over<double, mpm::space::PlaneStrain>(dilation, l, model);
        const mpm::Point<double> point{dilation, energy, s, pressure, viscous, own};
        model.shear(point, e, 1 / dt);
        longitudinal_square = model.bulk(point, e, 1 / dt).longitudinal_square;
        energy += 0.5 * work_rate(l);
      }
    });
  }
  double mises() const { return std::sqrt(3 * second_invariant(s)); }

  mpm::Deviator<double> s{};
  double dilation = 0, energy = 0, pressure = 0, viscous = 0, own[8] = {}, longitudinal_square = 0;

 private:
  /// of the stress as it is, over a step, per mass
  double work_rate(const mpm::Gradient<double>& l) const {
    const double volume = (1 + dilation) / material_.material.reference_density;
    const double p = pressure + viscous;
    return volume * ((s.xx - p) * l.xx + (s.yy - p) * l.yy + s.xy * (l.xy + l.yx));
  }
  mpm::MaterialModel material_;
};

}  // namespace driven
