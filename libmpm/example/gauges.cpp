// A body, a measurement: a block with two round cavities and an elliptic one hits a wall. What pressure do
// gauges see in front of the cavities and behind them? Everything that the library does not know is said
// here.
#include <algorithm>
#include <cstdio>
#include <memory>
#include <vector>

#include "libmpm/mpm.hpp"

/// The pressure of the particle that lies nearest to a place at the start, at every sample.
class PressureGauge : public mpm::Measurement {
 public:
  PressureGauge(const char* name, mpm::Vec2 place, const mpm::State& start) : name_(name) {
    const auto distance = [&](const mpm::Vec2& x) { return (x - place).squaredNorm(); };
    const auto& x = start.particles.position;
    particle_ = static_cast<std::size_t>(std::ranges::min_element(x, {}, distance) - x.begin());
  }
  void sample(const mpm::State& s, mpm::Observer&) override {
    highest_ = std::max(highest_, s.particles.pressure[particle_]);
  }
  void finish(const mpm::State&, mpm::RunResult& result) const override {
    result.metrics.push_back({name_, highest_, "Pa", {}});
  }
  void carry(mpm::Archive& a) override { a.number("highest", highest_); }

 private:
  const char* name_;
  std::size_t particle_;
  double highest_ = 0;
};

int main() {
  constexpr double um = 1e-6, ns = 1e-9, cell = 0.1 * um;
  mpm::Scene settings;
  settings.material = mpm::named_material("aluminium");
  settings.numerics = mpm::default_numerics(mpm::SceneKind::cavity_impact);
  settings.numerics.cell_size = cell;
  settings.end_time = 2 * ns;
  settings.measures.area_every = 0.02 * ns;

  const mpm::Region cavities = mpm::disc({2.5 * um, 2 * um}, 0.8 * um) |
                               mpm::disc({5.5 * um, 2 * um}, 0.8 * um) |
                               mpm::ellipse({4 * um, 4.5 * um}, {1.5 * um, 0.5 * um});
  const auto falling = [](const mpm::Vec2&) { return mpm::Vec2(0, -500); };
  mpm::State block = mpm::empty_state({0, 0}, {cell, cell}, 80);
  mpm::fill(block, {mpm::block({0, 0}, {8 * um, 7 * um}) - cavities, falling}, settings);

  mpm::Simulation simulation(settings, std::move(block));
  const mpm::State& start = simulation.state();
  simulation.add(std::make_unique<PressureGauge>("pressure_before_Pa", mpm::Vec2(4 * um, 1 * um), start));
  simulation.add(std::make_unique<PressureGauge>("pressure_behind_Pa", mpm::Vec2(4 * um, 5.5 * um), start));
  const mpm::RunResult result = simulation.run();
  if (result.status != mpm::RunStatus::done) {
    std::fprintf(stderr, "the run failed: %s\n", result.reason.c_str());
    return 1;
  }
  std::printf("highest pressure before the cavities %.2f GPa, behind them %.2f GPa; energy error %.1e\n",
              result.find("pressure_before_Pa")->value * 1e-9,
              result.find("pressure_behind_Pa")->value * 1e-9, result.energy_error);
}
