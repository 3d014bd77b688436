#pragma once
#include "libmpm/material/eos/temperature.hpp"
#include "libmpm/observer.hpp"
#include "libmpm/step/state.hpp"

namespace mpm {

/// The fields of all particles, in the words of users.
template <int axes>
Snapshot snapshot_of(const BasicState<axes>&, const Temperature&);

}  // namespace mpm
