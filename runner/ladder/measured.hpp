#pragma once
#include <filesystem>
#include <optional>
#include <string>

#include "analysis/extrapolation.hpp"
#include "runner/plan/plan.hpp"

namespace mpmstudy {

/// One rung of a ladder as far as it is known.
struct RungState {
  bool decided = false;                        ///< done or failed
  std::optional<analysis::LadderPoint> point;  ///< empty: not done, or it does not show the quantity
};

/// What the catalog has of a job and of one quantity that it may have measured. Throws CatalogError.
RungState recorded(const std::filesystem::path& results, const Job&, const std::string& quantity);

}  // namespace mpmstudy
