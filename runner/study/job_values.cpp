#include "runner/study/job_values.hpp"

#include <functional>
#include <limits>

namespace mpmstudy {

std::vector<Assignment> assignments(const std::vector<Axis>& axes) {
  std::vector<Assignment> unordered;
  std::size_t column = 0;
  for (const Axis& axis : axes) unordered.push_back({&axis, axis.swept ? column++ : not_swept});
  std::vector<Assignment> ordered;
  const auto take = [&](std::string_view name) {
    for (const Assignment& one : unordered)
      if (one.axis->name() == name) ordered.push_back(one);
  };
  for (const Assignment& one : unordered)
    if (one.axis->own) ordered.push_back(one);
  take(mpm::material_choice().name);
  take(space_name);
  for (const mpm::Quantity& row : mpm::quantities()) take(row.name);
  for (const mpm::Choice& row : mpm::choices())
    if (row.name != space_name) take(row.name);
  return ordered;
}

double JobValues::operator()(const Assignment& one) const {
  return one.axis->expression ? one.axis->expression->value(std::cref(*this))
                              : one.point(combinations_, job_).value;
}

double JobValues::operator()(const std::string& name) const {
  for (const Assignment& one : assignments_)
    if (one.axis->quantity && one.axis->name() == name) return (*this)(one);
  return std::numeric_limits<double>::quiet_NaN();
}

}  // namespace mpmstudy
