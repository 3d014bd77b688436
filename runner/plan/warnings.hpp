#pragma once
/// Warnings about a valid study before it runs: values that do nothing, parts that the grid does not
/// show, states that the model does not hold for. Pure.
#include <string>
#include <vector>

#include "runner/plan/plan.hpp"

namespace mpmstudy {

/// "studies/a.toml:12:16: spall_strength: ...", one line each, in no order that matters; what is the same in
/// many jobs is said once.
std::vector<std::string> warnings_of(const Study&, const Plan&);

}  // namespace mpmstudy
