#pragma once
/// How several swept parameters become jobs: [sweep].
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "runner/study/axis.hpp"
#include "runner/study/mistakes.hpp"

namespace mpmstudy {

enum class SweepMode { grid, zip, random, latin_hypercube };

struct SweepRequest {
  SweepMode mode = SweepMode::grid;
  std::uint64_t samples = 0;  ///< random, latin-hypercube
  std::uint64_t seed = 0;
  Place samples_place;
  Place place;  ///< of mode, for messages
  std::string written = "\"grid\"";
};

/// Reads [sweep]; null: there is none. Empty after adding mistakes.
std::optional<SweepRequest> read_sweep(const Table*, Mistakes&);

/// The number of jobs, without making any; checks that the axes suit the mode. Empty after adding mistakes,
/// among them: more than `most_jobs`.
std::optional<std::uint64_t> count_jobs(const SweepRequest&, const std::vector<const Axis*>& swept,
                                        std::uint64_t most_jobs, const Place& file, Mistakes&);

/// The value of every swept axis in every job. grid: the last axis varies fastest.
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
