#pragma once
#include "libmpm/material/eos/temperature.hpp"
#include "libmpm/observer.hpp"
#include "libmpm/step/state.hpp"

namespace mpm {

/// The fields of all particles, in the words of users; a temperature for each material.
template <int axes>
Snapshot snapshot_of(const BasicState<axes>&, std::span<const Temperature>);

}  // namespace mpm
