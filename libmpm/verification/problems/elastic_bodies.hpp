#pragma once
/// Elastic bodies in free motion: a vibrating bar, and two disks that meet and part.
#include "libmpm/scene/scene.hpp"
#include "libmpm/verification/exact/vibrating_bar.hpp"

namespace mpm::verification {

/// A bar of length 25, E = 100, density 1, at a tenth of a percent of strain: a period of 10.
inline constexpr exact::VibratingBar vibrating_bar{25, 100, 1, 0.01};

struct BarMotion {
  double frequency;       ///< of the centre of mass, by its turns [rad/s]
  double velocity_error;  ///< of the centre of mass, root mean square over two periods, over the largest [1]
};
BarMotion vibrate(mpm::ShapeFunction, int cells, int side);

struct Collision {
  double momentum_error;  ///< largest, over sqrt(kinetic energy x mass) at the start [1]
  double energy_error;    ///< largest, of kinetic + what the stress did + transfer heat, relative
  double loss;            ///< of kinetic + elastic energy at the end, relative
  double least_kinetic;   ///< over the initial one
  double rebound;         ///< speed of a disk's centre after over before
};

/// Two disks of radius 0.2 on the diagonal of the unit square, at +-0.05 along both axes: they meet, rebound
/// and part; nothing else is there. E = 1, nu = 0.3, density 1.
/// Setting: Sulsky, Chen, Schreyer 1994, section 5.1, scaled; half of its speed.
Collision collide(mpm::ShapeFunction, int cells, int side);

}  // namespace mpm::verification
