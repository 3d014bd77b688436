#pragma once
/// Units of study files, by UDUNITS-2, whose C library this is the only user of.
#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <variant>

#include "runner/study/dimension.hpp"

namespace mpmstudy {

/// How numbers in one unit become numbers in another: a plain value, independent of the unit library.
struct Conversion {
  std::optional<int> shift;  ///< the factor is 10^shift exactly and there is no offset
  double slope = 1;          ///< otherwise: to = slope from + offset
  double offset = 0;

  /// `number`: decimal text. Correctly rounded where shift is known. Empty: not a number, or out of range.
  std::optional<double> operator()(std::string_view number) const;
};

/// The unit system. UDUNITS-2 is not thread-safe: use Units from one thread of the program at a time.
class Units {
 public:
  /// Loads the unit database. Throws std::runtime_error if there is none.
  Units();
  ~Units();
  Units(const Units&) = delete;
  Units& operator=(const Units&) = delete;

  /// From unit `from`, as written in a study ("um", "kg/m3", "degC"), to `to`, SI as in the parameter table
  /// ("1": a pure number). The string says what is wrong with `from`: "no such unit", "cannot be ...".
  std::variant<Conversion, std::string> conversion(std::string_view from, std::string_view to) const;

  /// Of a unit as written in a study. Empty: it is none.
  std::optional<Dimension> dimension(std::string_view unit) const;

 private:
  struct System;
  std::unique_ptr<System> system_;
};

}  // namespace mpmstudy
