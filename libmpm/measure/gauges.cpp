#include "libmpm/measure/gauges.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>

#include "libmpm/body/fill.hpp"
#include "libmpm/contact/contacts.hpp"
#include "libmpm/io/fields.hpp"
#include "libmpm/measure/energy.hpp"
#include "libmpm/scene/build.hpp"

namespace mpm {
namespace {

constexpr double nothing = std::numeric_limits<double>::quiet_NaN();
constexpr double not_yet = std::numeric_limits<double>::infinity();

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

/// Of the particles around a place.
template <int axes>
Shares shares_around(const Vec<axes>& place, const Vec<axes>& spacing, const BasicState<axes>& s) {
  const auto& x = s.particles.position;
  const auto distance = [&](const Vec<axes>& at) { return (at - place).squaredNorm(); };
  const auto nearest = static_cast<std::size_t>(std::ranges::min_element(x, {}, distance) - x.begin());
  const auto body = s.particles.range_of_body(s.particles.body_of(nearest));
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
  const std::size_t at = scene.composition.index_of(name);
  if (name == all_bodies || at >= s.particles.body_ends.size()) return {0, s.particles.size()};
  return s.particles.range_of_body(at);
}

template <int axes>
BasicGauges<axes>::BasicGauges(const Scene& scene, const State& state) : gauges_(scene.measures.gauges) {
  for (const Gauge& gauge : gauges_) {
    reads_.push_back(reading_of(gauge, scene, state));
    const GaugeQuantity& quantity = *find_gauge_quantity(gauge.target, gauge.of);
    histories_.push_back({gauge.name, std::string(quantity.unit_in(scene.space)), {}, {}});
    stop_times_.push_back(not_yet);
  }
  if (std::ranges::find(gauges_, GaugeTarget::contact, &Gauge::target) == gauges_.end()) return;
  const Contacts contacts(scene);
  const auto field = [&](const std::string& body) {
    return contacts.field_of(scene.composition.index_of(body));
  };
  for (std::size_t g = 0; g < gauges_.size(); ++g)
    if (const Gauge& gauge = gauges_[g]; gauge.target == GaugeTarget::contact)
      contacts_.push_back(
          {g, field(gauge.first), field(gauge.second), axis_of(gauge.of), gauge.of.starts_with("force")});
}

template <int axes>
typename BasicGauges<axes>::Read BasicGauges<axes>::reading_of(const Gauge& gauge, const Scene& scene,
                                                               const State& state) {
  switch (gauge.target) {
    case GaugeTarget::point: {
      const Vec<axes> spacing = state.grid.cell() / particles_per_edge(scene.numerics, axes);
      return [number = number_of_particle<axes>(gauge.of, scene),
              shares = shares_around<axes>(gauge_vector<axes>(gauge.place), spacing, state)](const State& s) {
        double sum = 0;
        for (std::size_t k = 0; k < shares.of.size(); ++k)
          sum += shares.of[k] * number(s, shares.particles[k]);
        return sum;
      };
    }
    case GaugeTarget::place:
      return [number = number_of_particle<axes>(gauge.of, scene), place = gauge_vector<axes>(gauge.place)](
                 const State& s) { return at_place<axes>(s, place, number); };
    case GaugeTarget::beam:
      return [number = number_of_particle<axes>(gauge.of, scene),
              beam = Beam<axes>(gauge_vector<axes>(gauge.place), beam_direction(gauge.direction),
                                state.grid.cell())](const State& s) { return beam.read(s, number); };
    case GaugeTarget::body:
      return number_of_body<axes>(gauge.of, body_range(scene, state, gauge.body));
    case GaugeTarget::wall:
    case GaugeTarget::contact:
      return {};
  }
  return {};
}

template <int axes>
double BasicGauges<axes>::mean_force(double impulse, double time) const {
  return time > last_sample_ ? impulse / (time - last_sample_) : nothing;
}

template <int axes>
void BasicGauges<axes>::after_step(const State&, const StepReport& report, double) {
  impulse_ += report.wall_impulse.y();
  for (Contact& contact : contacts_)
    for (const BasicContactImpulse<axes>& pair : report.contacts) {
      if (pair.first == contact.first && pair.second == contact.second)
        contact.given += pair.on_first[contact.axis];
      if (pair.first == contact.second && pair.second == contact.first)
        contact.given -= pair.on_first[contact.axis];
    }
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
    const double value = reading(g, s);
    if (!std::isfinite(value)) continue;
    history.times.push_back(s.time), history.values.push_back(value);
    for (const Threshold& stop : gauges_[g].stops)
      if (!std::isfinite(stop_times_[g])) stop_times_[g] = time_beyond(history, stop);
  }
  impulse_ = 0;
  for (Contact& contact : contacts_)
    if (contact.is_force) contact.given = 0;
  last_sample_ = s.time;
}

template <int axes>
double BasicGauges<axes>::reading(std::size_t gauge, const State& s) const {
  if (reads_[gauge]) return reads_[gauge](s);
  const auto contact = std::ranges::find(contacts_, gauge, &Contact::gauge);
  if (contact == contacts_.end()) return mean_force(impulse_, s.time);
  return contact->is_force ? mean_force(contact->given, s.time) : contact->given;
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
  for (Contact& contact : contacts_) a.number("given_" + std::to_string(contact.gauge), contact.given);
  for (std::size_t g = 0; g < histories_.size(); ++g) {
    Archive one = a.part(std::to_string(g));
    one.numbers("times", histories_[g].times), one.numbers("values", histories_[g].values);
  }
}

template class BasicGauges<2>;
template class BasicGauges<3>;
template Particles::Range body_range(const Scene&, const State&, const std::string&);
template BasicParticles<3>::Range body_range(const Scene&, const BasicState<3>&, const std::string&);

}  // namespace mpm
