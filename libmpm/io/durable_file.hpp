#pragma once
#include <cstddef>
#include <filesystem>
#include <span>

namespace mpm {

/// Replaces a file by these bytes, or leaves it as it was: writes PATH.RANDOM.tmp, syncs it, renames it,
/// syncs the folder. After the return the file survives a loss of power. Of two processes that write one path
/// at once, each writes a file of its own, and the last one's stays. Throws std::runtime_error naming path,
/// step and the system's reason; the ".tmp" is removed then. A process that is killed leaves it.
void write_durably(const std::filesystem::path&, std::span<const std::byte>);

}  // namespace mpm
