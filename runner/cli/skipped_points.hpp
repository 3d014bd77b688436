#pragma once
#include <nlohmann/json.hpp>
#include <string>

#include "runner/study/study.hpp"

namespace mpmstudy {

/// Lines for people about the points of a sweep that are no jobs, with how many for each reason; "": there
/// are none.
std::string skipped_text(const Study&);
/// [{"why", "points", "first"}]
nlohmann::ordered_json skipped_json(const Study&);

}  // namespace mpmstudy
