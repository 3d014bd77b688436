#include "libmpm/measure/gauges.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>
#include <set>

#include "libmpm/body/fill.hpp"
#include "libmpm/body/region.hpp"
#include "libmpm/io/fields.hpp"
#include "libmpm/measure/energy.hpp"
#include "libmpm/scene/build.hpp"
#include "libmpm/scene/kinds/kind.hpp"
#include "libmpm/scene/region_of.hpp"

namespace mpm {
namespace {

constexpr std::string_view all_bodies = "all";

constexpr double nothing = std::numeric_limits<double>::quiet_NaN();
constexpr double not_yet = std::numeric_limits<double>::infinity();

template <int axes>
Vec<axes> vector_of(const std::vector<double>& place) {
  Vec<axes> x;
  for (int k = 0; k < axes; ++k) x[k] = place[static_cast<std::size_t>(k)];
  return x;
}

/// The axis that a name of a component ends in: "center_y" -> 1.
int axis_of(const std::string& name) { return name.back() - 'x'; }

/// A number of a particle.
template <int axes>
std::function<double(const BasicState<axes>&, std::size_t)> number_of_particle(const std::string& name,
                                                                               const Scene& scene) {
  using State = BasicState<axes>;
  if (name == "speed") return [](const State& s, std::size_t p) { return s.particles.velocity[p].norm(); };
  if (name.starts_with("position_"))
    return [k = axis_of(name)](const State& s, std::size_t p) { return s.particles.position[p][k]; };
  return [of = find_field(name)->of, temperatures = temperatures_of(scene)](const State& s, std::size_t p) {
    return of(s, p, temperatures[s.particles.material_of(p)]);
  };
}

/// (1 - |dx| / h) (1 - |dy| / h) ..., 0 from a distance of h on along any axis. Most particles are far away
/// along the first one.
template <int axes>
double nearness(const Vec<axes>& x, const Vec<axes>& place, const Vec<axes>& h) {
  double product = 1;
  for (int k = 0; k < axes; ++k) {
    const double distance = std::abs(x[k] - place[k]);
    if (!(distance < h[k])) return 0;
    product *= 1 - distance / h[k];
  }
  return product;
}

struct Shares {
  std::vector<std::size_t> particles;
  std::vector<double> of;  ///< they add up to 1
};

/// The particles of the body that one of them is of.
template <int axes>
typename BasicParticles<axes>::Range body_around(const BasicParticles<axes>& ps, std::size_t particle) {
  std::size_t first = 0;
  for (const std::size_t end : ps.body_ends) {
    if (particle < end) return {first, end};
    first = end;
  }
  return {first, ps.size()};
}

/// Of the particles around a place.
template <int axes>
Shares shares_around(const Vec<axes>& place, const Vec<axes>& spacing, const BasicState<axes>& s) {
  const auto& x = s.particles.position;
  const auto distance = [&](const Vec<axes>& at) { return (at - place).squaredNorm(); };
  const auto nearest = static_cast<std::size_t>(std::ranges::min_element(x, {}, distance) - x.begin());
  const auto body = body_around(s.particles, nearest);
  Shares shares;
  double sum = 0;
  for (std::size_t p = body.first; p < body.last; ++p) {
    const double weight = nearness<axes>(x[p], place, spacing);
    if (weight > 0) shares.particles.push_back(p), shares.of.push_back(weight), sum += weight;
  }
  if (!(sum > 1e-6)) return {{nearest}, {1.0}};
  for (double& share : shares.of) share /= sum;
  return shares;
}

template <int axes, class Number>
double at_place(const BasicState<axes>& s, const Vec<axes>& place, const Number& number) {
  double sum = 0, weights = 0;
  const Vec<axes> cell = s.grid.cell();
  for (std::size_t p = 0; p < s.particles.size(); ++p) {
    const double near = nearness<axes>(s.particles.position[p], place, cell);
    if (!(near > 0)) continue;
    const double weight = s.particles.mass[p] * near;
    sum += weight * number(s, p), weights += weight;
  }
  return weights > 0 ? sum / weights : nothing;
}

/// Where the beam from `from` meets the first particle: how far along it. Infinite: nowhere.
template <int axes>
class Beam {
 public:
  Beam(const Vec<axes>& from, BeamDirection direction, const Vec<axes>& cell)
      : from_(from), direction_(direction), cell_(cell) {}

