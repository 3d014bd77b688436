#pragma once
/// What every parameter of a study is in one job of its sweep.
#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

#include "runner/study/axis.hpp"
#include "runner/study/combine.hpp"

namespace mpmstudy {

inline constexpr std::string_view space_name = "space";

inline constexpr std::size_t not_swept = static_cast<std::size_t>(-1);

struct Assignment {
  const Axis* axis = nullptr;
  std::size_t column = not_swept;  ///< of Combinations

  const Point& point(const Combinations& combinations, std::uint64_t job) const {
    return column == not_swept ? axis->points[0] : combinations.at(job, column);
  }
};

/// The study's own first, then the material and the space, which bring numbers of their own, then in the
/// order of the parameter table, quantities first: later rows may be made of earlier ones.
std::vector<Assignment> assignments(const std::vector<Axis>&);

/// The values of parameters in one job. Keeps references.
class JobValues {
 public:
  JobValues(const std::vector<Assignment>& assignments, const Combinations& combinations)
      : assignments_(assignments), combinations_(combinations) {}

  void of_job(std::uint64_t job) { job_ = job; }
  double operator()(const Assignment&) const;
  /// Not a number where it has none: expressions have names that the file gives, and choices have no value.
  double operator()(const std::string& name) const;

 private:
  const std::vector<Assignment>& assignments_;
  const Combinations& combinations_;
  std::uint64_t job_ = 0;
};

}  // namespace mpmstudy
