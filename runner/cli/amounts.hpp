#pragma once
/// Amounts on the command line: "10 min", "2 GB".
#include <cstdint>
#include <string>

namespace mpmstudy {

/// Seconds; 0 for "" and "0". A plain number is one of seconds. Throws StudyError that names the option.
double read_duration(const std::string& option, const std::string& text);

/// Bytes, by B, kB, MB, GB, TB (powers of 1000) or KiB, MiB, GiB, TiB (of 1024); 0 for "". Throws StudyError.
std::uint64_t read_bytes(const std::string& option, const std::string& text);

}  // namespace mpmstudy
