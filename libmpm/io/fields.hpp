#pragma once
/// The one table of the fields of a snapshot: what a study may draw, the arrays of a VTKHDF file, labels of
/// figures and the list on the page of study files are made from it. A new field is a member of Snapshot and
/// a row; a member without a row does not compile.
#include <span>
#include <string_view>
#include <vector>

#include "libmpm/material/eos/temperature.hpp"
#include "libmpm/observer.hpp"
#include "libmpm/step/state.hpp"

namespace mpm {

/// One number of each particle.
struct Field {
  std::string_view name;    ///< in study files: "velocity_x"
  const char* unit;         ///< SI, "J/m^3"; "1" for a pure number
  std::string_view symbol;  ///< for figures, or ""
  std::string_view title;   ///< in figures, where it is not the name in words
  const char* dataset;      ///< of a VTKHDF file; "": in one that holds a vector
  std::vector<double> Snapshot::*values;
  double (*of)(const State&, std::size_t particle, const Temperature&);
};

/// In the order of the datasets of a file.
std::span<const Field> fields();
const Field* find_field(std::string_view name);  ///< null if there is none

}  // namespace mpm
