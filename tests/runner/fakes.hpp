#pragma once
/// Jobs, a simulation and a snapshot writer that stand for real ones: small, quick, and the same every time.
#include <atomic>
#include <chrono>
#include <filesystem>
#include <fstream>
#include <string>
#include <thread>
#include <vector>

#include "libmpm/mpm.hpp"
#include "runner/plan/plan.hpp"
#include "tests/temporary_folder.hpp"

namespace mpmstudy::fakes {

using ::TemporaryFolder;

inline mpm::Scene scene(double cavity_radius) {
  mpm::Scene s;
  s.material = mpm::named_material("aluminium");
  s.impact_speed = 200;
  s.block_width = 10e-6;
  s.block_height = 5e-6;
  s.cavity_radius = cavity_radius;
  s.cavity_center_height = 2.9e-6;
  s.end_time = 16e-9;
  s.numerics.cell_size = 0.1e-6;
  s.numerics.particles_per_cell = 1;
  s.numerics.scheme = mpm::ShapeFunction::gimp;
  s.measures.area_every = 0.05e-9;
  s.measures.snapshots = {1e-9, 2.2e-9};
  s.measures.gauges = {{.name = "rear",
                        .of = "velocity_y",
                        .target = mpm::GaugeTarget::beam,
                        .place = {1e-6 / 3, 6e-6},
                        .reductions = {{"late", mpm::Window::mean, 1e-8 / 3, 16e-9}}}};
  return s;
}

/// 32 hexadecimal digits, as a real key has.
inline std::string key(int n) {
  std::string digits = std::to_string(n);
  return std::string(32 - digits.size(), '0') + digits;
}

/// Job n has the cavity radius 1/n um and is predicted to last `seconds`.
inline Job job(int n, double seconds = 1) { return {key(n), scene(1e-6 / n), {1000 + n, 200}, seconds}; }

inline Plan plan(int jobs, const std::string& study = "fake") {
  Plan p;
  p.study = study;
  for (int n = 1; n <= jobs; ++n) p.jobs.push_back(job(n, n));
  return p;
}

/// A result that depends on nothing but the scene; its numbers have all their bits.
inline mpm::RunResult result_of(const mpm::Scene& s) {
  mpm::RunResult r;
  r.particles = 1234;
  r.steps = 100;
  r.energy_error = s.cavity_radius / 3e-3;
  r.outcome = "collapsed";
  r.initial_area = 3.141592653589793 * s.cavity_radius * s.cavity_radius;
  r.final_area = *r.initial_area / 7;
  r.final_area_error = *r.final_area / 100;
  r.collapsibility = 1 - 1.0 / 7;
  for (int i = 0; i < 50; ++i)
    r.area_history.push_back({i * 0.1e-9, *r.initial_area / (1 + i / 3.0), *r.initial_area / (1 + i / 3.1)});
  for (const mpm::Gauge& gauge : s.measures.gauges)
    r.histories.push_back({gauge.name, "m/s", {0, 1e-9 / 3, 16e-9}, {gauge.place.at(0), 1.0 / 3, -200}});
  r.metrics = {{"roundness", 1.0 / 3, "1", 0.1}, {"free_surface_speed_m_s", s.impact_speed / 3, "m/s", {}}};
  return r;
}

/// Ten steps with `pause` between them, two snapshots, then result_of(scene).
inline mpm::RunResult simulate(const mpm::Scene& s, mpm::Observer& observer,
                               std::chrono::milliseconds pause = {}) {
  for (int step = 0; step < 10; ++step) {
    if (step == 3 || step == 6) {
      mpm::Snapshot snapshot;
      snapshot.time = s.end_time * step / 10;
      snapshot.step = step;
      snapshot.x = {s.cavity_radius};
      observer.on_snapshot(snapshot);
    }
    if (pause.count() > 0) std::this_thread::sleep_for(pause);
    if (!observer.on_step({step, s.end_time * step / 10, s.end_time, 1e-12, 1234})) {
      mpm::RunResult stopped;
      stopped.status = mpm::RunStatus::stopped;
      return stopped;
    }
  }
  return result_of(s);
}

inline void write_snapshot(const std::filesystem::path& path, const mpm::Snapshot& snapshot) {
  std::ofstream(path) << snapshot.time << " " << snapshot.x.at(0);
}

}  // namespace mpmstudy::fakes
