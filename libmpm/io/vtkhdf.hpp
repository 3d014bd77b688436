#pragma once
/// Snapshots as VTKHDF, which ParaView opens: an UnstructuredGrid of vertices, version 1.0, one piece.
///
///   /VTKHDF            attributes Version [1, 0], Type "UnstructuredGrid", time, time_unit "s", step
///     Points           (n, 3) [m]; z = 0 in scenes of two axes
///     Connectivity, Offsets, Types, NumberOf{Points,Cells,ConnectivityIds}
///     PointData/       Velocity (n, 3), and the datasets of the table of fields (fields.hpp):
///                      those of three axes only in scenes that have them
///     FieldData/       Time, Step
///
/// Every dataset carries the attribute `unit` (SI; "1" for a pure number). Numbers are stored as they are in
/// memory (64-bit), compressed without loss. Equal snapshots give equal files. Signs are those of Snapshot.
/// Format: https://docs.vtk.org/en/latest/vtk_file_formats/vtkhdf_file_format/
///
/// Any thread may call; calls take turns, because Debian's HDF5 is built without thread safety. The disk is
/// written outside of that turn.
#include <filesystem>

#include "libmpm/observer.hpp"

namespace mpm {

/// As write_durably() does: a file that has its name is whole. An existing file is
/// replaced. Throws std::runtime_error naming path and cause; std::invalid_argument for columns of unequal
/// length.
void write_vtkhdf(const std::filesystem::path&, const Snapshot&);

/// Reads what write_vtkhdf() wrote, bit for bit. Throws std::runtime_error naming path and cause.
Snapshot read_vtkhdf(const std::filesystem::path&);

}  // namespace mpm
