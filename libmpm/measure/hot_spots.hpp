#pragma once
#include "libmpm/material/eos/temperature.hpp"
#include "libmpm/measure/measurement.hpp"
#include "libmpm/measure/results.hpp"

namespace mpm {

/// Where the body is hottest at the end: the 99.9 percentile by mass of plastic work per volume and of
/// temperature, and the mass centre of what lies above it (in half a scene: of the half). Metrics:
/// hot_spot_work_J_m3, hot_spot_x_m, hot_spot_y_m, hot_spot_temperature_K.
class HotSpots : public Measurement {
 public:
  static std::span<const ResultRow> results();
  explicit HotSpots(Temperature t) : temperature_(t) {}
  void finish(const State&, RunResult&) const override;
  void carry(Archive&) override {}

 private:
  Temperature temperature_;
};

}  // namespace mpm
