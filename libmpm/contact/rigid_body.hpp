#pragma once
#include "libmpm/core/tensor.hpp"
#include "libmpm/scene/composition.hpp"

namespace mpm {

/// A place of so many axes, with 0 along those that are missing.
template <int axes>
Vec3 in_space(const Vec<axes>& x) {
  Vec3 full = Vec3::Zero();
  full.template head<axes>() = x;
  return full;
}

/// A body that nothing deforms or stops: a half space, a block or a ball (of two axes a disc), which moves
/// with its velocity and turns with its spin. It has no particles: where its surface is, and which way that
/// looks, is known exactly.
class RigidBody {
 public:
  /// Of so many axes. The form of the body is one of those.
  RigidBody(const ComposedBody&, int axes);
  static bool has_form(Shape::Form);

  /// What is nearest to a place at a time.
  struct Nearest {
    double distance;  ///< positive outside [m]
    Vec3 outwards;    ///< of length 1
  };
  Nearest nearest(const Vec3& x, double time) const;
  /// Of its material at a place [m/s].
  Vec3 velocity(const Vec3& x, double time) const;

 private:
  Vec3 turned(const Vec3& v, double angle) const;

  Shape::Form form_;
  Vec3 a_ = Vec3::Zero(), b_ = Vec3::Zero();  ///< low and high corner; centre; point and direction
  double radius_ = 0;
  Mat3 rotation_;  ///< of the shape, as in Shape
  Vec3 shift_, velocity_, about_;
  double spin_;
  int axes_;
};

}  // namespace mpm
