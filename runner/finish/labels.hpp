#pragma once
#include <set>
#include <string>
#include <string_view>

#include "analysis/units.hpp"
#include "runner/study/study.hpp"

namespace mpmstudy {

/// How people read what a study, the catalog or a snapshot calls by this name: a parameter, a result, a
/// field, or a column of the view `area_history`, by the tables of libmpm. Of a name that is in none of them:
/// its words, and the unit that the caller knows.
analysis::QuantityLabel label_of(std::string_view name, std::string_view unit_if_unknown = "1");

/// The same of a quantity of the study, which may be one of its own: that is named as it is written.
analysis::QuantityLabel label_of_parameter(const Study&, const std::string& name);

/// "physics version 5": those that the keys of the study's jobs begin with; the plain step counts its own.
std::string physics_versions_text(const std::set<int>& versions);
std::set<int> physics_versions_of(const Study&);

}  // namespace mpmstudy
