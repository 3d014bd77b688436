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

#include "libmpm/measure/energy.hpp"
#include "libmpm/mpm.hpp"
#include "libmpm/scene/build.hpp"
#include "libmpm/step/reference_stepper.hpp"
#include "libmpm/verification/exact/neo_hookean.hpp"

namespace mpm::verification {

/// What acts on a neo-Hookean body.
template <int axes>
struct BasicSurroundings {
  std::optional<int> ceiling{};  ///< row of a mirror above; there is always one at the floor and at the sides
  /// b(X, t) [N/kg] on the particle that began at X; empty: none.
  std::function<mpm::Vec<axes>(const mpm::Vec<axes>& initial, double t)> force{};
};
using Surroundings = BasicSurroundings<2>;

/// In any space. Cells are squares or cubes. A body that is not between mirrors must stay two cells clear of
/// the grid's sides.
template <class Space>
class NeoHookeanBodyIn {
 public:
  using Vector = mpm::Vec<Space::axes>;

  /// `columns`: cells across, and of three axes deep.
  NeoHookeanBodyIn(const exact::NeoHookean& solid, const Vector& origin, double cell, int columns)
      : solid_(solid), body_(nothing_yet(origin, cell, columns)) {}

  /// A particle at rest density: what it fills [m^2], of three axes [m^3], and half of its edge [m].
  void add(const Vector& x, const Vector& velocity, double filled, double half) {
    const double volume = Space::has_hoop ? filled * x.x() : filled;
    body_.particles.add(x, velocity, solid_.density * volume, volume, Vector::Constant(half));
    initial_.push_back(x);
  }
  /// To be called once, after the last particle and before the first step.
  template <class Shape, class Transfer = mpm::Flip>
  void begin(const BasicSurroundings<Space::axes>& around, const Transfer& transfer = {}) {
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

  const auto& particles() { return simulation_->state().particles; }
  const auto& grid() { return simulation_->state().grid; }
  const std::vector<Vector>& initial() const { return initial_; }  ///< X of each particle [m]
  double time() const { return simulation_->time(); }              ///< [s]

  double mass() {  ///< [kg/m]
    double sum = 0;
    for (const double m : particles().mass) sum += m;
    return sum;
  }
  Vector momentum() { return mpm::momentum_of(particles()); }  ///< [kg/s]
  double kinetic_energy() {                                    ///< [J/m]
    const auto& ps = particles();
    double sum = 0;
    for (std::size_t p = 0; p < ps.size(); ++p) sum += ps.mass[p] * ps.velocity[p].squaredNorm() / 2;
    return sum;
  }
  double strain_energy() requires(Space::axes == 2) {  ///< of the deformation, by the solid's W [J/m]
    const auto& ps = particles();
    const auto b = ps.own_values("left_cauchy_green_less_one");  // xx, yy, zz, xy
    double sum = 0;
    for (std::size_t p = 0; p < ps.size(); ++p)
      sum += ps.initial_volume[p] *
             solid_.strain_energy(1 + ps.dilation[p], b[4 * p] + b[4 * p + 1] + b[4 * p + 2]);
    return sum;
  }
  double internal_energy() {  ///< what the stress did, and the heat of the transfer [J/m]
    const auto& ps = particles();
    double sum = 0;
    for (std::size_t p = 0; p < ps.size(); ++p) sum += ps.mass[p] * ps.energy[p];
    return sum;
  }

 private:
  template <class Shape, class Transfer, class Force>
  void use(const mpm::Scene& scene, const Transfer& transfer, Force force) {
    using Stepper = mpm::ReferenceStepper<Shape, Transfer, Space, Force>;
    simulation_->use(std::make_unique<Stepper>(mpm::build_material(scene), transfer, force));
  }
  static mpm::BasicState<Space::axes> nothing_yet(const Vector& origin, double cell, int columns) {
    if constexpr (Space::axes == 2)
      return mpm::empty_state(origin, {cell, cell}, columns, mpm::Floor::mirror, Space::value);
    else
      return mpm::empty_state(origin, Vector::Constant(cell), columns, columns, mpm::Floor::mirror);
  }
  mpm::Scene frame() const {
    mpm::Scene scene;
    scene.space = Space::value;
    mpm::Material& m = scene.material;
    m.name = "neo-Hookean";
    m.law = mpm::MaterialLaw::neo_hookean;
    m.reference_density = solid_.density;
    m.youngs_modulus = solid_.youngs_modulus();
    m.pressure_limit = std::numeric_limits<double>::max();
    m.poissons_ratio = solid_.lambda / (2 * (solid_.lambda + solid_.mu));
    scene.numerics = mpm::default_numerics(mpm::SceneKind::cavity_impact, Space::value);
    scene.numerics.kernel = mpm::Kernel::reference;
    scene.numerics.linear_viscosity = scene.numerics.quadratic_viscosity = 0;
    scene.numerics.cell_size = body_.grid.cell().x();
    scene.end_time = scene.measures.area_every = 1;
    return scene;
  }

  exact::NeoHookean solid_;
  mpm::BasicState<Space::axes> body_;
  std::vector<Vector> initial_;
  std::optional<mpm::BasicSimulation<Space::axes>> simulation_;
};
using NeoHookeanBody = NeoHookeanBodyIn<mpm::space::PlaneStrain>;

}  // namespace mpm::verification
