#pragma once
#include <cstdint>
#include <filesystem>
#include <string>

namespace mpmstudy {

/// XXH3-128 of a file's bytes as 32 hexadecimal digits. Throws CatalogError.
std::string checksum_of(const std::filesystem::path&);

/// What is wrong with a file that was written with this size and checksum: missing, another size, other
/// bytes.
/// "" if nothing is. Without a checksum the bytes are not looked at.
std::string what_is_wrong(const std::filesystem::path&, std::int64_t bytes, const std::string& checksum);

/// When a file was last changed, by the clock of its file system [ns since 1970]; 0 if there is none.
std::int64_t modified_ns(const std::filesystem::path&);

/// Of a job that can be gone on with, in its folder; see exec/job_checkpoint.hpp.
inline constexpr const char* checkpoint_name = "checkpoint.h5";

}  // namespace mpmstudy
