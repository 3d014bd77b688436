#pragma once
#include "libmpm/core/tensor.hpp"

namespace mpm {

/// Bodies that push and slide freely: no tangential impulse.
struct Frictionless {
  template <int axes>
  Vec<axes> tangential(const Vec<axes>& /*holding*/, double /*normal*/) const {
    return Vec<axes>::Zero();
  }
};

}  // namespace mpm
