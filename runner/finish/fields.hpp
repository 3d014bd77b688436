#pragma once
#include <string>
#include <vector>

#include "analysis/raster.hpp"
#include "libmpm/simulation.hpp"
#include "runner/study/study.hpp"

namespace mpmstudy {

/// Particles of a snapshot, coloured by the field that a study calls by this name ("pressure",
/// "plastic_work", ...). Throws std::runtime_error for a field that it does not have.
/// `materials`: the number of each particle's material; empty, or of another length: there is one.
/// Of three axes what `view` says: the particles of a slice (less than twice their own edge away from it, and
/// how far), or one square for each column of particles, as wide as a particle, which has no material. Along
/// x a place is drawn at (z, y), along y at (x, z), along z at (x, y).
analysis::ParticleSquares particles_of(const mpm::Snapshot&, const std::string& field,
                                       const std::vector<int>& materials = {}, const FieldView& view = {});

/// How the pictures of one job are shown: with the view in the title, along which axes, and with its image
/// where that of the axis across is no part of what is modelled.
struct FieldPicture {
  std::string title, across = "x", up = "y";
  bool mirrored = false;
};
/// `label`: of the job among those of the study, or "".
FieldPicture picture_of(const FigureRequest&, const mpm::Scene&, const std::string& label = "");

/// The number of the material of each particle of a scene, in the order of snapshots; empty: it has one
/// material.
std::vector<int> materials_of(const mpm::Scene&);

}  // namespace mpmstudy
