#pragma once
#include <string>

#include "analysis/raster.hpp"
#include "libmpm/simulation.hpp"

namespace mpmstudy {

/// Particles of a snapshot, coloured by the field that a study calls by this name ("pressure",
/// "plastic_work", ...). Throws std::runtime_error for a field that it does not have.
analysis::ParticleSquares particles_of(const mpm::Snapshot&, const std::string& field);

}  // namespace mpmstudy
