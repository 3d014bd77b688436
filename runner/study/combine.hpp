#pragma once
/// How several swept parameters become the points of a sweep.
#include <cstdint>
#include <optional>
#include <vector>

#include "runner/study/axis.hpp"
#include "runner/study/sweep_request.hpp"

namespace mpmstudy {

/// The swept parameters whose values go together: of a group, of a zip, and all of a sampled mode.
std::vector<std::vector<std::string>> swept_together(const SweepRequest&,
                                                     const std::vector<const Axis*>& swept);

/// The number of jobs, without making any; checks that the axes suit the mode. Empty after adding mistakes,
/// among them: more than `most_jobs`.
std::optional<std::uint64_t> count_jobs(const SweepRequest&, const std::vector<const Axis*>& swept,
                                        std::uint64_t most_jobs, const Place& file, Mistakes&);

/// The value of every swept axis in every job. grid: the last axis varies fastest; a group of axes that go
/// together stands where its first one does.
class Combinations {
 public:
  /// jobs: from count_jobs.
  Combinations(const SweepRequest&, const std::vector<const Axis*>& swept, std::uint64_t jobs);
  std::uint64_t jobs() const { return jobs_; }
  const Point& at(std::uint64_t job, std::size_t axis) const {
    const Column& column = columns_[axis];
    return column.points[job / column.stride % column.points.size()];
  }
  const std::vector<Point>& points(std::size_t axis) const { return columns_[axis].points; }

 private:
  struct Column {
    std::vector<Point> points;
    std::uint64_t stride = 1;
  };
  std::uint64_t jobs_;
  std::vector<Column> columns_;
};

}  // namespace mpmstudy
