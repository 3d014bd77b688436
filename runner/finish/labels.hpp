#pragma once
#include <string_view>

#include "analysis/units.hpp"

namespace mpmstudy {

/// How people read what a study, the catalog or a snapshot calls by this name: a parameter, a result, a
/// field, or a column of the view `area_history`, by the tables of libmpm. Of a name that is in none of them:
/// its words, and the unit that the caller knows.
analysis::QuantityLabel label_of(std::string_view name, std::string_view unit_if_unknown = "1");

}  // namespace mpmstudy
