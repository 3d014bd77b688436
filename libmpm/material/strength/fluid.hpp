#pragma once
#include <array>

#include "libmpm/material/model.hpp"

namespace mpm {

/// No strength: the deviator stays 0.
struct Fluid {
  template <class Real>
  struct Constants {
    explicit Constants(const Material&) {}
  };
  static constexpr bool has_deviator = false;
  static constexpr bool fails = false;
  static constexpr std::array<StateColumn, 0> state{};
  static bool fits(const Material& m) { return m.strength == StrengthModel::none; }

  template <class Real, class N, class Tensor, class Space>
  static MPM_INLINE void update(const Constants<Real>&, Tensor& s, N*, const Strain<N, Space>&, N, Real) {
    s = Tensor{};
  }
};

}  // namespace mpm
