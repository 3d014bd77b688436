#pragma once
#include <cmath>

#include "libmpm/material/strength/j2.hpp"

namespace mpm {

/// Ductile failure: where the equivalent plastic strain reaches failure_strain, the deviator and the tension
/// are lost for good, and the particle carries compression alone. The energy of the lost stress stays in the
/// particle, as heat: the balance of energy does not notice. `Strength`: one that flows, whose first column
/// is the equivalent plastic strain.
template <class Strength>
struct Failing {
  static_assert(Strength::state[0].name == plastic_strain_column.name);

  template <class Real>
  struct Constants : Strength::template Constants<Real> {
    Real failure_strain;  ///< [1]

    explicit Constants(const Material& m)
        : Strength::template Constants<Real>(m), failure_strain(static_cast<Real>(m.failure_strain)) {}
    /// What is left of a pressure.
    template <class N>
    MPM_INLINE N held(N p, const N* own) const {
      return own[own_plastic_strain] >= failure_strain ? Number<N>::larger(p, N{}) : p;
    }
  };
  static constexpr bool has_deviator = true;
  static constexpr bool fails = true;
  static constexpr auto& state = Strength::state;
  static bool fits(const Material& m) { return Strength::is_of(m) && m.fails(); }

  template <class Real, class N, class Tensor, class Space>
  static MPM_INLINE void update(const Constants<Real>& constants, Tensor& s, N* own,
                                const Strain<N, Space>& e, N specific_volume, Real inverse_dt) {
    const typename Strength::template Constants<Real>& flow = constants;
    Strength::update(flow, s, own, e, specific_volume, inverse_dt);
    const N left = own[own_plastic_strain] >= constants.failure_strain ? N{} : Number<N>::all(1);
    s = scaled(left, s);
  }
};

inline constexpr MaterialUse where_it_flows{"a strength and a finite yield_stress", [](const Material& m) {
                                              return m.law == MaterialLaw::solid &&
                                                     m.strength != StrengthModel::none &&
                                                     std::isfinite(m.yield_stress);
                                            }};
inline constexpr MaterialRow failure_rows[] = {
    {"failure_strain", "1", "failure_strain",
     "equivalent plastic strain at which deviator and tension are lost; infinite: never",
     Range::non_negative_or_infinite, &Material::failure_strain, where_it_flows, "", Section::material,
     std::numeric_limits<double>::infinity()},
};

}  // namespace mpm
