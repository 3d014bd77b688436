#pragma once
/// Gauges: what a scene records over time beside its metrics. Plain data; measure/gauges.hpp reads them, and
/// RunResult::histories holds what they saw.
///
///   scene.measures.gauges = {{.name = "rear", .of = "velocity_y", .target = GaugeTarget::beam,
///                             .place = {0, 8e-6}}};
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "libmpm/space/space.hpp"

namespace mpm {

/// What a gauge looks at.
enum class GaugeTarget {
  point,    ///< the material point that is at `place` at time 0, wherever it goes
  place,    ///< a place that stays where it is, and the material that is there
  beam,     ///< the first surface that a beam from `place` along `direction` meets, as a laser does
  body,     ///< a body as a whole
  wall,     ///< the push of a wall
  contact,  ///< what one body gives another where they touch
};

/// What becomes one number of a history between two times.
enum class Window {
  mean,      ///< over time, of straight lines between samples; of two equal times the value then
  largest,   ///< of the samples
  smallest,  ///< of the samples
};

/// One number of a history: the metric "GAUGE.NAME". max, min and end (the last value) every gauge has, and
/// stop is that of its thresholds.
struct Reduction {
  std::string name;
  Window window = Window::mean;
  double from = 0, to = 0;  ///< [s], from <= to
  bool operator==(const Reduction&) const = default;
};

/// The run ends at the first sample from `after` on that is beyond the value. When it was there is the metric
/// "GAUGE.stop", between samples by a straight line.
struct Threshold {
  bool below = true;  ///< false: above
  double value = 0;   ///< in the unit of the gauge
  double after = 0;   ///< [s]
  bool operator==(const Threshold&) const = default;
};

struct Gauge {
  std::string name;  ///< of its history; letters, digits, '-' and '_'
  std::string of;    ///< one of gauge_quantities(target): "velocity_y"
  GaugeTarget target = GaugeTarget::point;
  std::vector<double> place = {};       ///< of point, place and beam: a coordinate for each axis [m]
  std::string direction = "-y";         ///< of a beam: "+x", "-x", "+y", ...
  std::string body = "all";             ///< of a body: which
  std::string wall = "bottom";          ///< of a wall: which
  std::string first = {}, second = {};  ///< of a contact: the bodies; forces are those on the first
  std::vector<Reduction> reductions = {};
  std::vector<Threshold> stops = {};
  bool operator==(const Gauge&) const = default;
};

/// What a gauge can read.
struct GaugeQuantity {
  std::string_view name, meaning;
  std::string_view unit;                 ///< SI, in plane strain: "J/m" where it is per metre of depth
  std::string_view axisymmetric = unit;  ///< ... "J/rad" where it is per radian
  std::string_view three_d = unit;       ///< ... "J", of the whole
  bool only_of_three_axes = false;
  bool not_axisymmetric = false;

  std::string_view unit_in(Space) const;
  bool is_in(Space) const;
};

std::string_view to_string(GaugeTarget);  ///< "point": its key in study files
std::string_view to_string(Window);       ///< "mean", "max", "min"
std::optional<Window> window_from(std::string_view);
/// All that a gauge with such a target can read.
const std::vector<GaugeQuantity>& gauge_quantities(GaugeTarget);
/// Null if there is none of that name.
const GaugeQuantity* find_gauge_quantity(GaugeTarget, std::string_view name);

/// Metrics that every gauge has: "NAME.max", "NAME.min", "NAME.end".
inline constexpr std::string_view gauge_metrics[] = {"max", "min", "end"};
inline constexpr std::string_view stop_metric = "stop";
/// Whether a reduction may not have this name: it is that of another metric.
bool is_kept_name(std::string_view);
/// All metrics of a gauge: those, its reductions, and "NAME.stop" where it can end a run.
std::vector<std::string> metrics_of(const Gauge&);
/// SI unit of one of them: that of what the gauge reads, or s.
std::string_view unit_of_metric(const Gauge&, std::string_view metric, Space);
/// Whether a metric is one of a gauge: no other has a dot in its name.
inline bool is_of_gauge(std::string_view metric) { return metric.find('.') != metric.npos; }

/// Names of gauges and of reductions: letters, digits, '-' and '_', up to 60.
bool is_gauge_name(std::string_view);

/// "+x" -> {0, 1}. axis -1: no such direction.
struct BeamDirection {
  int axis = -1, sign = 1;
};
BeamDirection beam_direction(std::string_view);
/// Those of so many axes.
std::vector<std::string_view> beam_directions(int axes);

}  // namespace mpm
