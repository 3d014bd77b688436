#pragma once
/// What the paper says of its results, each held against the numbers of a catalog.
#include <filesystem>
#include <vector>

#include "runner/catalog/records.hpp"

namespace mpmstudy {

/// Every claim, in the order of the paper. A study that the catalog does not have, or has not done, leaves
/// its claims "not run". Throws CatalogError if there is no catalog, std::runtime_error for a snapshot that
/// cannot be read.
std::vector<Claim> judge_claims(const std::filesystem::path& results);

}  // namespace mpmstudy