  template <class Number>
  double read(const BasicState<axes>& s, const Number& number) const {
    struct Met {
      std::size_t particle;
      double distance;
    };
    std::vector<Met> met;
    double first = std::numeric_limits<double>::infinity();
    for (std::size_t p = 0; p < s.particles.size(); ++p) {
      const double along = distance(s.particles.position[p]);
      if (!std::isfinite(along)) continue;
      met.push_back({p, along});
      first = std::min(first, along);
    }
    double sum = 0, mass = 0;
    for (const auto& [p, along] : met)
      if (along <= first + 0.5 * cell_[direction_.axis])
        sum += s.particles.mass[p] * number(s, p), mass += s.particles.mass[p];
    return mass > 0 ? sum / mass : nothing;
  }

 private:
  /// Along the beam; infinite for what is beside it or behind its source.
  double distance(const Vec<axes>& x) const {
    for (int k = 0; k < axes; ++k)
      if (k != direction_.axis && !(std::abs(x[k] - from_[k]) < cell_[k]))
        return std::numeric_limits<double>::infinity();
    const double along = direction_.sign * (x[direction_.axis] - from_[direction_.axis]);
    return along >= 0 ? along : std::numeric_limits<double>::infinity();
  }
  Vec<axes> from_;
  BeamDirection direction_;
  Vec<axes> cell_;
};

/// The sums that numbers of a body are made of.
template <int axes>
struct Sums {
  Sums(const BasicState<axes>& s, const typename BasicParticles<axes>::Range& range) {
    const auto& ps = s.particles;
    for (std::size_t p = range.first; p < range.last; ++p) {
      mass += ps.mass[p];
      center += ps.mass[p] * ps.position[p];
      momentum += ps.mass[p] * ps.velocity[p];
    }
    center /= mass;
  }
  double mass = 0;
  Vec<axes> center = Vec<axes>::Zero(), momentum = Vec<axes>::Zero();
};

template <int axes>
double spin(const BasicState<axes>& s, const typename BasicParticles<axes>::Range& range) {
  const Sums<axes> sums(s, range);
  const Vec<axes> drift = sums.momentum / sums.mass;
  double angular = 0, inertia = 0;
  for (std::size_t p = range.first; p < range.last; ++p) {
    const Vec<axes> r = s.particles.position[p] - sums.center, v = s.particles.velocity[p] - drift;
    angular += s.particles.mass[p] * (r.x() * v.y() - r.y() * v.x());
    inertia += s.particles.mass[p] * (r.x() * r.x() + r.y() * r.y());
  }
  return angular / inertia;
}

/// Least (sign -1) or largest (+1) coordinate of the particles' edges.
template <int axes>
double edge(const BasicState<axes>& s, const typename BasicParticles<axes>::Range& range, int axis,
            int sign) {
  double outermost = -std::numeric_limits<double>::infinity();
  for (std::size_t p = range.first; p < range.last; ++p)
    outermost = std::max(outermost, sign * s.particles.position[p][axis] + s.particles.half_size[p][axis]);
  return sign * outermost;
}

template <int axes>
std::function<double(const BasicState<axes>&)> number_of_body(
    const std::string& of, const typename BasicParticles<axes>::Range& range) {
  using State = BasicState<axes>;
  using Range = typename BasicParticles<axes>::Range;
  const auto with = [&](auto number) -> std::function<double(const State&)> {
    return [number, range](const State& s) { return number(s, range); };
  };
  if (of == "mass") return with([](const State& s, const Range& r) { return Sums<axes>(s, r).mass; });
  if (of == "spin") return with([](const State& s, const Range& r) { return spin<axes>(s, r); });
  if (of == "kinetic_energy")
    return with([](const State& s, const Range& r) { return energy_of(s.particles, r).kinetic; });
  if (of == "internal_energy")
    return with([](const State& s, const Range& r) { return energy_of(s.particles, r).internal; });
  const int k = axis_of(of);
  if (of.starts_with("center_"))
    return with([k](const State& s, const Range& r) { return Sums<axes>(s, r).center[k]; });
  if (of.starts_with("momentum_"))
    return with([k](const State& s, const Range& r) { return Sums<axes>(s, r).momentum[k]; });
  if (of.starts_with("velocity_"))
    return with([k](const State& s, const Range& r) {
      const Sums<axes> sums(s, r);
      return sums.momentum[k] / sums.mass;
    });
  if (of.starts_with("lowest_"))
    return with([k](const State& s, const Range& r) { return edge<axes>(s, r, k, -1); });
  if (of.starts_with("highest_"))
    return with([k](const State& s, const Range& r) { return edge<axes>(s, r, k, 1); });
  return with(
      [k](const State& s, const Range& r) { return edge<axes>(s, r, k, 1) - edge<axes>(s, r, k, -1); });
}

}  // namespace

template <int axes>
typename BasicParticles<axes>::Range body_range(const Scene& scene, const BasicState<axes>& s,
                                                const std::string& name) {
  const auto& bodies = scene.composition.bodies;
  const auto& ends = s.particles.body_ends;
  const auto at =
      static_cast<std::size_t>(std::ranges::find(bodies, name, &ComposedBody::name) - bodies.begin());
  if (name == all_bodies || at >= ends.size()) return {0, s.particles.size()};
  return {at == 0 ? 0 : ends[at - 1], ends[at]};
}

template <int axes>
BasicGauges<axes>::BasicGauges(const Scene& scene, const State& state) : gauges_(scene.measures.gauges) {
  for (const Gauge& gauge : gauges_) {
    reads_.push_back(reading_of(gauge, scene, state));
    const GaugeQuantity& quantity = *find_gauge_quantity(gauge.target, gauge.of);
    histories_.push_back({gauge.name, std::string(quantity.unit_in(scene.space)), {}, {}});
    stop_times_.push_back(not_yet);
  }
}

template <int axes>
typename BasicGauges<axes>::Read BasicGauges<axes>::reading_of(const Gauge& gauge, const Scene& scene,
                                                               const State& state) {
  switch (gauge.target) {
    case GaugeTarget::point: {
      const Vec<axes> spacing = state.grid.cell() / particles_per_edge(scene.numerics, axes);
      return [number = number_of_particle<axes>(gauge.of, scene),
              shares = shares_around<axes>(vector_of<axes>(gauge.place), spacing, state)](const State& s) {
        double sum = 0;
        for (std::size_t k = 0; k < shares.of.size(); ++k)
          sum += shares.of[k] * number(s, shares.particles[k]);
        return sum;
      };
    }
    case GaugeTarget::place:
      return [number = number_of_particle<axes>(gauge.of, scene), place = vector_of<axes>(gauge.place)](
                 const State& s) { return at_place<axes>(s, place, number); };
    case GaugeTarget::beam:
      return [number = number_of_particle<axes>(gauge.of, scene),
              beam = Beam<axes>(vector_of<axes>(gauge.place), beam_direction(gauge.direction),
                                state.grid.cell())](const State& s) { return beam.read(s, number); };
    case GaugeTarget::body:
      return number_of_body<axes>(gauge.of, body_range(scene, state, gauge.body));
    case GaugeTarget::wall:
      return {};
  }
  return {};
}

template <int axes>
double BasicGauges<axes>::mean_force(double time) const {
  return time > last_sample_ ? impulse_ / (time - last_sample_) : nothing;
}

template <int axes>
void BasicGauges<axes>::after_step(const State&, const StepReport& report, double) {
  impulse_ += report.wall_impulse.y();
}

template <int axes>
bool BasicGauges<axes>::decided() const {
  return std::ranges::any_of(stop_times_, [](double time) { return std::isfinite(time); });
}

template <int axes>
void BasicGauges<axes>::sample(const State& s, Observer&) {
  for (std::size_t g = 0; g < gauges_.size(); ++g) {
    History& history = histories_[g];
    // a run that is decided at a sample is sampled again at its end
    if (!history.times.empty() && history.times.back() == s.time) continue;
    const double value = reads_[g] ? reads_[g](s) : mean_force(s.time);
    if (!std::isfinite(value)) continue;
    history.times.push_back(s.time), history.values.push_back(value);
    for (const Threshold& stop : gauges_[g].stops)
      if (!std::isfinite(stop_times_[g])) stop_times_[g] = time_beyond(history, stop);
  }
  impulse_ = 0;
  last_sample_ = s.time;
}

double time_beyond(const History& h, const Threshold& stop) {
  const auto beyond = [&](double value) { return stop.below ? value < stop.value : value > stop.value; };
  const double time = h.times.back(), value = h.values.back();
  if (time < stop.after || !beyond(value)) return not_yet;
  if (h.times.size() < 2 || beyond(h.values[h.values.size() - 2])) return time;
  const double time_before = h.times[h.times.size() - 2], before = h.values[h.values.size() - 2];
  const double part = (stop.value - before) / (value - before);
  return std::max(stop.after, time_before + part * (time - time_before));
}

std::optional<double> reduced(const History& h, const Reduction& reduction) {
  const auto& [name, window, from, to] = reduction;
  const std::size_t n = h.times.size();
  // events that rounding sets apart are one
  const double slack = 1e-9 * (std::abs(to) + std::numeric_limits<double>::min());
  if (n == 0 || from < h.times.front() - slack || to > h.times.back() + slack) return std::nullopt;
  const auto value_at = [&](double t) {
    const auto after = static_cast<std::size_t>(std::ranges::upper_bound(h.times, t) - h.times.begin());
    if (after == 0) return h.values.front();
    if (after == n) return h.values.back();
    const double part = (t - h.times[after - 1]) / (h.times[after] - h.times[after - 1]);
    return h.values[after - 1] + part * (h.values[after] - h.values[after - 1]);
  };
  if (window == Window::mean && from == to) return value_at(from);
  std::vector<double> times = {from}, values = {value_at(from)};
  for (std::size_t k = 0; k < n; ++k)
    if (h.times[k] > from && h.times[k] < to) times.push_back(h.times[k]), values.push_back(h.values[k]);
  times.push_back(to), values.push_back(value_at(to));
  if (window == Window::largest) return std::ranges::max(values);
  if (window == Window::smallest) return std::ranges::min(values);
  double integral = 0;
  for (std::size_t k = 1; k < times.size(); ++k)
    integral += 0.5 * (values[k] + values[k - 1]) * (times[k] - times[k - 1]);
  return integral / (to - from);
}

template <int axes>
void BasicGauges<axes>::finish(const State&, RunResult& result) const {
  for (std::size_t g = 0; g < gauges_.size(); ++g) {
    const History& h = histories_[g];
    result.histories.push_back(h);
    if (h.values.empty()) continue;
    const auto add = [&](std::string_view name, double value) {
      result.metrics.push_back({h.name + "." + std::string(name), value, h.unit, {}});
    };
    add("max", std::ranges::max(h.values));
    add("min", std::ranges::min(h.values));
    add("end", h.values.back());
    for (const Reduction& reduction : gauges_[g].reductions)
      if (const auto value = reduced(h, reduction)) add(reduction.name, *value);
    if (std::isfinite(stop_times_[g]))
      result.metrics.push_back({h.name + "." + std::string(stop_metric), stop_times_[g], "s", {}});
  }
}

template <int axes>
void BasicGauges<axes>::carry(Archive& a) {
  a.number("impulse", impulse_), a.number("last_sample", last_sample_);
  a.numbers("stop_times", stop_times_);
  for (std::size_t g = 0; g < histories_.size(); ++g) {
    Archive one = a.part(std::to_string(g));
    one.numbers("times", histories_[g].times), one.numbers("values", histories_[g].values);
  }
}

namespace {

template <int axes>
std::string text_of_place(const std::vector<double>& place) {
  std::string text;
  for (const double x : place) text += (text.empty() ? "(" : ", ") + text_of(x);
  return text + ") m";
}

/// One gauge, whose mistakes are told under its name.
template <int axes>
class GaugeCheck {
 public:
  GaugeCheck(const Gauge& gauge, const Scene& scene, Report& report)
      : gauge_(gauge), scene_(scene), report_(report) {}

