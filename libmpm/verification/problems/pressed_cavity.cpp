#include "libmpm/verification/exact/pressed_cavity.hpp"

#include <algorithm>
#include <cmath>
#include <utility>
#include <vector>

#include "libmpm/verification/exact/lagrangian_1d.hpp"
#include "libmpm/verification/problems/problems.hpp"
#include "libmpm/verification/problems/scenes.hpp"
#include "libmpm/verification/problems/with_options.hpp"

namespace mpm::verification {
namespace {

constexpr double cavity_radius = 1e-6;

mpm::Material perfectly_plastic() {
  mpm::Material m = mpm::named_material("aluminium");
  m.hardening_modulus = 0;
  return m;
}

/// Half of a spherical cavity in aluminium that is under pressure from the start, between mirrors and as far
/// from a free surface above as sound comes in the time: twice as far as from the mirror beside it.
mpm::Scene medium(double pressure, double cell, double end_time) {
  mpm::Scene s;
  s.kind = mpm::SceneKind::bodies;
  s.space = mpm::Space::axisymmetric;
  s.material = perfectly_plastic();
  s.numerics = mpm::default_numerics(s.kind, s.space);
  s.numerics.cell_size = cell;
  s.end_time = end_time;
  s.measures.area_every = end_time / 200;
  const double way = std::max(mpm::sound_speed_at_rest(s.material) * end_time, 8 * cavity_radius);
  const double across = std::ceil(way / 2 / cell) * cell;
  s.composition.high = {across, 2 * across, 0};
  for (const mpm::Side side : {mpm::Side::left, mpm::Side::right, mpm::Side::bottom})
    s.composition.faces[static_cast<std::size_t>(side)] = mpm::Face::mirror;
  const mpm::Shape box{mpm::Shape::Form::block, {0, 0, 0, across, 2 * across, 0}, {}};
  const mpm::Shape ball{mpm::Shape::Form::ball, {0, 0, 0, cavity_radius}, {}};
  s.composition.bodies = {{.name = "medium",
                           .shape = {mpm::Shape::Form::difference, {}, {box, ball}},
                           .energy = pressure / mpm::pressure_per_energy(s.material)}};
  return s;
}

/// The radius of the cavity, by the volume between it and the particles that were a cell from it or nearer:
///   a^3 = a0^3 + mean(r^3 - r0^3)
class Layer {
 public:
  Layer(const mpm::Particles& ps, double cell) {
    for (std::size_t p = 0; p < ps.size(); ++p)
      if (const double r = ps.position[p].norm(); r < cavity_radius + cell)
        particles_.push_back(p), before_ += ps.mass[p] * r * r * r, mass_ += ps.mass[p];
  }
  double radius(const mpm::Particles& ps) const {
    double now = 0;
    for (const std::size_t p : particles_) now += ps.mass[p] * std::pow(ps.position[p].norm(), 3);
    return std::cbrt(std::pow(cavity_radius, 3) + (now - before_) / mass_);
  }

 private:
  std::vector<std::size_t> particles_;
  double before_ = 0, mass_ = 0;
};

struct Closing {
  exact::CavityHistory history;
  mpm::RunResult result;
};

Closing close(const mpm::Scene& scene) {
  mpm::Simulation simulation(scene);
  const Layer layer(simulation.state().particles, scene.numerics.cell_size);
  Closing c;
  bool going = true;
  while (going) {
    c.history.time.push_back(simulation.time());
    c.history.radius.push_back(layer.radius(simulation.state().particles));
    const double next = simulation.time() + scene.measures.area_every / 2;
    while (going && simulation.time() < next) going = simulation.step();
  }
  c.result = simulation.result();
  return c;
}

}  // namespace

/// Two references: the incompressible medium in closed form, which says whether the cavity closes, and the
/// compressible one in one dimension, whose wall moves at once when it is let go: by a tenth of the time or
/// two sooner, and further.
ExactNumbers pressed_cavity_numbers(double share, const ExactOptions& options) {
  const mpm::Material m = perfectly_plastic();
  const exact::PressedCavity cavity{cavity_radius, m.reference_density, m.yield_stress, m.shear_modulus()};
  const double pressure = share * exact::closing_pressure(cavity), cell = 0.1e-6 * options.cells;
  const exact::CavityStop stop = exact::pressed_cavity_stop(cavity, pressure);
  const double end_time = 1.1 * stop.time;
  const auto code = exact::compressible_cavity(scenes::exact_solid(m), cavity_radius, pressure, end_time, 60);
  const Closing c = close(with_options(medium(pressure, cell, end_time), options));
  const exact::CavityHistory& ours = c.history;
  ExactNumbers numbers;
  const auto add_time = [&](const char* name, double radius) {
    numbers.push_back({name, "s", code.time_at(radius), ours.time_at(radius), 0.05});
  };
  numbers.push_back({"closes to a quarter of the radius", "1", stop.closes ? 1.0 : 0.0,
                     ours.least() <= cavity_radius / 4 ? 1.0 : 0.0, 0, Judged::absolute});
  if (stop.closes) {
    add_time("time to half of the radius", cavity_radius / 2);
    add_time("time to a quarter of it", cavity_radius / 4);
  } else {
    numbers.push_back({"stop radius", "m", code.least(), ours.least(), 0.03});
    add_time("time to half of the way", 0.5 * (cavity_radius + code.least()));  // the turn itself is flat
  }
  numbers.push_back({"energy error", "1", 0, c.result.energy_error, 1e-11, Judged::absolute});
  return with_trouble(std::move(numbers), c.result);
}

}  // namespace mpm::verification
