#include "libmpm/measure/ejection.hpp"

#include <algorithm>
#include <cmath>
#include <functional>
#include <limits>
#include <numbers>
#include <utility>

#include "libmpm/measure/connected.hpp"

namespace mpm {
namespace {

constexpr ResultRow rows[] = {
    {.name = "ejected_mass_kg_m",
     .unit = "kg/m",
     .meaning = "mass that has been ejected, of the whole width (`decides = \"ejection\"`)",
     .needs = Needs::ejection,
     .spaces = {Space::plane_strain}},
    {.name = "ejected_mass_kg",
     .unit = "kg",
     .meaning = "mass that has been ejected (`decides = \"ejection\"`)",
     .needs = Needs::ejection,
     .spaces = {Space::axisymmetric, Space::three_d}},
    {.name = "ejecta_speed_m_s",
     .unit = "m/s",
     .meaning = "its mean speed against the wall",
     .needs = Needs::ejection,
     .always = false},
    {.name = "decision_time_s",
     .unit = "s",
     .symbol = "t",
     .meaning = "when the outcome was decided",
     .needs = Needs::ejection,
     .always = false},
    {.name = "decision_margin",
     .unit = "1",
     .meaning =
         "speed of what is ejected (of the fastest twentieth of the wall, if arrested) / impact speed - 1",
     .needs = Needs::ejection,
     .always = false},
};

constexpr double least_share = 0.01;    ///< of the wall's mass that counts as ejected
constexpr double watched_share = 0.05;  ///< of the wall's mass whose speed tells of arrest

/// Whether a place across the impact is in a box: between left and right, of three axes front and back too.
template <int axes>
bool across(const Vec<axes>& x, const Vec<axes>& low, const Vec<axes>& high) {
  if (x.x() < low.x() || x.x() > high.x()) return false;
  if constexpr (axes == 3) return x.z() >= low.z() && x.z() <= high.z();
  return true;
}

/// Of the part with this number, the largest height over the extent of another across the impact.
template <int axes>
double highest_over(const BasicParticles<axes>& ps, const ConnectedParts& connected, int number,
                    const Vec<axes>& low, const Vec<axes>& high) {
  double highest = -std::numeric_limits<double>::infinity();
  for (std::size_t p = 0; p < ps.size(); ++p) {
    const Vec<axes>& x = ps.position[p];
    if (connected.part[p] == number && across<axes>(x, low, high)) highest = std::max(highest, x.y());
  }
  return highest;
}

template <int axes>
double distance_from_axis(const Vec<axes>& x) {
  if constexpr (axes == 3) return std::hypot(x.x(), x.z());
  return std::abs(x.x());
}

}  // namespace

template <int axes>
std::span<const ResultRow> BasicEjection<axes>::results() {
  return rows;
}

template <int axes>
BasicEjection<axes>::BasicEjection(const Scene& s, const BasicState<axes>& state)
    : speed_(s.impact_speed),
      radius_(s.cavity_radius),
      link_(state.grid.cell().minCoeff()),
      wall_mass_((state.space == Space::plane_strain ? 2 * s.cavity_radius
                                                     : std::numbers::pi * s.cavity_radius * s.cavity_radius) *
                 (s.block_height - s.cavity_center_height - s.cavity_radius) * s.material.reference_density),
      hold_(s.measures.detached_for),
      arrival_(s.block_height / s.material.bulk_sound_speed + s.cavity_radius / s.impact_speed),
      half_(s.numerics.symmetry == Symmetry::half),
      axisymmetric_(state.space == Space::axisymmetric),
      is_sphere_(state.space != Space::plane_strain),
      stop_early_(s.measures.stop == Stop::decided),
      all_(axisymmetric_ ? 2 * std::numbers::pi
           : half_       ? std::pow(2, axes - 1)
                         : 1),
      apart_since_(state.particles.size(), -1) {}

/// One connected part, as it is modelled.
template <int axes>
struct BasicEjection<axes>::Part {
  double mass = 0, momentum = 0;  ///< along the impact
  double mass_apart = 0;          ///< of particles that have been apart long enough
  double moment = 0;              ///< mass times height
  Vec<axes> low, high;            ///< where it reaches from and to
  bool at_mirror[2] = {};         ///< joined to its image in that of x = 0, of z = 0
};

/// The body and what has come off it.
template <int axes>
struct BasicEjection<axes>::Parts {
  ConnectedParts connected;
  std::vector<Part> parts;
  std::size_t body = 0;  ///< the heaviest

