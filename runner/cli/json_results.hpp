#pragma once
#include <filesystem>
#include <nlohmann/json.hpp>
#include <vector>

#include "runner/study/study.hpp"

namespace mpmstudy {

/// What a study has come to, for programs: SI, all digits, every job in one flat object
/// (runner/cli/README.md). Throws CatalogError.
nlohmann::ordered_json results_json(const Study&, const std::filesystem::path& results);

/// {"studies": [...], "catalog", "exit_code"}, as text.
std::string results_json(const std::vector<Study>&, const std::filesystem::path& results, int exit_code);

}  // namespace mpmstudy
