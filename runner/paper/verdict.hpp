#pragma once
/// A claim before it is judged, and how: whether a number with an interval is beyond a limit is yes, no, or
/// not to be told from what was measured.
#include <fmt/format.h>

#include <cmath>
#include <optional>
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

/// Of a fit without a point to spare.
inline constexpr const char* says_nothing =
    "such a curve goes through any points, and says nothing of their course";

inline Claim claim(std::string name, std::string sentence, std::string study) {
  return {std::move(name), std::move(sentence), std::move(study), "", not_run, ""};
}

/// "0.965 ± 0.012"; the value alone where no interval is known.
inline std::string with_interval(const ValueWithError& number, int decimals) {
  if (!number.error) return fmt::format("{:.{}f}", number.value, decimals);
  return fmt::format("{:.{}f} ± {:.{}f}", number.value, decimals, *number.error, decimals);
}

/// A number without a known interval is taken as it is.
inline Truth is_below(const ValueWithError& number, double limit) {
  const double half = number.error.value_or(0);
  if (number.value + half < limit) return Truth::yes;
  return number.value - half >= limit ? Truth::no : Truth::open;
}

/// Whether a number is within `share` of a reference.
inline Truth is_within(const ValueWithError& number, double reference, double share) {
  return is_below({std::abs(number.value / reference - 1),
                   number.error ? std::optional(*number.error / reference) : std::nullopt},
                  share);
}

/// open where it depends on one that is open.
inline Truth both(Truth a, Truth b) {
  if (a == Truth::no || b == Truth::no) return Truth::no;
  return a == Truth::yes && b == Truth::yes ? Truth::yes : Truth::open;
}

/// Every number is below the one before it. Intervals of two numbers are taken as independent.
inline Truth falls(std::span<const ValueWithError> numbers) {
  Truth truth = Truth::yes;
  for (std::size_t i = 1; i < numbers.size(); ++i) {
    const ValueWithError step{numbers[i].value - numbers[i - 1].value,
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
