#pragma once
#include "libmpm/core/tensor.hpp"

namespace mpm {

/// Dry friction: the bodies stick where that takes a tangential impulse S of at most mu N, and slide under
/// mu N where it takes more,
///   T = S,   |S| <= mu N;      T = mu N S / |S|   otherwise      [kg m/s]
/// with N >= 0 the normal impulse. mu infinite: they never slide. Source: Bardenhagen, Brackbill, Sulsky
/// 2000, Comput. Methods Appl. Mech. Engng 187, 529. Checked by tests/libmpm/contact_test.cpp.
struct Coulomb {
  double friction;  ///< mu [1]

  /// `holding`: the impulse that would hold the bodies together.
  template <int axes>
  Vec<axes> tangential(const Vec<axes>& holding, double normal) const {
    const double size = holding.norm();
    // an infinite mu times nothing is no number
    const double most = normal > 0 ? friction * normal : 0;
    return size <= most ? holding : Vec<axes>(most / size * holding);
  }
};

}  // namespace mpm
