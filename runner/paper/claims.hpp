#pragma once
/// What the paper says of its results, each held against the numbers of a catalog.
#include <filesystem>
#include <string>
#include <vector>

#include "runner/catalog/records.hpp"
#include "runner/study/study.hpp"

namespace mpmstudy {

/// Every claim, in the order of the paper, judged on `studies` as their files say. A study that is not among
/// them, or that the catalog does not have in that form, or not all of it, leaves its claims "not run", and
/// `measured` says why: what `run --set` put under its name is no evidence. Throws CatalogError if there is
/// no catalog, std::runtime_error for a snapshot that cannot be read.
std::vector<Claim> judge_claims(const std::filesystem::path& results, const std::vector<Study>& studies);

/// Names of the studies that claims rest on.
const std::vector<std::string>& studies_of_claims();

}  // namespace mpmstudy
