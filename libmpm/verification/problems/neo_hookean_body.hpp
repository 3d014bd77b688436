#pragma once
/// Elastic bodies for exact problems: the library's plain step with its neo-Hookean material, under a body
/// force.
#include <cmath>
#include <cstddef>
#include <functional>
#include <limits>
#include <memory>
#include <optional>
#include <utility>
#include <vector>

#include "libmpm/mpm.hpp"
#include "libmpm/scene/build.hpp"
#include "libmpm/step/reference_stepper.hpp"
#include "libmpm/verification/exact/neo_hookean.hpp"

namespace mpm::verification {

/// What acts on a neo-Hookean body.
struct Surroundings {
  std::optional<int> ceiling{};  ///< row of a mirror above; there is always one at the floor and at the sides
  /// b(X, t) [N/kg] on the particle that began at X; empty: none.
  std::function<mpm::Vec2(const mpm::Vec2& initial, double t)> force{};
};

/// Cells are squares. A body that is not between mirrors must stay two cells clear of the grid's sides.
class NeoHookeanBody {
 public:
  NeoHookeanBody(const exact::NeoHookean& solid, mpm::Vec2 origin, double cell, int columns)
      : solid_(solid), body_(mpm::empty_state(origin, {cell, cell}, columns, mpm::Floor::mirror)) {}

  /// A particle at rest density: volume [m^2] and half of its edge [m].
  void add(const mpm::Vec2& x, const mpm::Vec2& velocity, double volume, double half) {
    body_.particles.add(x, velocity, solid_.density * volume, volume, {half, half});
    initial_.push_back(x);
  }
  /// To be called once, after the last particle and before the first step.
  template <class Shape, class Transfer = mpm::Flip>
  void begin(const Surroundings& around, const Transfer& transfer = {}) {
    const mpm::Scene scene = frame();
    body_.ceiling = around.ceiling;
    simulation_.emplace(scene, std::move(body_));
    if (around.force)
      use<Shape, Transfer>(scene, transfer,
                           [initial = initial_, force = around.force](std::size_t p, double t) {
                             return force(initial[p], t);
                           });
    else
      use<Shape, Transfer>(scene, transfer, mpm::NoBodyForce{});
  }
  void step(double dt) { simulation_->step(dt); }

  const mpm::Particles& particles() { return simulation_->state().particles; }
  const mpm::Grid& grid() { return simulation_->state().grid; }
  const std::vector<mpm::Vec2>& initial() const { return initial_; }  ///< X of each particle [m]
  double time() const { return simulation_->time(); }                 ///< [s]

  double mass() {  ///< [kg/m]
    double sum = 0;
    for (const double m : particles().mass) sum += m;
    return sum;
  }
  mpm::Vec2 momentum() {  ///< [kg/s]
    const mpm::Particles& ps = particles();
    mpm::Vec2 sum(0, 0);
    for (std::size_t p = 0; p < ps.size(); ++p) sum += ps.mass[p] * ps.velocity[p];
    return sum;
  }
  double kinetic_energy() {  ///< [J/m]
    const mpm::Particles& ps = particles();
    double sum = 0;
    for (std::size_t p = 0; p < ps.size(); ++p) sum += ps.mass[p] * ps.velocity[p].squaredNorm() / 2;
    return sum;
  }
  double strain_energy() {  ///< of the deformation, by the solid's W [J/m]
    const mpm::Particles& ps = particles();
    const auto b = ps.own_values("left_cauchy_green_less_one");  // xx, yy, zz, xy
    double sum = 0;
    for (std::size_t p = 0; p < ps.size(); ++p)
      sum += ps.initial_volume[p] *
             solid_.strain_energy(1 + ps.dilation[p], b[4 * p] + b[4 * p + 1] + b[4 * p + 2]);
    return sum;
  }
  double internal_energy() {  ///< what the stress did, and the heat of the transfer [J/m]
    const mpm::Particles& ps = particles();
    double sum = 0;
    for (std::size_t p = 0; p < ps.size(); ++p) sum += ps.mass[p] * ps.energy[p];
    return sum;
  }

 private:
  template <class Shape, class Transfer, class Force>
  void use(const mpm::Scene& scene, const Transfer& transfer, Force force) {
    using Stepper = mpm::ReferenceStepper<Shape, Transfer, mpm::space::PlaneStrain, Force>;
    simulation_->use(std::make_unique<Stepper>(mpm::build_material(scene), transfer, force));
  }
  mpm::Scene frame() const {
    mpm::Scene scene;
    mpm::Material& m = scene.material;
    m.name = "neo-Hookean";
    m.law = mpm::MaterialLaw::neo_hookean;
    m.reference_density = solid_.density;
    m.youngs_modulus = solid_.youngs_modulus();
    m.pressure_limit = std::numeric_limits<double>::max();
    m.poissons_ratio = solid_.lambda / (2 * (solid_.lambda + solid_.mu));
    scene.numerics = mpm::default_numerics(mpm::SceneKind::cavity_impact);
    scene.numerics.kernel = mpm::Kernel::reference;
    scene.numerics.linear_viscosity = scene.numerics.quadratic_viscosity = 0;
    scene.numerics.cell_size = body_.grid.cell().x();
    scene.end_time = scene.measures.area_every = 1;
    return scene;
  }

  exact::NeoHookean solid_;
  mpm::State body_;
  std::vector<mpm::Vec2> initial_;
  std::optional<mpm::Simulation> simulation_;
};

}  // namespace mpm::verification
