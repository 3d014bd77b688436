#pragma once
/// Whether a number with an interval is beyond a limit: yes, no, or not to be told from what was measured.
#include <cmath>
#include <span>
#include <string>

#include "runner/catalog/records.hpp"
#include "runner/finish/study_results.hpp"

namespace mpmstudy {

enum class Truth { yes, no, open };

inline constexpr const char* holds = "holds";
inline constexpr const char* does_not_hold = "does not hold";
inline constexpr const char* not_decided = "not decided at these cells";
inline constexpr const char* not_comparable = "not comparable";
inline constexpr const char* not_run = "not run";

/// A number without a known interval is taken as it is.
inline Truth is_below(const Measured& number, double limit) {
  const double half = number.error.value_or(0);
  if (number.value + half < limit) return Truth::yes;
  return number.value - half >= limit ? Truth::no : Truth::open;
}

/// open where it hangs on one that is open.
inline Truth both(Truth a, Truth b) {
  if (a == Truth::no || b == Truth::no) return Truth::no;
  return a == Truth::yes && b == Truth::yes ? Truth::yes : Truth::open;
}

/// Every number is below the one before it. Intervals of two numbers are taken as independent.
inline Truth falls(std::span<const Measured> numbers) {
  Truth truth = Truth::yes;
  for (std::size_t i = 1; i < numbers.size(); ++i) {
    const Measured step{numbers[i].value - numbers[i - 1].value,
                        std::hypot(numbers[i].error.value_or(0), numbers[i - 1].error.value_or(0))};
    truth = both(truth, is_below(step, 0));
  }
  return truth;
}

inline void judge(Claim& c, Truth truth, std::string measured, std::string note) {
  c.verdict = truth == Truth::yes ? holds : truth == Truth::no ? does_not_hold : not_decided;
  c.measured = std::move(measured);
  c.note = std::move(note);
}
inline void judge(Claim& c, bool truth, std::string measured, std::string note) {
  judge(c, truth ? Truth::yes : Truth::no, std::move(measured), std::move(note));
}

}  // namespace mpmstudy