  void name(bool is_first) {
    if (!is_gauge_name(gauge_.name))
      add("name", gauge_.name, "up to 60 letters, digits, '-' and '_'");
    else if (!is_first)
      add("name", gauge_.name, "of one gauge only");
  }
  void quantity() {
    const GaugeQuantity* known = find_gauge_quantity(gauge_.target, gauge_.of);
    if (known && known->is_in(scene_.space)) return;
    std::string allowed;
    for (const GaugeQuantity& one : gauge_quantities(gauge_.target))
      if (one.is_in(scene_.space)) allowed += (allowed.empty() ? "" : ", ") + std::string(one.name);
    add("of", gauge_.of, allowed);
  }
  void place(const Vec<axes>& low, const Vec<axes>& high,
             const std::function<bool(const Vec<axes>&)>& inside) {
    const std::string key(to_string(gauge_.target)), value = text_of_place<axes>(gauge_.place);
    if (gauge_.place.size() != axes)
      return add(key, value, axes == 2 ? "two coordinates, x and y" : "three coordinates, x, y and z");
    const Vec<axes> x = vector_of<axes>(gauge_.place);
    if (!x.allFinite()) return add(key, value, "made of finite numbers");
    if (gauge_.target == GaugeTarget::point) {
      if (!inside(x)) add(key, value, "inside a body at time 0");
      return;
    }
    static constexpr const char* sides[3][2] = {
        {"the left side", "the right side"}, {"the floor", ""}, {"the front", "the back"}};
    for (int k = 0; k < axes; ++k)
      if (!(x[k] >= low[k] && x[k] <= high[k]))
        return add(
            key, value,
            "in what is modelled: " + std::string(1, static_cast<char>('x' + k)) + " from " + sides[k][0] +
                " (" + text_of(low[k]) + " m)" +
                (k == 1 ? " on" : std::string(" to ") + sides[k][1] + " (" + text_of(high[k]) + " m)"));
  }
  void direction() {
    if (const int axis = beam_direction(gauge_.direction).axis; axis >= 0 && axis < axes) return;
    std::string allowed;
    for (const std::string_view word : beam_directions(axes))
      allowed += (allowed.empty() ? "" : ", ") + std::string(word);
    add("direction", gauge_.direction, allowed);
  }
  void body() {
    if (gauge_.body == all_bodies) return;
    std::string allowed(all_bodies);
    for (const ComposedBody& one : scene_.composition.bodies) {
      if (one.name == gauge_.body) return;
      allowed += ", " + one.name;
    }
    add("body", gauge_.body, allowed);
  }
  /// The impulse of a step is of the floor, and of a mirror above.
  void wall(Floor floor, bool has_ceiling) {
    if (gauge_.wall != "bottom")
      add("wall", gauge_.wall, "bottom");
    else if (floor == Floor::open)
      add("wall", gauge_.wall, "a wall that is there: the bottom is open");
    else if (has_ceiling)
      add("wall", gauge_.wall, "of a scene that is open above: its force is not told from that of the top");
  }
  void reductions() {
    std::set<std::string_view> names;
    for (const Reduction& one : gauge_.reductions) {
      const std::string key = "reduce." + one.name;
      const std::string times = text_of(one.from) + " s to " + text_of(one.to) + " s";
      if (!is_gauge_name(one.name))
        add(key, one.name, "up to 60 letters, digits, '-' and '_'");
      else if (is_kept_name(one.name) || !names.insert(one.name).second)
        add(key, one.name, "a name of its own, and not max, min, end or stop");
      if (!(one.from >= 0 && one.from <= one.to))
        add(key, times, "from 0 s on, the first time not after the second");
      else if (!(one.to <= scene_.end_time))
        add(key, times, "up to end_time (" + text_of(scene_.end_time) + " s)");
    }
  }

