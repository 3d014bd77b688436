#pragma once
#include <utility>
#include <vector>

#include "libmpm/material/eos/temperature.hpp"
#include "libmpm/measure/measurement.hpp"
#include "libmpm/measure/results.hpp"

namespace mpm {

/// Where the body is hottest at the end: the 99.9 percentile by mass of plastic work per volume and of
/// temperature, and the mass centre of what lies above it (in half a scene: of the half). Metrics:
/// hot_spot_work_J_m3, hot_spot_x_m, hot_spot_y_m, of three axes hot_spot_z_m, hot_spot_temperature_K.
template <int axes>
class BasicHotSpots : public BasicMeasurement<axes> {
 public:
  static std::span<const ResultRow> results();
  /// One temperature for each material of the scene.
  explicit BasicHotSpots(std::vector<Temperature> of_materials) : temperatures_(std::move(of_materials)) {}
  void finish(const BasicState<axes>&, RunResult&) const override;
  void carry(Archive&) override {}

 private:
  std::vector<Temperature> temperatures_;
};
using HotSpots = BasicHotSpots<2>;

}  // namespace mpm
