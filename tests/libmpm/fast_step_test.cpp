// The fast step against the reference step, and against itself in another instruction set.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>
#include <sstream>
#include <string>

#include "libmpm/material/eos/mie_grueneisen.hpp"
#include "libmpm/measure/energy.hpp"
#include "libmpm/shape/bspline2.hpp"
#include "libmpm/shape/gimp.hpp"
#include "libmpm/step/fast/fast_stepper.hpp"
#include "libmpm/step/step.hpp"
#include "tests/libmpm/random_state.hpp"
#include "tests/libmpm/scenes.hpp"

namespace {

using mpm::fast::FastStepper;
using FastDouble = FastStepper<double>;
using mpm::fast::InstructionSet;

/// Largest difference of a column over its largest value.
template <class Column, class Value>
double difference(const Column& a, const Column& b, Value value) {
  double most = 0, scale = 0;
  for (std::size_t p = 0; p < a.size(); ++p) {
    most = std::max(most, std::abs(value(a[p]) - value(b[p])));
    scale = std::max(scale, std::abs(value(b[p])));
  }
  return scale > 0 ? most / scale : most;
}

template <int axes>
void expect_same(const mpm::BasicParticles<axes>& a, const mpm::BasicParticles<axes>& b, double tolerance) {
  const auto same = [](double v) { return v; };
  for (int axis = 0; axis < axes; ++axis) {
    const auto of_axis = [&](const mpm::Vec<axes>& v) { return v[axis]; };
    EXPECT_LT(difference(a.position, b.position, of_axis), tolerance);
    EXPECT_LT(difference(a.velocity, b.velocity, of_axis), tolerance);
    EXPECT_LT(difference(a.half_size, b.half_size, of_axis), tolerance);
  }
  EXPECT_LT(difference(a.dilation, b.dilation, same), tolerance);
  EXPECT_LT(difference(a.energy, b.energy, same), tolerance);
  EXPECT_LT(difference(a.pressure, b.pressure, same), tolerance);
  EXPECT_LT(difference(a.viscous_pressure, b.viscous_pressure, same), tolerance);
  ASSERT_EQ(a.own.size(), b.own.size());
  for (std::size_t c = 0; c < a.own.size(); ++c) {
    EXPECT_EQ(a.own[c].name, b.own[c].name);
    EXPECT_LT(difference(a.own[c].values, b.own[c].values, same), tolerance) << a.own[c].name;
  }
  using Tensor = mpm::Tensor<axes>;
  EXPECT_LT(difference(a.deviator, b.deviator, [](const Tensor& t) { return t.xx; }), tolerance);
  EXPECT_LT(difference(a.deviator, b.deviator, [](const Tensor& t) { return t.zz; }), tolerance);
  EXPECT_LT(difference(a.deviator, b.deviator, [](const Tensor& t) { return t.xy; }), tolerance);
  if constexpr (axes == 3) {
    EXPECT_LT(difference(a.deviator, b.deviator, [](const Tensor& t) { return t.xz; }), tolerance);
    EXPECT_LT(difference(a.deviator, b.deviator, [](const Tensor& t) { return t.yz; }), tolerance);
  }
}

bool is_gimp(const mpm::Scene& s) { return s.numerics.scheme == mpm::ShapeFunction::gimp; }

template <class Real, int axes = 2>
FastStepper<Real, axes> fast_stepper(const mpm::Scene& s,
                                     InstructionSet set = mpm::fast::best_instruction_set()) {
  using Shape = typename FastStepper<Real, axes>::Shape;
  return {mpm::build_material(s), is_gimp(s) ? Shape::gimp : Shape::bspline2, s.space, set};
}

template <int axes>
mpm::BasicStepReport<axes> reference(mpm::BasicState<axes>& s, const mpm::Scene& scene, double dt) {
  const mpm::MaterialModel m = mpm::build_material(scene);
  return mpm::space::with_space<axes>(scene.space, [&]<class Space>(Space) {
    return is_gimp(scene) ? mpm::reference_step<mpm::Gimp, mpm::Flip, Space>(s, m, dt)
                          : mpm::reference_step<mpm::BSpline2, mpm::Flip, Space>(s, m, dt);
  });
}

/// The other models, each once: neo-Hookean and fluids without kinematic, the rest with kinematic >= 0.
std::vector<mpm::Material> other_materials(const mpm::Material& like, double kinematic) {
  std::vector<mpm::Material> all;
  if (kinematic < 0) {
    mpm::Material& rubber = all.emplace_back(like);
    rubber.law = mpm::MaterialLaw::neo_hookean;
    rubber.pressure_limit = 1e7;  // its pressures begin at 0
    mpm::Material& melt = all.emplace_back(like);
    melt.strength = mpm::StrengthModel::none;
    mpm::Material& water = all.emplace_back(melt);
    water.eos = mpm::EquationOfState::stiffened_gas;
    water.adiabatic_index = 4.4, water.stiffening_pressure = 17e9;
    water.pressure_limit = 1e8;
    mpm::Material& tait = all.emplace_back(melt);
    tait.eos = mpm::EquationOfState::tait;
    tait.tait_exponent = 7, tait.tait_pressure = 10e9;
    mpm::Material& sg = all.emplace_back(mpm::named_material("copper-steinberg-guinan"));
    sg.reference_density = like.reference_density, sg.pressure_limit = 1e9;
    return all;
  }
  mpm::Material& failing = all.emplace_back(like);
  failing.failure_strain = 0.002;
  mpm::Material& jc = all.emplace_back(like);
  jc.strength = mpm::StrengthModel::johnson_cook;
  jc.strain_hardening = 300e6, jc.hardening_exponent = 0.4;
  jc.rate_hardening = 0.02, jc.reference_strain_rate = 1;
  jc.softening_exponent = 1, jc.melting_temperature = 900;
  if (kinematic > 0) jc.failure_strain = 0.003;
  return all;
}

/// Every combination that has a kernel of its own, and the tension that needs none.
template <int axes = 2>
std::vector<mpm::Scene> variants() {
  std::vector<mpm::Scene> all;
  const std::vector<mpm::Space> spaces =
      axes == 3 ? std::vector{mpm::Space::three_d}
                : std::vector{mpm::Space::plane_strain, mpm::Space::axisymmetric};
  for (const auto space : spaces)
    for (const auto scheme : {mpm::ShapeFunction::gimp, mpm::ShapeFunction::bspline2})
      for (const double kinematic : {-1.0, 0.0, 0.3})  // -1: elastic
        for (const auto tension : {mpm::Tension::polynomial, mpm::Tension::linear, mpm::Tension::cutoff}) {
          mpm::Scene s = scenes::cavity(0.2e-6);
          s.space = space;
          if (axes == 3) {
            s = scenes::in_space(space, scenes::cavity(0.5e-6));
            s.block_width = 9e-6, s.block_height = 4.5e-6, s.cavity_center_height = 2.2e-6;
          }
          s.numerics.scheme = scheme;
          if (kinematic < 0)
            s.material.yield_stress = std::numeric_limits<double>::infinity();
          else
            s.material.kinematic_fraction = kinematic;
          s.material.tension = tension;
          s.material.spall_strength = 1e9;
          s.material.pressure_limit = 1e9;  // some random pressures are beyond
          all.push_back(s);
          if (tension != mpm::Tension::polynomial) continue;
          for (const mpm::Material& m : other_materials(s.material, kinematic)) {
            s.material = m;
            if (axes == 3) s.material.pressure_limit *= 0.2;  // nodes average more particles: lower pressures
            all.push_back(s);
          }
        }
  return all;
}

/// A random state in eddies of ten cells: within 30 ps most blocks of the fast step have strays and are
/// sorted.
template <int axes = 2>
mpm::BasicState<axes> eddies(const mpm::Scene& scene) {
  mpm::BasicState<axes> s = random_state<axes>(scene, 1.03e-6);
  for (std::size_t p = 0; p < s.particles.size(); ++p) {
    const mpm::Vec<axes> angle = std::numbers::pi / (5 * scene.numerics.cell_size) * s.particles.position[p];
    s.particles.velocity[p].x() += 3000 * std::sin(angle.x()) * std::cos(angle.y());
    s.particles.velocity[p].y() -= 3000 * std::cos(angle.x()) * std::sin(angle.y());
    if constexpr (axes == 3) s.particles.velocity[p].z() += 3000 * std::sin(angle.z()) * std::cos(angle.x());
  }
  return s;
}

/// Gives back what the reference reports.
template <class Real, int axes>
mpm::BasicStepReport<axes> expect_same_step(FastStepper<Real, axes>& fast, mpm::BasicState<axes>& a,
                                            mpm::BasicState<axes>& b, const mpm::Scene& scene, double dt,
                                            double tolerance) {
  const mpm::BasicStepReport<axes> x = fast.step(a, dt), y = reference(b, scene, dt);
  EXPECT_NEAR(x.largest_signal / y.largest_signal, 1, tolerance);
  EXPECT_NEAR(x.overpressed_mass, y.overpressed_mass, tolerance * y.overpressed_mass);
  EXPECT_EQ(x.overstrained_mass > 0, y.overstrained_mass > 0);
  EXPECT_NEAR(x.kinetic_energy / y.kinetic_energy, 1, tolerance);
  EXPECT_NEAR(x.smallest_dilation, y.smallest_dilation, tolerance);
  EXPECT_NEAR(x.largest_dilation, y.largest_dilation, tolerance);
  EXPECT_NEAR(x.transfer_heat / y.transfer_heat, 1, tolerance);
  EXPECT_LT((x.wall_impulse - y.wall_impulse).norm(), tolerance * mpm::momentum_of(b.particles).norm());
  fast.refresh_particles(a);
  expect_same(a.particles, b.particles, tolerance);
  return y;
}

std::string name_of(const mpm::Scene& scene) {
  std::ostringstream text;
  text << "space " << static_cast<int>(scene.space) << ", gimp " << is_gimp(scene) << ", kinematic "
       << scene.material.kinematic_fraction << ", law " << static_cast<int>(scene.material.law) << ", eos "
       << static_cast<int>(scene.material.eos) << ", strength " << static_cast<int>(scene.material.strength)
       << ", failure " << scene.material.failure_strain << ", tension "
       << static_cast<int>(scene.material.tension);
  return text.str();
}

/// None puts the edge of a domain exactly on a node: there rounding decides whether the node is reached.
double least_lift(const mpm::Scene& s) { return s.space == mpm::Space::plane_strain ? 0.0 : 0.01e-6; }

template <class Real, int axes = 2>
void expect_reference_on_random_states(double tolerance) {
  for (const mpm::Scene& scene : variants<axes>())
    for (const double lift : {least_lift(scene), 0.13e-6, 1.03e-6}) {
      SCOPED_TRACE(testing::Message() << name_of(scene) << ", lift " << lift);
      mpm::BasicState<axes> a = random_state<axes>(scene, lift), b = a;
      FastStepper<Real, axes> fast = fast_stepper<Real, axes>(scene);
      for (int k = 0; k < 3; ++k)
        EXPECT_GT(expect_same_step(fast, a, b, scene, (5 + k) * 5e-6 * scene.numerics.cell_size, tolerance)
                      .overpressed_mass,
                  0);
    }
}

/// Some particles expand beyond the range of the equation of state.
template <class Real, int axes = 2>
void expect_reference_on_what_has_expanded(double tolerance) {
  for (const mpm::Scene& scene : variants<axes>()) {
    SCOPED_TRACE(name_of(scene));
    mpm::BasicState<axes> a = random_state<axes>(scene, least_lift(scene)), b = a;
    for (std::size_t p = 0; p < a.particles.size(); p += 10)
      a.particles.dilation[p] = b.particles.dilation[p] = mpm::MieGrueneisen::most_dilation * (1 - 1e-5);
    FastStepper<Real, axes> fast = fast_stepper<Real, axes>(scene);
    for (int k = 0; k < 3; ++k) expect_same_step(fast, a, b, scene, (5 + k) * 1e-14, tolerance);
    const auto& dilation = b.particles.dilation;
    EXPECT_GT(std::count(dilation.begin(), dilation.end(), mpm::MieGrueneisen::most_dilation), 20);
  }
}

template <class Real, int axes = 2>
void expect_reference_on_eddies(double tolerance) {
  for (const mpm::Scene& scene : variants<axes>()) {
    SCOPED_TRACE(name_of(scene));
    mpm::BasicState<axes> a = eddies<axes>(scene), b = a;
    FastStepper<Real, axes> fast = fast_stepper<Real, axes>(scene);
    for (int k = 0; k < 5; ++k) expect_same_step(fast, a, b, scene, 1e-11, tolerance);
  }
}

TEST(FastStep, AgreesWithTheReferenceOnRandomStates) { expect_reference_on_random_states<double>(1e-12); }
TEST(FastStep, FloatAgreesWithTheReferenceOnRandomStates) { expect_reference_on_random_states<float>(1e-4); }
TEST(FastStep, AgreesWithTheReferenceOnWhatHasExpandedTenfold) {
  expect_reference_on_what_has_expanded<double>(1e-12);
  expect_reference_on_what_has_expanded<float>(1e-4);
}
TEST(FastStep, AgreesWithTheReferenceWhereParticlesStray) {
  expect_reference_on_eddies<double>(1e-12);
  expect_reference_on_eddies<float>(1e-4);
}

TEST(FastStep, OfThreeAxesAgreesWithTheReferenceOnRandomStates) {
  expect_reference_on_random_states<double, 3>(1e-12);
  expect_reference_on_random_states<float, 3>(1e-4);
}
TEST(FastStep, OfThreeAxesAgreesWithTheReferenceOnWhatHasExpandedTenfold) {
  expect_reference_on_what_has_expanded<double, 3>(1e-12);
  expect_reference_on_what_has_expanded<float, 3>(1e-4);
}
TEST(FastStep, OfThreeAxesAgreesWithTheReferenceWhereParticlesStray) {
  expect_reference_on_eddies<double, 3>(1e-12);
  expect_reference_on_eddies<float, 3>(1e-4);
}

/// Layers of three materials, whose columns differ: aluminium, copper with a back stress, a neo-Hookean
/// solid.
struct Layers {
  mpm::MaterialModels models;
  mpm::State state;
};
Layers layers(const mpm::Scene& scene) {
  mpm::Material copper = mpm::named_material("copper"), rubber = scene.material;
  copper.hardening_modulus = 1e9, copper.kinematic_fraction = 0.4;
  rubber.law = mpm::MaterialLaw::neo_hookean;
  const mpm::ArtificialViscosity viscosity = mpm::build_material(scene).viscosity;
  Layers made{mpm::MaterialModels({{scene.material, viscosity}, {copper, viscosity}, {rubber, viscosity}}),
              random_state(scene, 0.13e-6)};
  mpm::Particles& ps = made.state.particles;
  ps.material_ends = {ps.size() / 3, ps.size() / 2, ps.size()};
  for (std::size_t m = 0; m < 3; ++m) {
    const auto [first, last] = ps.range_of(m);
    const double ratio = made.models.of[m].material.reference_density / scene.material.reference_density;
    for (std::size_t p = first; p < last; ++p) {
      EXPECT_EQ(ps.material_of(p), m);
      ps.mass[p] *= ratio;
    }
  }
  return made;
}

template <class Real>
void expect_reference_with_several_materials(double tolerance) {
  using Shape = typename FastStepper<Real>::Shape;
  const mpm::Scene scene = scenes::cavity(0.2e-6);
  Layers a = layers(scene);
  mpm::State b = a.state, threaded = a.state;
  const mpm::Energy before = mpm::energy_of(b.particles);
  FastStepper<Real> fast(a.models, Shape::bspline2), other(a.models, Shape::bspline2);
  for (int k = 0; k < 6; ++k) {
    const double dt = (3 + k) * 1e-12;
    const mpm::StepReport x = fast.step(a.state, dt);
    const mpm::StepReport y = mpm::reference_step<mpm::BSpline2>(b, a.models, dt);
    EXPECT_NEAR(x.largest_signal / y.largest_signal, 1, tolerance);
    EXPECT_NEAR(x.kinetic_energy / y.kinetic_energy, 1, tolerance);
    EXPECT_NEAR(x.overpressed_mass, y.overpressed_mass, tolerance * y.overpressed_mass);
    other.use_threads(2);
    other.step(threaded, dt);
  }
  fast.refresh_particles(a.state), other.refresh_particles(threaded);
  expect_same(a.state.particles, b.particles, tolerance);
  EXPECT_EQ(a.state.particles.pressure, threaded.particles.pressure);
  EXPECT_EQ(a.state.particles.position, threaded.particles.position);
  EXPECT_NEAR((mpm::energy_of(b.particles).total() - before.total()) / before.kinetic, 0, 1e-13);
  // each material has its own columns alone: aluminium has no back stress, and rubber no plastic strain
  const auto back = b.particles.own_values("back_stress"), plastic = b.particles.own_values("plastic_strain");
  const std::size_t copper = b.particles.range_of(1).first, rubber = b.particles.range_of(2).first;
  EXPECT_EQ(std::count(back.begin(), back.begin() + static_cast<std::ptrdiff_t>(3 * copper), 0.0),
            static_cast<std::ptrdiff_t>(3 * copper));
  EXPECT_GT(*std::max_element(back.begin(), back.end()), 0);
  EXPECT_EQ(*std::max_element(plastic.begin() + static_cast<std::ptrdiff_t>(rubber), plastic.end()), 0);
  EXPECT_GT(*std::max_element(plastic.begin(), plastic.end()), 0);
}
TEST(FastStep, AgreesWithTheReferenceWithSeveralMaterials) {
  expect_reference_with_several_materials<double>(1e-12);
  expect_reference_with_several_materials<float>(1e-4);
}

template <int axes>
void expect_energy_to_rounding() {
  for (const mpm::Scene& scene : variants<axes>()) {
    mpm::BasicState<axes> s = random_state<axes>(scene, 0);
    const mpm::Energy before = mpm::energy_of(s.particles);
    FastStepper<double, axes> fast = fast_stepper<double, axes>(scene);
    for (int k = 0; k < 4; ++k) fast.step(s, 2e-12);
    fast.refresh_particles(s);
    EXPECT_NEAR((mpm::energy_of(s.particles).total() - before.total()) / before.kinetic, 0, 1e-13);
  }
}
TEST(FastStep, KeepsEnergyToRounding) {
  expect_energy_to_rounding<2>();
  expect_energy_to_rounding<3>();
}

/// The AVX2 kernels round a*b + c once, the others twice; nothing else may differ. On the wall, and in
/// eddies, with five sorts.
template <int axes>
void expect_rounding_between_instruction_sets() {
  for (const mpm::Scene& scene : variants<axes>())
    for (mpm::BasicState<axes> a : {random_state<axes>(scene, 0), eddies<axes>(scene)}) {
      mpm::BasicState<axes> b = a;
      auto narrow = fast_stepper<double, axes>(scene, InstructionSet::baseline);
      auto wide = fast_stepper<double, axes>(scene, InstructionSet::avx2);
      for (int k = 0; k < 60; ++k) {
        const auto x = narrow.step(a, 1e-12), y = wide.step(b, 1e-12);
        ASSERT_NEAR(x.largest_signal / y.largest_signal, 1, 1e-11);
        ASSERT_NEAR(x.transfer_heat / y.transfer_heat, 1, 1e-11);
      }
      narrow.refresh_particles(a);
      wide.refresh_particles(b);
      expect_same(a.particles, b.particles, 1e-11);
    }
}
TEST(FastStep, InstructionSetsDifferByRoundingOnly) {
  if (!mpm::fast::supported(InstructionSet::avx2)) GTEST_SKIP() << "this processor has no AVX2";
  expect_rounding_between_instruction_sets<2>();
  expect_rounding_between_instruction_sets<3>();
}

/// Single particles and rows of nodes come out as the whole does.
TEST(FastStep, HandsOutWhatTheReferenceHolds) {
  const mpm::Scene scene = scenes::cavity(0.2e-6);
  mpm::State a = mpm::build_state(scene), b = mpm::build_state(scene);
  FastDouble fast = fast_stepper<double>(scene);
  for (int k = 0; k < 150; ++k) fast.step(a, 4e-12), reference(b, scene, 4e-12);
  const std::size_t which[] = {0, 7, a.particles.size() - 1};
  fast.refresh_particles(a, which);
  for (const std::size_t p : which)
    EXPECT_LT((a.particles.position[p] - b.particles.position[p]).norm(), 1e-12 * scene.block_height);
  fast.refresh_nodes(a, -1, 30);
  for (int j = -1; j <= std::min(30, b.grid.rows() - 2); ++j)
    for (int i = -1; i <= b.grid.columns() + 1; ++i) {
      EXPECT_NEAR(a.grid.at(i, j).mass, b.grid.at(i, j).mass, 1e-12 * b.grid.at(3, 3).mass);
      EXPECT_LT((a.grid.at(i, j).velocity - b.grid.at(i, j).velocity).norm(), 1e-9);
    }
}

TEST(FastStep, SaysThatAParticleLeftTheGrid) {
  const mpm::Scene scene = scenes::cavity(0.2e-6);
  for (const double speed : {-1e6, 1e6, std::nan("")}) {
    mpm::State s = mpm::build_state(scene);
    for (auto& v : s.particles.velocity) v.x() = speed;
    FastDouble fast = fast_stepper<double>(scene);
    double signal = 0;
    for (int k = 0; k < 4; ++k) signal = fast.step(s, 1e-11).largest_signal;
    EXPECT_FALSE(std::isfinite(signal)) << speed;
  }
}

}  // namespace
