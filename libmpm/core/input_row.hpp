#pragma once
/// Words of the tables of parameters (scene/parameters.hpp, material/row.hpp).

namespace mpm {

/// The table of a study file that a parameter is written in.
enum class Section { top, parameters, material, numerics, measure };

/// What a number may be, by itself (find_problems knows how numbers go together).
enum class Range {
  positive,
  non_negative,
  non_negative_or_infinite,
  count,  ///< a positive whole number
  any
};

}  // namespace mpm
