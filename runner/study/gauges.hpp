#pragma once
/// [[gauge]]: what the jobs of a study record over time.
#include <map>
#include <string>
#include <vector>

#include "libmpm/scene/gauge.hpp"
#include "runner/study/mistakes.hpp"
#include "runner/study/quantity_reader.hpp"
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
  std::map<std::size_t, Expression> coordinates;  ///< of its place, that are expressions: 0 is x
};

/// By name: the order in which a file has them is no part of what a job is.
std::vector<GaugeRequest> read_gauges(const Table& document, const Units&, const KnownParameters&, Mistakes&);

/// [[stop]]: adds to the gauges at what values they end a run. `spaces`: those of the study, one or more.
void read_stops(const Table& document, const std::vector<mpm::Space>& spaces, const Units&,
                std::vector<GaugeRequest>&, Mistakes&);

/// The unit of a number of a gauge in these scenes, by their own gauges: another study may have one of that
/// name. "kg/m or kg/rad" where their spaces differ; "": they have no such gauge.
std::string unit_of_gauge(const std::vector<const mpm::Scene*>&, const std::string& metric);

/// "rear.max", ...: all that the gauges of a study come to.
std::vector<std::string> metrics_of(const std::vector<mpm::Gauge>&);

}  // namespace mpmstudy
