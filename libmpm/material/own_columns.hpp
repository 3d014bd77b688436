#pragma once
#include "libmpm/core/particles.hpp"
#include "libmpm/material/strength/j2.hpp"

namespace mpm {

/// The numbers that a deviator is kept in.
inline Deviator<double> numbers_of(const PlaneTensor& t) { return {t.xx, t.yy, t.xy}; }
inline FullDeviator<double> numbers_of(const FullTensor& t) { return {t.xx, t.yy, t.xy, t.xz, t.yz}; }
inline PlaneTensor tensor_of(const Deviator<double>& s) { return {s.xx, s.yy, -(s.xx + s.yy), s.xy}; }
inline FullTensor tensor_of(const FullDeviator<double>& s) {
  return {s.xx, s.yy, -(s.xx + s.yy), s.xy, s.xz, s.yz};
}

/// The first `count` of a model's own columns (OwnColumn) of a particle; the back stress is all of it.
template <int axes>
void read_own(const BasicParticles<axes>& ps, std::size_t p, int count, double* own) {
  if (count > own_plastic_work) {
    own[own_plastic_strain] = ps.plastic_strain[p], own[own_plastic_work] = ps.plastic_work[p];
  }
  if (count > own_back_stress) store(numbers_of(ps.back_stress[p]), own + own_back_stress);
}
template <int axes>
void write_own(BasicParticles<axes>& ps, std::size_t p, int count, const double* own) {
  if (count > own_plastic_work) {
    ps.plastic_strain[p] = own[own_plastic_strain], ps.plastic_work[p] = own[own_plastic_work];
  }
  if (count > own_back_stress) {
    decltype(numbers_of(ps.back_stress[p])) back{};
    load(own + own_back_stress, back);
    ps.back_stress[p] = tensor_of(back);
  }
}

/// No model has more, with the back stress of three axes.
inline constexpr int most_own_columns = 7;

}  // namespace mpm
