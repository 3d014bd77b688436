#pragma once
#include "libmpm/core/particles.hpp"
#include "libmpm/material/strength/j2.hpp"

namespace mpm {

/// The first `count` of a model's own columns (OwnColumn) of a particle.
inline void read_own(const Particles& ps, std::size_t p, int count, double* own) {
  if (count > own_plastic_work) {
    own[own_plastic_strain] = ps.plastic_strain[p], own[own_plastic_work] = ps.plastic_work[p];
  }
  if (count > own_back_stress) {
    const PlaneTensor& back = ps.back_stress[p];
    own[own_back_stress] = back.xx, own[own_back_stress + 1] = back.yy, own[own_back_stress + 2] = back.xy;
  }
}
inline void write_own(Particles& ps, std::size_t p, int count, const double* own) {
  if (count > own_plastic_work) {
    ps.plastic_strain[p] = own[own_plastic_strain], ps.plastic_work[p] = own[own_plastic_work];
  }
  if (count > own_back_stress) {
    const double xx = own[own_back_stress], yy = own[own_back_stress + 1];
    ps.back_stress[p] = {xx, yy, -(xx + yy), own[own_back_stress + 2]};
  }
}

/// No model has more.
inline constexpr int most_own_columns = 5;

}  // namespace mpm
