#pragma once
/// A cube of aluminium that flies and turns freely about an axis of no symmetry.
#include "libmpm/scene/scene.hpp"

namespace mpm::verification {

struct FreeFlight {
  double momentum_error, angular_momentum_error;  ///< at the end, over what there was
};
/// 8 x 8 x 8 particles, two to a cell's edge, quadratic B-splines; a tenth of a radian and 1.4 cells of way
/// in 200 steps. FLIP gains and loses angular momentum by quadrature, APIC does not.
FreeFlight fly_freely(mpm::Transfer);

}  // namespace mpm::verification
