#pragma once
/// What a study says about how its sweeps combine: [sweep].
#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "runner/study/mistakes.hpp"

namespace mpmstudy {

enum class SweepMode { grid, zip, random, latin_hypercube, sobol, halton };
std::string_view to_string(SweepMode);
/// Modes that draw `samples` points from ranges and distributions.
bool is_sampled(SweepMode);

/// Swept parameters of a grid that go together: first value with first, second with second.
struct ZipGroup {
  std::vector<std::string> names;
  Place place;
  std::string key, written;  ///< for messages: what of [sweep] says it
  bool of_file = false;      ///< columns of `points`; one that --set gives another value is none any more
};

struct SweepRequest {
  SweepMode mode = SweepMode::grid;
  std::uint64_t samples = 0;  ///< of sampled modes
  std::uint64_t seed = 0;
  Place samples_place;
  Place place;  ///< of mode, for messages
  std::string written = "\"grid\"";
  std::vector<ZipGroup> groups;
  bool skips_invalid = false;  ///< points that cannot be run are left out, and counted
  Place invalid_place;
};

/// Reads [sweep] but for `points` and `require`; null: there is none. Empty after adding mistakes.
std::optional<SweepRequest> read_sweep(const Table*, Mistakes&);

}  // namespace mpmstudy
