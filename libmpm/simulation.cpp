#include "libmpm/simulation.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>
#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

#include "libmpm/core/errors.hpp"
#include "libmpm/io/snapshot.hpp"
#include "libmpm/measure/energy.hpp"
#include "libmpm/measure/gauges.hpp"
#include "libmpm/measure/health.hpp"
#include "libmpm/scene/build.hpp"
#include "libmpm/scene/dispatch.hpp"
#include "libmpm/scene/parameters.hpp"

namespace mpm {
namespace {

/// Times at which something is due: samples of the area and snapshots, in order, each once.
class Schedule {
 public:
  explicit Schedule(const Scene& s)
      : end_(s.end_time), period_(s.measures.area_every), times_(s.measures.snapshots) {}

  double next() const {
    const double next = std::min(next_sample(), next_snapshot());
    return next < end_ - slack() ? next : end_;
  }
  /// True if due at time t; moves on.
  bool sample_due(double t) { return t >= next_sample() - slack() && (++samples_, true); }
  bool snapshot_due(double t) { return t >= next_snapshot() - slack() && (++snapshots_, true); }
  /// Leaves out what was due up to time t.
  void pass(double t) {
    while (sample_due(t)) {
    }
    while (snapshot_due(t)) {
    }
  }
  void carry(Archive& a) { a.integer("samples", samples_), a.integer("snapshots", snapshots_); }

 private:
  /// Events that rounding sets apart (0.7 ns, and 7 times 0.1 ns) are one.
  double slack() const { return 1e-9 * period_; }
  double next_sample() const { return samples_ * period_; }
  double next_snapshot() const {
    return snapshots_ < times_.size() ? times_[snapshots_] : std::numeric_limits<double>::infinity();
  }
  double end_, period_;
  std::vector<double> times_;
  std::size_t samples_ = 0, snapshots_ = 0;
};

void refuse(const std::vector<Problem>& problems) {
  if (problems.empty()) return;
  std::string text;
  for (const Problem& p : problems)
    text += (text.empty() ? "" : "\n") + p.parameter + " = " + p.value + ": must be " + p.allowed;
  throw InputError(text);
}

/// That the scene is of so many axes.
void check_axes(const Scene& scene, int axes) {
  if (axes_of(scene.space) == axes) return;
  const Choice& space = *find_choice("space");
  throw InputError("space = " + std::string(space.allowed[space.get(scene)]) + ": must be " +
                   (axes == 2 ? "plane-strain or axisymmetric for a Simulation; three-d is for a Simulation3"
                              : "three-d for a Simulation3"));
}

template <int axes>
BasicState<axes> checked_state(const Scene& scene) {
  check_axes(scene, axes);
  refuse(find_problems(scene));
  return build_state<axes>(scene);
}

/// With the columns that the scene has and the body may leave out.
template <int axes>
BasicState<axes> checked_body(const Scene& scene, BasicState<axes> body) {
  check_axes(scene, axes);
  const std::size_t n = body.particles.size();
  if (body.velocity_gradient.empty()) body.velocity_gradient.assign(n, Mat<axes>::Zero());
  refuse(find_problems(scene, body));
  for (std::size_t m = 0; m < material_count(scene); ++m)
    body.particles.keep(state_columns(material_of(scene, m)));
  return body;
}

template <int axes>
double fastest(const BasicParticles<axes>& ps) {
  double square = 0;
  for (const Vec<axes>& v : ps.velocity) square = std::max(square, v.squaredNorm());
  return std::sqrt(square);
}

}  // namespace

template <int axes>
struct BasicSimulation<axes>::Parts {
  using Health = BasicHealth<axes>;
  using Trouble = typename Health::Trouble;

  Parts(const Scene& s, State body, double speed)
      : scene(s),
        state(std::move(body)),
        stepper(stepper_for<axes>(s)),
        temperatures(temperatures_of(s)),
        balance(state),
        health(s, state, speed),
        schedule(s) {
    // Before the first step nothing is stressed: the fastest signal is that of the impact, with its
    // viscosity.
    signal = 3 * (largest_of(s, sound_speed_at_rest) + speed);
  }

