#pragma once
#include <stdexcept>
#include <string>

namespace mpm {

/// Input that cannot be run; thrown before step 0. The text names parameter, value and what is allowed.
class InputError : public std::runtime_error {
 public:
  using std::runtime_error::runtime_error;
};

}  // namespace mpm