  std::size_t of(std::size_t particle) const { return static_cast<std::size_t>(connected.part[particle]); }
};

/// Of a part with its images: those that a mirror joins to it; a ring is the same all around.
template <int axes>
double BasicEjection<axes>::whole(const Part& part, double modelled) const {
  if (axisymmetric_) return all_ * modelled;
  return (part.at_mirror[0] ? 2 : 1) * (part.at_mirror[1] ? 2 : 1) * modelled;
}

template <int axes>
void BasicEjection<axes>::sample(const BasicState<axes>& s, Observer&) {
  Parts parts = parts_of(s.particles);
  find_ejecta(s, parts);
  if (verdict_ == Verdict::undecided) find_arrest(s, parts);
}

template <int axes>
typename BasicEjection<axes>::Parts BasicEjection<axes>::parts_of(const BasicParticles<axes>& ps) const {
  Parts all{connected_parts<axes>(ps.position, link_), {}, 0};
  all.parts.resize(static_cast<std::size_t>(all.connected.count));
  for (std::size_t p = 0; p < ps.size(); ++p) {
    Part& part = all.parts[all.of(p)];
    const Vec<axes>& x = ps.position[p];
    part.low = part.mass == 0 ? x : Vec<axes>(part.low.cwiseMin(x));
    part.high = part.mass == 0 ? x : Vec<axes>(part.high.cwiseMax(x));
    part.moment += ps.mass[p] * x.y();
    part.mass += ps.mass[p];
    part.momentum += ps.mass[p] * ps.velocity[p].y();
    if (half_ && x.x() < 0.5 * link_) part.at_mirror[0] = true;
    if constexpr (axes == 3)
      if (half_ && x.z() < 0.5 * link_) part.at_mirror[1] = true;
  }
  all.body =
      static_cast<std::size_t>(std::ranges::max_element(all.parts, {}, &Part::mass) - all.parts.begin());
  return all;
}

template <int axes>
void BasicEjection<axes>::find_ejecta(const BasicState<axes>& s, Parts& all) {
  const BasicParticles<axes>& ps = s.particles;
  for (std::size_t p = 0; p < ps.size(); ++p) {
    double& since = apart_since_[p];
    if (all.of(p) == all.body)
      since = -1;
    else if (since < 0)
      since = s.time;
    if (since >= 0 && s.time - since >= hold_) all.parts[all.of(p)].mass_apart += ps.mass[p];
  }
  ejected_mass_ = ejected_momentum_ = 0;
  double fastest = 0;
  for (std::size_t k = 0; k < all.parts.size(); ++k) {
    const Part& part = all.parts[k];
    const double speed = part.momentum / part.mass;
    if (k == all.body || whole(part, part.mass_apart) < least_share * wall_mass_ || speed <= speed_) continue;
    if (part.moment / part.mass <=
        highest_over<axes>(ps, all.connected, static_cast<int>(all.body), part.low, part.high))
      continue;  // inside: debris in a cavity
    ejected_mass_ += all_ * part.mass;
    ejected_momentum_ += all_ * part.momentum;
    fastest = std::max(fastest, speed);
  }
  if (ejected_mass_ > 0) decide(Verdict::ejected, s.time, fastest / speed_ - 1);
}

template <int axes>
void BasicEjection<axes>::find_arrest(const BasicState<axes>& s, const Parts& all) {
  if (s.time < arrival_) return;
  const BasicParticles<axes>& ps = s.particles;
  std::vector<std::pair<double, double>> risers;  // speed, mass
  for (std::size_t p = 0; p < ps.size(); ++p) {
    const Part& part = all.parts[all.of(p)];
    const bool body = all.of(p) == all.body;
    if (!body && whole(part, part.mass) < least_share * wall_mass_) continue;
    const double speed = body ? ps.velocity[p].y() : part.momentum / part.mass;
    if (distance_from_axis<axes>(ps.position[p]) < radius_ && speed > 0)
      risers.emplace_back(speed, all_ * ps.mass[p]);
  }
  std::ranges::sort(risers, std::greater<>());
  double mass = 0, speed = 0;
  for (const auto& [v, m] : risers) {
    speed = v;
    if ((mass += m) >= watched_share * wall_mass_) break;
  }
  if (speed >= speed_)
    slow_since_ = -1;
  else if (slow_since_ < 0)
    slow_since_ = s.time;
  if (slow_since_ >= 0 && s.time - slow_since_ >= hold_)
    decide(Verdict::arrested, s.time, speed / speed_ - 1);
}

/// The first verdict stands, but for material that comes off after an arrest.
template <int axes>
void BasicEjection<axes>::decide(Verdict verdict, double time, double margin) {
  if (verdict_ == verdict) return;
  verdict_ = verdict;
  decision_time_ = time;
  margin_ = margin;
}

template <int axes>
void BasicEjection<axes>::finish(const BasicState<axes>&, RunResult& result) const {
  result.outcome = verdict_ == Verdict::ejected    ? "ejected"
                   : verdict_ == Verdict::arrested ? "arrested"
                                                   : "undecided";
  auto& m = result.metrics;
  if (is_sphere_)
    m.push_back(metric(row_of(rows, "ejected_mass_kg"), ejected_mass_));
  else
    m.push_back(metric(row_of(rows, "ejected_mass_kg_m"), ejected_mass_));
  if (ejected_mass_ > 0)
    m.push_back(metric(row_of(rows, "ejecta_speed_m_s"), ejected_momentum_ / ejected_mass_));
  if (verdict_ == Verdict::undecided) return;
  m.push_back(metric(row_of(rows, "decision_time_s"), decision_time_));
  m.push_back(metric(row_of(rows, "decision_margin"), margin_));
}

template <int axes>
void BasicEjection<axes>::carry(Archive& a) {
  a.numbers("apart_since", apart_since_), a.number("slow_since", slow_since_);
  a.integer("verdict", verdict_), a.number("decision_time", decision_time_), a.number("margin", margin_);
  a.number("ejected_mass", ejected_mass_), a.number("ejected_momentum", ejected_momentum_);
}

template class BasicEjection<2>;
template class BasicEjection<3>;

}  // namespace mpm
