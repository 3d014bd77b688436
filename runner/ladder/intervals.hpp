#pragma once
#include <filesystem>
#include <vector>

#include "runner/catalog/records.hpp"
#include "runner/study/study.hpp"

namespace mpmstudy {

/// The interval of everything that the done jobs of a registered study have measured, each from the cells
/// that its ladder has (view `ladders`). One cell gives none. Throws CatalogError.
std::vector<IntervalRow> intervals_of(const Study&, const std::filesystem::path& results);

}  // namespace mpmstudy
