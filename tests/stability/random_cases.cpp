#include <algorithm>
#include <cmath>
#include <sstream>

#include "libmpm/scene/kinds/kind.hpp"
#include "libmpm/scene/parameters.hpp"
#include "tests/stability/case.hpp"
#include "tests/stability/dice.hpp"

namespace stability {
namespace {

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

/// Three axes on a dozen cells: the plain step, and as many particles.
mpm::Scene draw_solid(Dice& d) {
  mpm::Scene s = draw(d);
  const mpm::Numerics drawn = s.numerics;
  s.space = mpm::Space::three_d;
  s.numerics = mpm::default_numerics(s.kind, s.space);
  const mpm::ShapeFunction schemes[] = {mpm::ShapeFunction::gimp, mpm::ShapeFunction::bspline2,
                                        mpm::ShapeFunction::bspline3};
  s.numerics.scheme = schemes[d.one_of(3)];
  s.numerics.transfer = d.chance(0.3) ? mpm::Transfer::apic : mpm::Transfer::flip;
  s.numerics.particles_per_cell = d.chance(0.3) ? 1 : 8;
  s.numerics.cfl = drawn.cfl, s.numerics.linear_viscosity = drawn.linear_viscosity;
  s.numerics.quadratic_viscosity = drawn.quadratic_viscosity;
  const mpm::Extent whole = mpm::kind_of(s).extent(s);
  s.numerics.cell_size = std::min(whole.width, whole.height) / d.between(8, 14);
  s.end_time = std::min(s.end_time, 2 * whole.width / s.material.bulk_sound_speed);
  s.measures.area_every = s.end_time / 20;
  return s;
}

}  // namespace

static Outcome run_drawn(const mpm::Scene& s, const std::string& description) {
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
  if (!o.as_expected) o.note += " " + description;
  return o;
}

std::vector<Case> drawn_cases(const std::string& name, int count, std::uint64_t seed,
                              const std::function<mpm::Scene(Dice&)>& draw,
                              const std::function<std::string(const mpm::Scene&)>& described) {
  std::vector<Case> cases;
  for (int k = 0; k < count; ++k) {
    Dice dice(seed + static_cast<std::uint64_t>(k));
    mpm::Scene scene = draw(dice);
    while (!mpm::find_problems(scene).empty()) scene = draw(dice);
    const mpm::Estimate e = mpm::estimate(scene);
    cases.push_back({name, "seed " + std::to_string(seed + static_cast<std::uint64_t>(k)), "says",
                     "drawn from the whole legal range",
                     static_cast<double>(e.particles) * static_cast<double>(e.steps) * e.update_cost,
                     [scene, described] { return run_drawn(scene, described(scene)); }});
  }
  return cases;
}

std::vector<Case> random_cases(int count, std::uint64_t seed) {
  return drawn_cases("random", count, seed, draw, described);
}

std::vector<Case> random_solid_cases(int count, std::uint64_t seed) {
  return drawn_cases("random solid", count, seed, draw_solid, described);
}

}  // namespace stability
