#pragma once
/// Elastic bodies for exact problems whose material is not that of the scenes: the library's p2g, grid update
/// and g2p with a neo-Hookean stress, under a body force.
#include <algorithm>
#include <cmath>
#include <cstddef>
#include <functional>
#include <limits>
#include <memory>
#include <optional>
#include <utility>
#include <vector>

#include "libmpm/boundary/mirror.hpp"
#include "libmpm/mpm.hpp"
#include "libmpm/step/g2p.hpp"
#include "libmpm/step/grid_update.hpp"
#include "libmpm/step/p2g.hpp"
#include "libmpm/verification/exact/neo_hookean.hpp"

namespace mpm::verification {

/// What acts on a neo-Hookean body.
struct Surroundings {
  int top;                     ///< row of a mirror there, or of any row above the body
  bool mirror_at_top = false;  ///< there is always one at the floor and at the sides
  /// b(X, t) [N/kg] on the particle that began at X; empty: none.
  std::function<mpm::Vec2(const mpm::Vec2& initial, double t)> force{};
};

/// Its particles carry F <- (1 + dt L) F, and the stress
///   sigma = (lambda ln J 1 + mu (F F^T - 1)) / J.
class NeoHookeanStepper : public mpm::Stepper {
 public:
  explicit NeoHookeanStepper(const exact::NeoHookean& solid) : solid_(solid) {}

  double strain_energy(const mpm::Particles& ps) const {  ///< of the deformation, by the solid's W [J/m]
    double sum = 0;
    for (std::size_t p = 0; p < deformation_.size(); ++p) {
      const mpm::Mat2& f = deformation_[p];
      sum += ps.initial_volume[p] * solid_.strain_energy(f(0, 0), f(0, 1), f(1, 0), f(1, 1));
    }
    return sum;
  }
  void carry(mpm::State& state, mpm::Archive& a) override {
    carry_particles(state.particles, a);
    a.numbers("initial", initial_), a.numbers("deformation", deformation_);
  }

 protected:
  void begin(const mpm::State& state) {
    if (!initial_.empty()) return;
    initial_ = state.particles.position;
    deformation_.assign(initial_.size(), mpm::Mat2::Identity());
  }
  const mpm::Vec2& initial(std::size_t p) const { return initial_[p]; }

  void update_stress(mpm::State& state, double dt, mpm::StepReport& report) {
    mpm::Particles& ps = state.particles;
    for (std::size_t p = 0; p < ps.size(); ++p) {
      mpm::Mat2& f = deformation_[p];
      f = (mpm::Mat2::Identity() + dt * state.velocity_gradient[p]) * f;
      const double jacobian = f(0, 0) * f(1, 1) - f(0, 1) * f(1, 0);
      const double mean = (solid_.lambda * std::log(jacobian) - solid_.mu) / jacobian;
      const double k = solid_.mu / jacobian;
      ps.dilation[p] = jacobian - 1;
      // The whole stress; the pressure stays 0.
      ps.deviator[p] = {mean + k * f.row(0).squaredNorm(), mean + k * f.row(1).squaredNorm(), 0,
                        k * f.row(0).dot(f.row(1))};
      report.smallest_dilation = std::min(report.smallest_dilation, ps.dilation[p]);
      report.largest_dilation = std::max(report.largest_dilation, ps.dilation[p]);
      report.kinetic_energy += ps.kinetic_energy(p);
    }
    report.largest_signal = solid_.longitudinal_speed();
  }

 private:
  exact::NeoHookean solid_;
  std::vector<mpm::Vec2> initial_;
  std::vector<mpm::Mat2> deformation_;
};

template <class Shape, class Transfer = mpm::Flip>
class NeoHookeanSteps : public NeoHookeanStepper {
 public:
  NeoHookeanSteps(const exact::NeoHookean& solid, Surroundings around, const Transfer& transfer = {})
      : NeoHookeanStepper(solid), around_(std::move(around)), transfer_(transfer) {}

  mpm::StepReport step(mpm::State& state, double dt) override {
    begin(state);
    mpm::StepReport report;
    mpm::Particles& ps = state.particles;
    mpm::Grid& grid = state.grid;
    if constexpr (requires { Shape::start(ps); }) Shape::start(ps);
    Transfer::start(ps);
    grid.grow_to_row(around_.top + 1 + Shape::reach);
    grid.clear();
    mpm::p2g<Shape, Transfer>(ps, grid);
    if (around_.force) push(state);
    for (mpm::Node& n : grid.nodes()) n.own_mass = n.mass;
    mpm::reflect_sides(grid, around_.top + Shape::reach);
    mpm::reflect_floor(grid);
    if (around_.mirror_at_top) mpm::reflect_row(grid, around_.top, Shape::reach);
    mpm::update_grid(grid, dt);
    report.transfer_heat = mpm::g2p<Shape>(ps, grid, dt, state.velocity_gradient, transfer_);
    update_stress(state, dt, report);
    state.time += dt;
    ++state.step;
    return report;
  }

 private:
  void push(mpm::State& state) {
    for (std::size_t p = 0; p < state.particles.size(); ++p) {
      const mpm::Vec2 b = state.particles.mass[p] * around_.force(initial(p), state.time);
      mpm::stencil_of<Shape>(state.grid, state.particles, p)
          .for_each(state.grid, [&](mpm::Node& n, double w, const mpm::Vec2&) { n.acceleration += w * b; });
    }
  }

  Surroundings around_;
  Transfer transfer_;
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
  void begin(Surroundings around, const Transfer& transfer = {}) {
    auto stepper = std::make_unique<NeoHookeanSteps<Shape, Transfer>>(solid_, std::move(around), transfer);
    stepper_ = stepper.get();
    const mpm::Scene scene = frame();
    simulation_.emplace(scene, std::move(body_));
    simulation_->use(std::move(stepper));
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
  double strain_energy() { return stepper_->strain_energy(particles()); }  ///< [J/m]
  double internal_energy() {  ///< what the stress did, and the heat of the transfer [J/m]
    const mpm::Particles& ps = particles();
    double sum = 0;
    for (std::size_t p = 0; p < ps.size(); ++p) sum += ps.mass[p] * ps.energy[p];
    return sum;
  }

 private:
  /// The settings of a run whose stepper has its own material: the solid at small strains, without heat.
  mpm::Scene frame() const {
    mpm::Scene scene;
    mpm::Material& m = scene.material;
    const double bulk = solid_.lambda + 2 * solid_.mu / 3;
    m.name = "neo-Hookean";
    m.reference_density = solid_.density;
    m.youngs_modulus = m.pressure_limit = solid_.youngs_modulus();
    m.poissons_ratio = solid_.lambda / (2 * (solid_.lambda + solid_.mu));
    m.yield_stress = std::numeric_limits<double>::infinity();
    m.bulk_sound_speed = std::sqrt(bulk / solid_.density);
    m.specific_heat = 1;
    scene.numerics = mpm::default_numerics(mpm::SceneKind::cavity_impact);
    scene.numerics.cell_size = body_.grid.cell().x();
    scene.end_time = scene.measures.area_every = 1;
    return scene;
  }

  exact::NeoHookean solid_;
  mpm::State body_;
  std::vector<mpm::Vec2> initial_;
  std::optional<mpm::Simulation> simulation_;
  NeoHookeanStepper* stepper_ = nullptr;  ///< the simulation's
};

}  // namespace mpm::verification
