#include <algorithm>
#include <cmath>

#include "libmpm/core/errors.hpp"
#include "libmpm/io/snapshot.hpp"
#include "libmpm/measure/energy.hpp"
#include "libmpm/measure/health.hpp"
#include "libmpm/scene/build.hpp"
#include "libmpm/scene/dispatch.hpp"
#include "libmpm/scene/run.hpp"
#include "libmpm/simulation.hpp"

namespace mpm {
namespace {

/// Times at which something is due: samples of the area and snapshots, in order, each once.
class Schedule {
 public:
  explicit Schedule(const Scene& s) : scene_(s) {}

  double next() const {
    const double next = std::min(next_sample(), next_snapshot());
    return next < scene_.end_time - slack() ? next : scene_.end_time;
  }
  /// True if due at time t; moves on.
  bool sample_due(double t) { return t >= next_sample() - slack() && (++samples_, true); }
  bool snapshot_due(double t) { return t >= next_snapshot() - slack() && (++snapshots_, true); }
  void carry(Archive& a) { a.integer("samples", samples_), a.integer("snapshots", snapshots_); }

 private:
  /// Events that rounding sets apart (0.7 ns, and 7 times 0.1 ns) are one.
  double slack() const { return 1e-9 * scene_.measures.area_every; }
  double next_sample() const { return samples_ * scene_.measures.area_every; }
  double next_snapshot() const {
    const auto& times = scene_.measures.snapshots;
    return snapshots_ < times.size() ? times[snapshots_] : 2 * scene_.end_time;
  }
  const Scene& scene_;
  std::size_t samples_ = 0, snapshots_ = 0;
};

void check(const Scene& scene) {
  const auto problems = find_problems(scene);
  if (problems.empty()) return;
  std::string text;
  for (const Problem& p : problems)
    text += (text.empty() ? "" : "\n") + p.parameter + " = " + p.value + ": must be " + p.allowed;
  throw InputError(text);
}

}  // namespace

RunResult run(const Scene& scene, Observer& observer) {
  check(scene);
  State state = build_state(scene);
  const auto measurements = measurements_for(scene, state, observer);
  return run_state(scene, state, measurements, observer);
}

RunResult run_state(const Scene& scene, State& state, const Measurements& measurements, Observer& observer) {
  const MaterialModel material = build_material(scene);
  const auto stepper = stepper_for(scene);
  const Temperature temperature{material.eos, scene.material.specific_heat,
                                scene.material.initial_temperature};
  Balance balance(state);
  Health health(scene, state);
  Schedule schedule(scene);

  RunResult result;
  result.particles = static_cast<std::int64_t>(state.particles.size());
  const auto observe = [&] {
    const bool sample = schedule.sample_due(state.time) || state.time >= scene.end_time;
    const bool snapshot = schedule.snapshot_due(state.time);
    if (sample || snapshot) stepper->refresh_particles(state);
    if (sample) {
      balance.sample(state);
      for (const auto& m : measurements) m->sample(state);
    }
    if (snapshot) observer.on_snapshot(snapshot_of(state, temperature));
  };

  const double cell = state.grid.cell().minCoeff();
  // Before the first step nothing is stressed: the fastest signal is that of the impact, with its viscosity.
  const double sound = std::sqrt(material.eos.sound_speed_squared(MieGrueneisen::Volume(0), 0) +
                                 4 * material.strength.shear_modulus / (3 * material.eos.rho0));
  double signal = 3 * (sound + initial_speed(scene));
  const auto decided = [&] {
    return std::any_of(measurements.begin(), measurements.end(), [](const auto& m) { return m->decided(); });
  };
  const auto carry = [&](Archive a) {
    const auto part = [&](const std::string& name, auto& what) {
      Archive inside = a.part(name);
      what.carry(inside);
    };
    Archive steps = a.part("stepper");
    stepper->carry(state, steps);
    a.number("time", state.time), a.integer("step", state.step), a.number("signal", signal);
    part("balance", balance), part("health", health), part("schedule", schedule);
    for (std::size_t i = 0; i < measurements.size(); ++i)
      part("measurement-" + std::to_string(i), *measurements[i]);
  };
  if (Record* record = observer.resume_from())
    carry(Archive::from(*record)), result.steps = state.step;
  else
    observe();
  while (state.time < scene.end_time && !decided()) {
    // Equal steps up to the next event, so that it is hit exactly and no step is tiny.
    const double limit = scene.numerics.cfl * cell / signal;
    const double due = schedule.next();
    const double steps = std::ceil((due - state.time) / limit);
    const double dt = (due - state.time) / std::max(steps, 1.0);
    stepper->use_threads(observer.threads());
    const StepReport report = stepper->step(state, dt);
    if (steps <= 1) state.time = due;
    signal = report.largest_signal;
    balance.after_step(state, report, dt);
    health.after_step(state, report, dt);
    for (const auto& m : measurements) {
      stepper->refresh_particles(state, m->watched());
      const RowRange rows = m->rows_read(state.grid);
      stepper->refresh_nodes(state, rows.first, rows.last);
      m->after_step(state, report, dt);
    }
    result.steps = state.step;
    result.helper_seconds = stepper->helper_seconds();

    if (const auto trouble = health.trouble(balance.energy_error()); trouble != Health::Trouble::none) {
      stepper->refresh_particles(state);
      result.status = RunStatus::failed;
      result.reason = health.describe(trouble, state, balance.energy_error());
      result.energy_error = balance.energy_error();
      health.finish(state, result);
      observer.on_snapshot(snapshot_of(state, temperature));  // to look at what went wrong
      return result;
    }
    observe();
    if (observer.wants_checkpoint()) {
      Record record;
      carry(Archive::to(record));
      observer.on_checkpoint(record);
    }
    if (!observer.on_step({state.step, state.time, scene.end_time, dt, result.particles})) {
      result.status = RunStatus::stopped;
      result.reason = "stopped by the observer";
      return result;
    }
  }
  stepper->refresh_particles(state);
  if (state.time < scene.end_time)
    for (const auto& m : measurements) m->sample(state);
  for (const auto& m : measurements) m->finish(state, result);
  balance.finish(state, result);
  health.finish(state, result);
  return result;
}

RunResult run(const Scene& scene) {
  Observer nobody;
  return run(scene, nobody);
}

}  // namespace mpm
