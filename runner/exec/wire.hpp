#pragma once
/// How a job goes from one process to another, and an attempt at it back: bytes, every double with its bits.
#include <string>

#include "runner/exec/attempt.hpp"

namespace mpmstudy {

/// A job to be tried: key, scene (every parameter of libmpm/scene/parameters.hpp), limits.
struct Order {
  std::string key;
  mpm::Scene scene;
  Limits limits;
  double checkpoint_s = 0;
};

std::string to_bytes(const Order&);
std::string to_bytes(const Attempt&);
// Both throw std::runtime_error if these bytes are not what to_bytes gives.
Order order_from_bytes(const std::string&);
Attempt attempt_from_bytes(const std::string&);

}  // namespace mpmstudy
