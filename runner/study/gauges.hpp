#pragma once
/// [[gauge]]: what the jobs of a study record over time.
#include <functional>
#include <map>
#include <string>
#include <string_view>
#include <vector>

#include "libmpm/scene/gauge.hpp"
#include "runner/study/job_quantity.hpp"
#include "runner/study/mistakes.hpp"
#include "runner/study/units.hpp"

namespace mpmstudy {

/// A gauge as it is written.
struct GaugeRequest {
  mpm::Gauge gauge;
  Place place;  ///< of its table
  /// Of its keys, where each value stands: "point", "reduce.plateau".
  struct Written {
    Place place;
    std::string text;
  };
  std::map<std::string, Written> keys;
  /// A number of the gauge that is an expression, and what it is a number of.
  struct OfJob {
    JobQuantity number;
    std::function<void(mpm::Gauge&, double si)> set;
  };
  std::vector<OfJob> of_job;

  /// A number of the gauge: set now where it is the same in every job, else job by job.
  void take(JobQuantity, std::function<void(mpm::Gauge&, double si)> set);
  /// Gives the gauge of one job its numbers, and sorts its stops.
  void value_in(mpm::Gauge&, const ValueOf&, Mistakes&) const;
};

/// By name: the order in which a file has them is no part of what a job is.
std::vector<GaugeRequest> read_gauges(const Table& document, const Units&, const KnownParameters&, Mistakes&);

/// [[stop]]: adds to the gauges at what values they end a run. `spaces`: those of the study, one or more.
void read_stops(const Table& document, const std::vector<mpm::Space>& spaces, const Units&,
                const KnownParameters&, std::vector<GaugeRequest>&, Mistakes&);

/// The parts of a reduction or of a condition that are numbers: of "mean 1 ns to 3 ns", "rear < limit".
/// Empty where it is neither.
std::vector<std::string_view> numbers_of_reduction(std::string_view);
std::vector<std::string_view> numbers_of_condition(std::string_view);

/// The unit of a number of a gauge in these scenes, by their own gauges: another study may have one of that
/// name. "kg/m or kg/rad" where their spaces differ; "": they have no such gauge.
std::string unit_of_gauge(const std::vector<const mpm::Scene*>&, const std::string& metric);

/// "rear.max", ...: all that the gauges of a study come to.
std::vector<std::string> metrics_of(const std::vector<mpm::Gauge>&);

}  // namespace mpmstudy
