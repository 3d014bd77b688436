#include <algorithm>
#include <cmath>
#include <random>
#include <sstream>

#include "libmpm/scene/kinds/kind.hpp"
#include "libmpm/scene/parameters.hpp"
#include "tests/stability/case.hpp"

namespace stability {
namespace {

/// Numbers that do not depend on the standard library's distributions.
class Dice {
 public:
  explicit Dice(std::uint64_t seed) : engine_(seed) {}
  double unit() { return static_cast<double>(engine_() >> 11) * 0x1p-53; }
  double between(double low, double high) { return low + (high - low) * unit(); }
  double log_between(double low, double high) { return low * std::pow(high / low, unit()); }
  std::size_t one_of(std::size_t n) { return static_cast<std::size_t>(unit() * static_cast<double>(n)); }
  bool chance(double p) { return unit() < p; }

 private:
  std::mt19937_64 engine_;
};

/// A legal scene; lengths are in units of its own scale, which spans 2^40.
mpm::Scene draw(Dice& d) {
  mpm::Scene s;
  // those that are made of numbers come first
  const auto kinds = std::ranges::count_if(mpm::kinds(), [](const mpm::Kind* k) { return !k->is_composed; });
  s.kind = static_cast<mpm::SceneKind>(d.one_of(static_cast<std::size_t>(kinds)));
  s.material = mpm::named_material("aluminium");
  s.numerics = mpm::default_numerics(s.kind);
  // not those that came later: one more draw would make other scenes of all seeds
  for (const mpm::Choice& c : mpm::choices())
    if (c.belongs_to(s.kind) && c.implied.empty()) c.set(s, d.one_of(c.allowed.size()));
  const double scale = d.log_between(1e-9, 1e3);
  const double sides[] = {1, 4, 9, 16};
  s.numerics.particles_per_cell = static_cast<int>(sides[d.one_of(4)]);
  s.numerics.cfl = d.log_between(0.05, 0.6);
  s.numerics.linear_viscosity = d.chance(0.1) ? 0 : d.between(0, 2);
  s.numerics.quadratic_viscosity = d.chance(0.1) ? 0 : d.between(0, 3);

  mpm::Material& m = s.material;
  m.yield_stress = d.chance(0.1) ? 0 : d.log_between(1e6, 1e10);
  m.hardening_modulus = d.chance(0.2) ? 0 : d.log_between(1e6, 1e10);
  m.kinematic_fraction = d.chance(0.5) ? 0 : d.unit();
  m.poissons_ratio = d.between(0, 0.499);
  m.spall_strength = d.log_between(1e7, 1e10);
  m.hugoniot_slope = d.between(1, 2);
  m.gruneisen_gamma = d.between(0, 3);

  const double speed = d.log_between(1, 5000);
  s.impact_speed = s.inner_speed = speed;
  s.block_width = scale * d.between(1, 3);
  s.block_height = scale * d.between(1, 3);
  const double largest = 0.5 * std::min(s.block_width, s.block_height);
  s.cavity_radius = largest * d.between(0.15, 0.99);
  s.cavity_center_height =
      d.chance(0.2) ? s.cavity_radius : d.between(s.cavity_radius, s.block_height - s.cavity_radius);
  s.inner_radius = scale * d.between(0.2, 1);
  s.outer_radius = s.inner_radius * d.between(1.4, 3);
  // One that is too coarse for this kind of scene is drawn again.
  const mpm::Extent whole = mpm::kind_of(s).extent(s);
  s.numerics.cell_size = std::min(whole.width, whole.height) / 8 * d.log_between(0.3, 1);
  s.end_time = d.log_between(0.1, 10) * scale / m.bulk_sound_speed;
  s.measures.area_every = s.end_time / 20;
  return s;
}

std::string described(const mpm::Scene& s) {
  std::ostringstream text;
  text << mpm::to_string(s.kind);
  for (const mpm::Quantity& q : mpm::quantities())
    if (q.belongs_to(s.kind)) text << " " << q.name << "=" << q.get(s);
  for (const mpm::Choice& c : mpm::choices())
    if (c.belongs_to(s.kind)) text << " " << c.name << "=" << c.allowed[c.get(s)];
  return text.str();
}

/// Whatever comes of it, it is said: done with its health in order, or failed with a reason.
Outcome run_random(const mpm::Scene& s) {
  const mpm::RunResult r = mpm::run(s);
  Outcome o = judge(r, 0.01);
  bool finite = std::isfinite(r.energy_error);
  double beyond = 0;
  for (const mpm::Metric& m : r.metrics) {
    finite &= std::isfinite(m.value) || m.name == "momentum_error";
    if (m.name == "overstrained_mass_fraction" || m.name == "overpressed_mass_fraction")
      beyond = std::max(beyond, m.value);
  }
  if (r.status == mpm::RunStatus::done)
    o.as_expected = finite && r.energy_error < 0.01 && o.largest_cfl <= 1 && beyond <= 0.01;
  else
    o.as_expected = r.status == mpm::RunStatus::failed && !r.reason.empty();
  if (!o.as_expected) o.note += " " + described(s);
  return o;
}

}  // namespace

std::vector<Case> random_cases(int count, std::uint64_t seed) {
  std::vector<Case> cases;
  for (int k = 0; k < count; ++k) {
    Dice dice(seed + static_cast<std::uint64_t>(k));
    mpm::Scene scene = draw(dice);
    while (!mpm::find_problems(scene).empty()) scene = draw(dice);
    const mpm::Estimate e = mpm::estimate(scene);
    cases.push_back({"random", "seed " + std::to_string(seed + static_cast<std::uint64_t>(k)), "says",
                     "drawn from the whole legal range",
                     static_cast<double>(e.particles) * static_cast<double>(e.steps),
                     [scene] { return run_random(scene); }});
  }
  return cases;
}

}  // namespace stability
