#pragma once
/// Gauges of a scene as text, for the catalog, for other processes and for `plan --json`.
#include <string>
#include <vector>

#include "libmpm/scene/gauge.hpp"

namespace mpmstudy {

/// A JSON array with an object for each gauge; numbers keep their bits. "[]": none.
std::string gauges_text(const std::vector<mpm::Gauge>&);

/// The same way back. Throws std::invalid_argument where it is no such text.
std::vector<mpm::Gauge> gauges_from_text(const std::string&);

}  // namespace mpmstudy
