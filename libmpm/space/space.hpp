#pragma once
/// How many of the three dimensions a scene is computed in. A space is a type: a template parameter of the
/// step, whose differences stand here and behind `has_hoop`.
#include "libmpm/core/full_symmetric.hpp"

namespace mpm {

enum class Space {
  plane_strain,  ///< x, y; nothing moves or changes along z. Volumes, masses and energies are per depth
  axisymmetric,  ///< x is the distance from the axis of symmetry, y runs along it. Volumes, masses and
                 ///< energies are per radian: a body of revolution has 2 pi times as much
  three_d,       ///< x, y, z. Volumes, masses and energies are whole
};

constexpr int axes_of(Space space) { return space == Space::three_d ? 3 : 2; }

/// What two lengths are to two, and three lengths to three: an area, or a volume per radian.
constexpr int lengths_in_volume(Space space) { return space == Space::plane_strain ? 2 : 3; }

namespace space {

struct PlaneStrain {
  static constexpr Space value = Space::plane_strain;
  static constexpr int axes = 2;
  /// Whether motion across the axis strains the material along the hoop, and the stress there drives it.
  static constexpr bool has_hoop = false;
  template <class N>
  using Displacement = Gradient<N>;
  template <class N>
  using Symmetric = mpm::Symmetric<N>;
  template <class N>
  using Increment = PlaneIncrement<N>;
  template <class N>
  using Deviator = mpm::Deviator<N>;
  template <class N>
  using Rotation = PlaneRotation<N>;
};

/// With r = x and v_r = v_x:
///   m_p = rho A r_p,   V_p = A r_p   (per radian)
///   f_i = - V_p (sigma_p grad w_ip + (sigma_zz h_ip / r_p, 0)),   L_zz = sum v_r h_ip / r_p
/// with zz along the hoop and h the hoop weights of the shape function, see HoopShape in shape/shape.hpp.
/// Source: Nairn & Guilkey 2015, Int. J. Numer. Meth. Engng 101, 127. The axis is a mirror.
struct Axisymmetric {
  static constexpr Space value = Space::axisymmetric;
  static constexpr int axes = 2;
  static constexpr bool has_hoop = true;
  template <class N>
  using Displacement = AxialGradient<N>;
  template <class N>
  using Symmetric = mpm::Symmetric<N>;
  template <class N>
  using Increment = AxialIncrement<N>;
  template <class N>
  using Deviator = mpm::Deviator<N>;
  template <class N>
  using Rotation = PlaneRotation<N>;
};

struct ThreeD {
  static constexpr Space value = Space::three_d;
  static constexpr int axes = 3;
  static constexpr bool has_hoop = false;
  template <class N>
  using Displacement = FullGradient<N>;
  template <class N>
  using Symmetric = mpm::FullSymmetric<N>;
  template <class N>
  using Increment = FullIncrement<N>;
  template <class N>
  using Deviator = FullDeviator<N>;
  template <class N>
  using Rotation = FullRotation<N>;
};

/// Calls `use` with the type of a space of so many axes.
template <int axes = 2, class Use>
auto with_space(Space space, Use use) {
  if constexpr (axes == 3)
    return use(ThreeD{});
  else
    return space == Space::axisymmetric ? use(Axisymmetric{}) : use(PlaneStrain{});
}

}  // namespace space
}  // namespace mpm
