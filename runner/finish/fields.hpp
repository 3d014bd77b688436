#pragma once
#include <string>
#include <vector>

#include "analysis/raster.hpp"
#include "libmpm/simulation.hpp"

namespace mpmstudy {

/// Particles of a snapshot, coloured by the field that a study calls by this name ("pressure",
/// "plastic_work", ...). Throws std::runtime_error for a field that it does not have.
/// `materials`: the number of each particle's material; empty, or of another length: there is one.
analysis::ParticleSquares particles_of(const mpm::Snapshot&, const std::string& field,
                                       const std::vector<int>& materials = {});

/// The number of the material of each particle of a scene, in the order of snapshots; empty: it has one
/// material.
std::vector<int> materials_of(const mpm::Scene&);

}  // namespace mpmstudy
