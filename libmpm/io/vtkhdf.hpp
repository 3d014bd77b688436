#pragma once
#include <filesystem>

#include "libmpm/simulation.hpp"

namespace mpm {

/// Writes a snapshot as VTKHDF (UnstructuredGrid of vertices, version 1.0), which ParaView opens.
/// Every dataset carries a `unit` attribute; /VTKHDF carries time [s] and step. Writes to path + ".tmp",
/// syncs, and renames: a file that has its name is whole. Throws std::runtime_error naming path and cause.
void write_vtkhdf(const std::filesystem::path&, const Snapshot&);

}  // namespace mpm
