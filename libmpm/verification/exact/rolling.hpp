#pragma once
#include <cmath>

namespace mpm::verification::exact {

/// A rigid body of revolution on an inclined plane, at rest at first, with I = k m R^2 (cylinder 1/2, sphere
/// 2/5) and Coulomb friction mu. It sticks while tan(angle) <= mu (1 + k) / k, and then
///   a = g sin(angle) / (1 + k),   alpha R = a;
/// otherwise it slides,
///   a = g (sin(angle) - mu cos(angle)),   alpha R = mu g cos(angle) / k.
struct Rolling {
  double acceleration;      ///< down the slope [m/s^2]
  double rim_acceleration;  ///< alpha R [m/s^2]
  bool sticks;

  Rolling(double angle, double friction, double gravity, double k)
      : sticks(std::tan(angle) <= friction * (1 + k) / k) {
    acceleration = sticks ? gravity * std::sin(angle) / (1 + k)
                          : gravity * (std::sin(angle) - friction * std::cos(angle));
    rim_acceleration = sticks ? acceleration : friction * gravity * std::cos(angle) / k;
  }
};

}  // namespace mpm::verification::exact
