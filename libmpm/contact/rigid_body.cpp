#include "libmpm/contact/rigid_body.hpp"

#include <cmath>
#include <stdexcept>

#include "libmpm/scene/region_of.hpp"

namespace mpm {

bool RigidBody::has_form(Shape::Form form) {
  return form == Shape::Form::half_space || form == Shape::Form::block || form == Shape::Form::ball;
}

RigidBody::RigidBody(const ComposedBody& body, int axes)
    : form_(body.shape.form),
      rotation_(Eigen::Map<const Eigen::Matrix<double, 3, 3, Eigen::RowMajor>>(body.shape.rotation.data())),
      shift_(vector(body.shape.shift)),
      velocity_(vector(body.velocity)),
      about_(vector(body.about)),
      spin_(body.spin),
      axes_(axes) {
  const std::vector<double>& n = body.shape.numbers;
  a_ = Vec3(n[0], n[1], n[2]);
  switch (form_) {
    case Shape::Form::half_space:
      b_ = Vec3(n[3], n[4], n[5]).normalized();
      break;
    case Shape::Form::block:
      b_ = Vec3(n[3], n[4], n[5]);
      break;
    case Shape::Form::ball:
      radius_ = n[3];
      break;
    default:
      throw std::logic_error("a form that rigid bodies do not have");
  }
}

Vec3 RigidBody::turned(const Vec3& v, double angle) const {
  if (angle == 0) return v;
  const double c = std::cos(angle), s = std::sin(angle);
  return {c * v.x() - s * v.y(), s * v.x() + c * v.y(), v.z()};
}

RigidBody::Nearest RigidBody::nearest(const Vec3& x, double time) const {
  const double angle = spin_ * time;
  const Vec3 at_start = turned(x - velocity_ * time - about_, -angle) + about_;
  const Vec3 local = rotation_.transpose() * (at_start - shift_);
  Nearest found{0, Vec3::Zero()};
  if (form_ == Shape::Form::half_space) {
    found = {(local - a_).dot(b_), b_};
  } else if (form_ == Shape::Form::ball) {
    const double r = (local - a_).norm();
    found = {r - radius_, r > 0 ? Vec3((local - a_) / r) : Vec3::UnitY()};
  } else {
    const Vec3 middle = 0.5 * (a_ + b_), half = 0.5 * (b_ - a_);
    Vec3 beyond = Vec3::Zero();
    int axis = 0;
    double deepest = -std::numeric_limits<double>::infinity();
    for (int k = 0; k < axes_; ++k) {
      const double out = std::abs(local[k] - middle[k]) - half[k];
      beyond[k] = std::copysign(std::max(out, 0.0), local[k] - middle[k]);
      if (out > deepest) deepest = out, axis = k;
    }
    if (deepest > 0)
      found = {beyond.norm(), beyond.normalized()};
    else
      found = {deepest, std::copysign(1.0, local[axis] - middle[axis]) * Vec3::Unit(axis)};
  }
  found.outwards = turned(rotation_ * found.outwards, angle);
  return found;
}

Vec3 RigidBody::velocity(const Vec3& x, double time) const {
  const Vec3 arm = x - about_ - velocity_ * time;
  return velocity_ + spin_ * Vec3(-arm.y(), arm.x(), 0);
}

}  // namespace mpm
