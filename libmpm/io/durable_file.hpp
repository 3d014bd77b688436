#pragma once
#include <cstddef>
#include <filesystem>
#include <span>

namespace mpm {

/// Replaces a file by these bytes, or leaves it as it was: writes path + ".tmp", syncs it, renames it, syncs
/// the folder. After the return the file survives a loss of power. Two callers must not write one path at
/// once. Throws std::runtime_error naming path, step and the system's reason; the ".tmp" is removed then.
void write_durably(const std::filesystem::path&, std::span<const std::byte>);

}  // namespace mpm