  bool decided() const {
    return std::ranges::any_of(measurements, [](const auto& m) { return m->decided(); });
  }
  bool over() const { return stopped || failed() || state.time >= scene.end_time || decided(); }
  bool failed() const { return trouble != Trouble::none; }
  double time_step() const { return scene.numerics.cfl * state.grid.cell().minCoeff() / signal; }

  void begin(Observer&);
  void carry(Archive);
  void sample(Observer&);
  void observe(Observer&);
  StepReport advance(double dt, std::optional<double> due);
  void step(Observer&);
  RunResult result();

  Scene scene;
  State state;
  std::unique_ptr<Stepper> stepper;
  std::vector<Temperature> temperatures;
  std::vector<std::unique_ptr<Measurement>> measurements;
  BasicBalance<axes> balance;
  Health health;
  Schedule schedule;
  double signal;  ///< the fastest [m/s]
  Trouble trouble = Trouble::none;
  std::string reason;
  bool begun = false, stopped = false;
};

template <int axes>
void BasicSimulation<axes>::Parts::begin(Observer& observer) {
  if (std::exchange(begun, true)) return;
  if (Record* record = observer.resume_from())
    carry(Archive::from(*record));
  else
    observe(observer);
}

template <int axes>
void BasicSimulation<axes>::Parts::carry(Archive a) {
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
}

template <int axes>
void BasicSimulation<axes>::Parts::sample(Observer& observer) {
  balance.sample(state, observer);
  for (const auto& m : measurements) m->sample(state, observer);
}

template <int axes>
void BasicSimulation<axes>::Parts::observe(Observer& observer) {
  const bool sample_now = schedule.sample_due(state.time) || state.time >= scene.end_time;
  const bool snapshot = schedule.snapshot_due(state.time);
  if (sample_now || snapshot) stepper->refresh_particles(state);
  if (sample_now) sample(observer);
  if (snapshot) observer.on_snapshot(snapshot_of(state, temperatures));
}

/// One step, and the measurements that look at every step. Where it ends at `due`, it does to the last bit.
template <int axes>
BasicStepReport<axes> BasicSimulation<axes>::Parts::advance(double dt, std::optional<double> due) {
  const StepReport report = stepper->step(state, dt);
  if (due) state.time = *due;
  signal = report.largest_signal;
  balance.after_step(state, report, dt);
  health.after_step(state, report, dt);
  for (const auto& m : measurements) {
    stepper->refresh_particles(state, m->watched());
    const RowRange rows = m->rows_read(state.grid);
    stepper->refresh_nodes(state, rows.first, rows.last);
    m->after_step(state, report, dt);
  }
  return report;
}

template <int axes>
void BasicSimulation<axes>::Parts::step(Observer& observer) {
  // Equal steps up to the next event, so that it is hit exactly and no step is tiny.
  const double due = schedule.next();
  const double steps = std::max(std::ceil((due - state.time) / time_step()), 1.0);
  const double dt = (due - state.time) / steps;
  stepper->use_threads(observer.threads());
  advance(dt, steps == 1 ? std::optional(due) : std::nullopt);
  trouble = health.trouble(balance.energy_error());
  if (failed()) {
    stepper->refresh_particles(state);
    reason = health.describe(trouble, state, balance.energy_error());
    observer.on_snapshot(snapshot_of(state, temperatures));  // to look at what went wrong
    return;
  }
  observe(observer);
  if (observer.wants_checkpoint()) {
    Record record;
    carry(Archive::to(record));
    observer.on_checkpoint(record);
  }
  stopped = !observer.on_step(
      {state.step, state.time, scene.end_time, dt, static_cast<std::int64_t>(state.particles.size())});
  if (stopped) reason = "stopped by the observer";
  if (!over()) return;
  stepper->refresh_particles(state);
  if (state.time < scene.end_time)
    for (const auto& m : measurements) m->sample(state, observer);
}

template <int axes>
RunResult BasicSimulation<axes>::Parts::result() {
  RunResult r;
  r.particles = static_cast<std::int64_t>(state.particles.size());
  r.steps = state.step;
  r.helper_seconds = stepper->helper_seconds();
  r.reason = reason;
  if (failed()) {
    r.status = RunStatus::failed;
    r.energy_error = balance.energy_error();
    health.finish(state, r);
    return r;
  }
  r.status = over() && !stopped ? RunStatus::done : RunStatus::stopped;
  if (r.status == RunStatus::stopped && !stopped) r.reason = "its end is not reached";
  stepper->refresh_particles(state);
  for (const auto& m : measurements) m->finish(state, r);
  balance.finish(state, r);
  health.finish(state, r);
  return r;
}

template <int axes>
BasicSimulation<axes>::BasicSimulation(const Scene& scene)
    : parts_(std::make_unique<Parts>(scene, checked_state<axes>(scene), initial_speed(scene))) {
  parts_->measurements = measurements_for(scene, parts_->state);
}

template <int axes>
BasicSimulation<axes>::BasicSimulation(const Scene& scene, State body) {
  State state = checked_body(scene, std::move(body));
  const double speed = fastest(state.particles);
  parts_ = std::make_unique<Parts>(scene, std::move(state), speed);
  if (!scene.measures.gauges.empty())
    parts_->measurements.push_back(std::make_unique<BasicGauges<axes>>(scene, parts_->state));
}

template <int axes>
BasicSimulation<axes>::~BasicSimulation() = default;
template <int axes>
BasicSimulation<axes>::BasicSimulation(BasicSimulation&&) noexcept = default;
template <int axes>
BasicSimulation<axes>& BasicSimulation<axes>::operator=(BasicSimulation&&) noexcept = default;

template <int axes>
void BasicSimulation<axes>::use(std::unique_ptr<Stepper> stepper) {
  if (parts_->begun) throw std::logic_error("the stepper of a simulation that has begun cannot be changed");
  parts_->stepper = std::move(stepper);
}

template <int axes>
void BasicSimulation<axes>::add(std::unique_ptr<Measurement> measurement) {
  if (parts_->begun) throw std::logic_error("a simulation that has begun takes no more measurements");
  parts_->measurements.push_back(std::move(measurement));
}

template <int axes>
bool BasicSimulation<axes>::step(Observer& observer) {
  parts_->begin(observer);
  if (parts_->over()) return false;
  parts_->step(observer);
  return !parts_->over();
}

template <int axes>
bool BasicSimulation<axes>::step() {
  Observer silent;
  return step(silent);
}

template <int axes>
BasicStepReport<axes> BasicSimulation<axes>::step(double dt) {
  Observer silent;
  parts_->begin(silent);
  const StepReport report = parts_->advance(dt, std::nullopt);
  parts_->schedule.pass(parts_->state.time);
  return report;
}

template <int axes>
RunResult BasicSimulation<axes>::run(Observer& observer) {
  while (step(observer)) {
  }
  return result();
}

template <int axes>
RunResult BasicSimulation<axes>::run() {
  Observer silent;
  return run(silent);
}

template <int axes>
double BasicSimulation<axes>::time_step() const {
  return parts_->time_step();
}

template <int axes>
const BasicState<axes>& BasicSimulation<axes>::state() {
  State& s = parts_->state;
  parts_->stepper->refresh_particles(s);
  double highest = s.grid.origin().y();
  for (const Vec<axes>& x : s.particles.position) highest = std::max(highest, x.y());
  const double rows = (highest - s.grid.origin().y()) * s.grid.inverse_cell().y();
  parts_->stepper->refresh_nodes(s, -s.grid.ghosts, static_cast<int>(rows) + s.grid.ghosts);
  return s;
}

template <int axes>
double BasicSimulation<axes>::time() const {
  return parts_->state.time;
}
template <int axes>
BasicStepper<axes>& BasicSimulation<axes>::stepper() {
  return *parts_->stepper;
}
template <int axes>
RunResult BasicSimulation<axes>::result() {
  return parts_->result();
}

template class BasicSimulation<2>;
template class BasicSimulation<3>;

RunResult run(const Scene& scene, Observer& observer) {
  return axes_of(scene.space) == 2 ? Simulation(scene).run(observer) : Simulation3(scene).run(observer);
}
RunResult run(const Scene& scene) {
  Observer silent;
  return run(scene, silent);
}

}  // namespace mpm