  void stops() {
    for (const Threshold& one : gauge_.stops) {
      if (!std::isfinite(one.value)) add("stop", text_of(one.value), "a finite number");
      if (!(one.after >= 0 && one.after < scene_.end_time))
        add("after", text_of(one.after) + " s",
            "from 0 s on and before end_time (" + text_of(scene_.end_time) + " s)");
    }
  }

 private:
  void add(const std::string& key, std::string value, std::string allowed) {
    report_.add_other("gauge." + gauge_.name + "." + key, std::move(value), std::move(allowed));
  }
  const Gauge& gauge_;
  const Scene& scene_;
  Report& report_;
};

struct Walls {
  Floor floor;
  bool has_ceiling;
};

template <int axes>
void check_all(const Scene& scene, const Walls& walls, const Vec<axes>& low, const Vec<axes>& high,
               const std::function<bool(const Vec<axes>&)>& inside, Report& report) {
  std::set<std::string_view> names;
  for (const Gauge& gauge : scene.measures.gauges) {
    GaugeCheck<axes> check(gauge, scene, report);
    check.name(names.insert(gauge.name).second);
    check.quantity();
    check.reductions();
    check.stops();
    switch (gauge.target) {
      case GaugeTarget::body:
        check.body();
        break;
      case GaugeTarget::wall:
        check.wall(walls.floor, walls.has_ceiling);
        break;
      case GaugeTarget::beam:
        check.direction();
        [[fallthrough]];
      case GaugeTarget::point:
      case GaugeTarget::place:
        check.place(low, high, inside);
    }
  }
}

LineAt<2> line_through(const Vec2& x) { return x.x(); }
LineAt<3> line_through(const Vec3& x) { return {x.x(), x.z()}; }

template <int axes>
bool contains(const BasicRegion<axes>& region, const Vec<axes>& x, double slack) {
  std::vector<Interval> filled;
  region.cut(line_through(x), filled);
  return std::ranges::any_of(filled, [&](const Interval& interval) {
    return x.y() >= interval.low - slack && x.y() <= interval.high + slack;
  });
}

template <int axes>
void check_of_kind(const Scene& scene, Report& report) {
  const KindIn<axes>& kind = kind_of(scene).in<axes>();
  const BasicLattice<axes> l = kind.lattice(scene);
  Vec<axes> high = l.origin;
  high.x() += l.columns * l.cell.x();
  high.y() = std::numeric_limits<double>::infinity();
  if constexpr (axes == 3) high.z() += l.slices * l.cell.z();
  const double bottom = l.origin.y() + l.empty_rows * l.cell.y(), top = l.origin.y() + l.rows * l.cell.y();
  // a place on a side is inside, however it was rounded
  const double slack = 1e-6 * l.cell.minCoeff();
  std::vector<BasicBody<axes>> bodies;
  if (kind.body) bodies.push_back(kind.body(scene, l));
  const Composition& all = scene.composition;
  const Vec<axes> margin = Vec<axes>::Constant(slack);
  const BasicRegion<axes> box =
      block<axes>(vector(all.low).head<axes>() - margin, vector(all.high).head<axes>() + margin);
  for (const ComposedBody& one : all.bodies) bodies.push_back({region_of<axes>(one.shape) & box, {}});
  const auto inside = [&](const Vec<axes>& x) {
    for (int k = 0; k < axes; ++k)
      if (k != 1 && !(x[k] >= l.origin[k] - slack && x[k] <= high[k] + slack)) return false;
    if (!(x.y() >= bottom - slack && x.y() <= top + slack)) return false;
    return std::ranges::any_of(bodies, [&](const BasicBody<axes>& body) {
      return contains<axes>(body.region, x - body.place, slack);
    });
  };
  const Walls walls{kind_of(scene).floor(scene), all.face(Side::top) == Face::mirror};
  check_all<axes>(scene, walls, l.origin, high, inside, report);
}

}  // namespace

void check_gauges(const Scene& scene, Report& report) {
  if (scene.measures.gauges.empty()) return;
  axes_of(scene.space) == 2 ? check_of_kind<2>(scene, report) : check_of_kind<3>(scene, report);
}

/// A body that was made by hand is where its particles are.
template <int axes>
void check_gauges(const Scene& scene, const BasicState<axes>& body, Report& report) {
  if (scene.measures.gauges.empty()) return;
  const auto& grid = body.grid;
  const Vec<axes> low = grid.origin();
  Vec<axes> high = low;
  high.x() += grid.columns() * grid.cell().x();
  high.y() = std::numeric_limits<double>::infinity();
  if constexpr (axes == 3) high.z() += grid.slices() * grid.cell().z();
  check_all<axes>(
      scene, {body.floor, body.ceiling.has_value()}, low, high,
      [&](const Vec<axes>& x) {
        return std::ranges::any_of(body.particles.position, [&](const Vec<axes>& p) {
          return (p - x).cwiseAbs().cwiseQuotient(grid.cell()).maxCoeff() <= 1;
        });
      },
      report);
}

template class BasicGauges<2>;
template class BasicGauges<3>;
template Particles::Range body_range(const Scene&, const State&, const std::string&);
template BasicParticles<3>::Range body_range(const Scene&, const BasicState<3>&, const std::string&);
template void check_gauges(const Scene&, const State&, Report&);
template void check_gauges(const Scene&, const BasicState<3>&, Report&);

}  // namespace mpm
