#pragma once
#include <cmath>

#include "libmpm/core/archive.hpp"
#include "libmpm/step/state.hpp"

namespace mpm {

/// What acts on the bodies from outside and can do work, summed over a run. A balance is relative to what
/// there was at the start and what has come in since: what gross sums are for, which only grow.
struct Loads {
  bool there = false;               ///< whether a scene has any; of one without, all stays 0
  double work = 0, gross_work = 0;  ///< done on the bodies, and the sum of its size step by step [J/m]
  double gross_impulse = 0;         ///< [kg/s]

  template <int axes>
  static Loads of(const BasicState<axes>& s) {
    return {.there = !s.gravity.isZero(0) || s.has_rigid_bodies};
  }
  template <int axes>
  void add(const BasicStepReport<axes>& report) {
    work += report.gravity_work + report.rigid_work;
    gross_work += std::abs(report.gravity_work) + std::abs(report.rigid_work);
    gross_impulse += report.gravity_impulse.norm() + report.rigid_impulse.norm();
  }
  void carry(Archive& a) {
    if (!there) return;
    a.number("load_work", work), a.number("load_gross_work", gross_work);
    a.number("load_gross_impulse", gross_impulse);
  }
};

}  // namespace mpm
