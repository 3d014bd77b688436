#pragma once
/// The one table of the fields of a snapshot: what a study may draw, the arrays of a VTKHDF file, labels of
/// figures and the list on the page of study files are made from it. A new field is a member of Snapshot and
/// a row; a member without a row does not compile.
#include <span>
#include <string_view>
#include <type_traits>
#include <vector>

#include "libmpm/material/eos/temperature.hpp"
#include "libmpm/observer.hpp"
#include "libmpm/step/state.hpp"

namespace mpm {

/// How a number is read of a state of two and of three axes; null: no state of two axes has it.
struct FieldValue {
  template <int axes>
  using Read = double (*)(const BasicState<axes>&, std::size_t particle, const Temperature&);

  template <class Function>
  constexpr FieldValue(Function of) : three(of) {
    if constexpr (std::is_convertible_v<Function, Read<2>>) two = of;
  }
  double operator()(const State& s, std::size_t p, const Temperature& t) const { return two(s, p, t); }
  double operator()(const BasicState<3>& s, std::size_t p, const Temperature& t) const {
    return three(s, p, t);
  }

  Read<2> two = nullptr;
  Read<3> three;
};

/// One number of each particle.
struct Field {
  std::string_view name;    ///< in study files: "velocity_x"
  const char* unit;         ///< SI, "J/m^3"; "1" for a pure number
  std::string_view symbol;  ///< for figures, or ""
  std::string_view title;   ///< in figures, where it is not the name in words
  const char* dataset;      ///< of a VTKHDF file; "": in one that holds a vector
  std::vector<double> Snapshot::*values;
  FieldValue of;
  const char* unit_of_three_axes = unit;

  bool only_of_three_axes() const { return !of.two; }
  const char* unit_in(const Snapshot& s) const { return s.has_depth() ? unit_of_three_axes : unit; }
};

/// In the order of the datasets of a file.
std::span<const Field> fields();
const Field* find_field(std::string_view name);  ///< null if there is none

}  // namespace mpm
