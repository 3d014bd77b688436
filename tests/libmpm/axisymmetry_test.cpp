// Axial symmetry: what a step must keep there, and what it must share with plane strain.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <type_traits>
#include <vector>

#include "libmpm/measure/contour.hpp"
#include "libmpm/measure/energy.hpp"
#include "libmpm/measure/void_area.hpp"
#include "libmpm/scene/build.hpp"
#include "libmpm/scene/dispatch.hpp"
#include "libmpm/shape/bspline2.hpp"
#include "libmpm/shape/gimp.hpp"
#include "libmpm/step/apic.hpp"
#include "libmpm/step/flip_pic.hpp"
#include "libmpm/step/step.hpp"
#include "tests/libmpm/random_state.hpp"
#include "tests/libmpm/scenes.hpp"

namespace {

using mpm::Vec2;
using Axial = mpm::space::Axisymmetric;

mpm::Scene axisymmetric(mpm::Scene s) {
  s.space = mpm::Space::axisymmetric;
  return s;
}

template <class Shape>
class AxisymmetricStep : public testing::Test {};
using Shapes = testing::Types<mpm::Gimp, mpm::BSpline2>;
TYPED_TEST_SUITE(AxisymmetricStep, Shapes);

// Each term alone is as large as the scale below; together they are nothing, on the axis as elsewhere. Not at
// the surface, where a pressure does drive the material.
TYPED_TEST(AxisymmetricStep, AUniformPressureMakesNoForce) {
  const bool gimp = std::is_same_v<TypeParam, mpm::Gimp>;
  for (const int per_edge : gimp ? std::vector{1, 2, 3, 4} : std::vector{2, 4}) {
    mpm::State s =
        mpm::empty_state({0, 0}, {0.1e-6, 0.1e-6}, 12, mpm::Floor::mirror, mpm::Space::axisymmetric);
    const mpm::Body body{mpm::everywhere(), [](const Vec2&) { return Vec2(0, 0); }};
    mpm::fill_rows(s, body, 2700, per_edge, 0, 12);
    std::ranges::fill(s.particles.pressure, 1e9);
    s.grid.grow_to_row(14);
    s.grid.clear();
    mpm::p2g<TypeParam, mpm::Flip, Axial>(s.particles, s.grid);
    mpm::reflect_sides(s.grid, 14);
    mpm::reflect_floor(s.grid);
    const double scale = 1e9 * 0.1e-6 * 1e-6;  // pressure times the face of a cell at the rim, per radian
    for (int j = 1; j < 10; ++j)
      for (int i = 0; i < 12; ++i)
        EXPECT_LT(s.grid.at(i, j).acceleration.norm(), 1e-13 * scale) << i << ", " << j << ", " << per_edge;
  }
}

TYPED_TEST(AxisymmetricStep, KeepsEnergyToRoundingWhateverTheState) {
  const mpm::Scene scene = axisymmetric(scenes::cavity(0.2e-6));
  const mpm::MaterialModel material = mpm::build_material(scene);
  const auto change = [&]<class Transfer>(const Transfer& transfer) {
    mpm::State s = random_state(scene, 1e-6);
    const mpm::Energy before = mpm::energy_of(s.particles);
    mpm::reference_step<TypeParam, Transfer, Axial>(s, material, 2e-12, transfer);
    return (mpm::energy_of(s.particles).total() - before.total()) / before.kinetic;
  };
  EXPECT_NEAR(change(mpm::Flip{}), 0, 1e-13);
  EXPECT_NEAR(change(mpm::FlipPic{0.05}), 0, 1e-13);
  EXPECT_NEAR(change(mpm::Apic{}), 0, 1e-13);
}

// v_r = -k r strains every ring alike. A node has the mean velocity of the mass around it, which lies farther
// out than the node by s^2 / r, s^2 the variance of the shape function: second order.
TYPED_TEST(AxisymmetricStep, ALinearMotionHasItsRates) {
  const mpm::Scene scene = axisymmetric(scenes::cavity(0.2e-6));
  mpm::State s = mpm::build_state(scene);
  for (std::size_t p = 0; p < s.particles.size(); ++p) {
    const Vec2& x = s.particles.position[p];
    s.particles.velocity[p] = Vec2(-3e7 * x.x(), 0);
  }
  const mpm::Particles before = s.particles;
  mpm::reference_step<TypeParam, mpm::Flip, Axial>(s, mpm::build_material(scene), 1e-15);
  int seen = 0;
  for (std::size_t p = 0; p < s.particles.size(); ++p) {
    const Vec2& x = before.position[p];
    // away from mirror, cavity and free surface, where the grid knows the motion
    if (x.x() > 4e-6 || x.y() < 0.6e-6 || x.y() > 4.4e-6 || (x - Vec2(0, 1.9e-6)).norm() < 2.2e-6) continue;
    ++seen;
    const double ratio = 0.2e-6 / x.x(), allowed = 0.5 * ratio * ratio;
    EXPECT_NEAR(s.hoop_rate[p] / -3e7, 1, allowed);
    EXPECT_NEAR(s.particles.dilation[p] / (-2 * 3e7 * 1e-15), 1, allowed);
  }
  EXPECT_GT(seen, 200);
}

// The force of a particle on a node may not outlive its mass there: hoop weights vanish with those of the
// mass, as fast as slopes do. Otherwise torn material is thrown about at the axis.
TYPED_TEST(AxisymmetricStep, HoopWeightsVanishWithTheMass) {
  const double moment_error =
      std::is_same_v<TypeParam, mpm::Gimp> ? 0.1 : 1e-14;  // GIMP's domain is wider than its hats
  for (const double half : {0.125, 0.25})
    for (double xi = 4.5001; xi < 5.5; xi += 0.0007) {
      const auto w = TypeParam::evaluate(xi, half);
      const auto hoop = TypeParam::hoop(xi, half);
      EXPECT_NEAR(hoop[0] + hoop[1] + hoop[2], 1, 1e-15);
      EXPECT_NEAR(w.first * hoop[0] + (w.first + 1) * hoop[1] + (w.first + 2) * hoop[2], xi, moment_error);
      for (int i = 0; i < 3; ++i)
        EXPECT_LE(hoop[i] * hoop[i], 1.2 * w.value[i]) << xi << ", " << half << ", " << i;
    }
}

TEST(Axisymmetric, MassIsThatOfTheBodyOfRevolution) {
  const mpm::Scene s = axisymmetric(scenes::cavity(0.1e-6));
  const mpm::State state = mpm::build_state(s);
  double mass = 0;
  for (const double m : state.particles.mass) mass += m;
  const double r = s.block_width / 2, cylinder = std::numbers::pi * r * r * s.block_height;
  const double sphere = 4.0 / 3 * std::numbers::pi * std::pow(s.cavity_radius, 3);
  EXPECT_NEAR(2 * std::numbers::pi * mass / (s.material.reference_density * (cylinder - sphere)), 1, 2e-5);
}

TEST(Axisymmetric, ASphereHasItsVolumeByContourAndByVoid) {
  const mpm::Scene s = axisymmetric(scenes::cavity(0.1e-6));
  const mpm::State state = mpm::build_state(s);
  const double exact = 4.0 / 3 * std::numbers::pi * std::pow(s.cavity_radius, 3);
  mpm::Contour contour(Vec2(0, s.cavity_center_height), s.cavity_radius, s.numerics.cell_size, true);
  EXPECT_NEAR(contour.volume() / exact, 1, 2e-4);
  mpm::VoidArea hole(Vec2(0, s.cavity_center_height), s.cavity_radius, false, s.numerics.particles_per_cell);
  hole.update(state);
  EXPECT_NEAR(hole.volume() / exact, 1, 2e-3);
}

// The size of a particle in a picture is sqrt(mass / density): of the section, at any radius.
TEST(Axisymmetric, SnapshotsHaveTheMassOfTheSection) {
  struct Keep : mpm::Observer {
    mpm::Snapshot last;
    void on_snapshot(const mpm::Snapshot& s) override { last = s; }
  } keep;
  mpm::Scene s = axisymmetric(scenes::cavity(0.2e-6));
  s.end_time = 0.05e-9;
  s.measures.snapshots = {0};
  ASSERT_EQ(mpm::run(s, keep).status, mpm::RunStatus::done);
  double area = 0;
  for (std::size_t p = 0; p < keep.last.mass.size(); ++p) area += keep.last.mass[p] / keep.last.density[p];
  const double exact =
      s.block_width / 2 * s.block_height - std::numbers::pi / 2 * s.cavity_radius * s.cavity_radius;
  EXPECT_NEAR(area / exact, 1, 1e-3);
}

// The motion along the axis does not know of the radius: the shock of plane strain, to rounding.
TEST(Axisymmetric, APlanarShockIsThatOfPlaneStrain) {
  for (const auto scheme : {mpm::ShapeFunction::gimp, mpm::ShapeFunction::bspline2}) {
    mpm::Scene s = scenes::planar(200, 5e-6, 0.1e-6, 1.2e-9);
    s.numerics.scheme = scheme;
    if (scheme == mpm::ShapeFunction::bspline2) s.numerics.particles_per_cell = 4;
    const mpm::RunResult plane = mpm::run(s), axial = mpm::run(axisymmetric(s));
    ASSERT_EQ(axial.status, mpm::RunStatus::done) << axial.reason;
    EXPECT_EQ(axial.steps, plane.steps);
    for (const char* name : {"shock_normal_stress_Pa", "shock_pressure_Pa", "shock_von_mises_Pa"})
      EXPECT_NEAR(scenes::metric(axial, name) / scenes::metric(plane, name), 1, 1e-10) << name;
    EXPECT_LT(axial.energy_error, 1e-12);
    EXPECT_LT(scenes::metric(axial, "momentum_error"), 1e-12);
  }
}

TEST(Axisymmetric, TheFastStepRunsWhatTheReferenceRuns) {
  mpm::Scene s = axisymmetric(scenes::cavity(0.2e-6));
  s.end_time = 0.5e-9;
  const mpm::RunResult fast = mpm::run(s);
  s.numerics.kernel = mpm::Kernel::reference;
  const mpm::RunResult plain = mpm::run(s);
  ASSERT_EQ(fast.status, mpm::RunStatus::done) << fast.reason;
  EXPECT_EQ(fast.steps, plain.steps);
  EXPECT_NEAR(*fast.collapsibility, *plain.collapsibility, 1e-9);
  EXPECT_LT(fast.energy_error, 1e-12);
  EXPECT_LT(plain.energy_error, 1e-12);
  ASSERT_NE(fast.find("final_volume_m3"), nullptr);
  EXPECT_NEAR(1 - scenes::metric(fast, "final_volume_m3") / scenes::metric(fast, "initial_volume_m3"),
              *fast.collapsibility, 1e-12);
}

TEST(Axisymmetric, LengthsATimesLargerGiveTheSameBits) {
  mpm::Scene s = axisymmetric(scenes::cavity(0.2e-6)), large = s;
  s.end_time = 0.3e-9, large.end_time = 0.3e-9;
  for (double* v :
       {&large.block_width, &large.block_height, &large.cavity_radius, &large.cavity_center_height,
        &large.end_time, &large.numerics.cell_size, &large.measures.area_every})
    *v *= 1024;
  const mpm::RunResult a = mpm::run(s), b = mpm::run(large);
  EXPECT_EQ(a.steps, b.steps);
  EXPECT_EQ(*a.collapsibility, *b.collapsibility);
}

TEST(Axisymmetric, RefusesWhatItDoesNotHave) {
  mpm::Scene s = axisymmetric(scenes::cavity(0.2e-6));
  EXPECT_TRUE(mpm::find_problems(s).empty());
  s.numerics.symmetry = mpm::Symmetry::full;
  ASSERT_EQ(mpm::find_problems(s).size(), 1u);
  EXPECT_EQ(mpm::find_problems(s)[0].parameter, "symmetry");
  s.numerics.symmetry = mpm::Symmetry::half;
  s.numerics.particles_per_cell = 9;
  ASSERT_EQ(mpm::find_problems(s).size(), 1u);
  EXPECT_EQ(mpm::find_problems(s)[0].parameter, "particles_per_cell");
  s.numerics.particles_per_cell = 4;
  s.numerics.scheme = mpm::ShapeFunction::cpdi;
  s.numerics.kernel = mpm::Kernel::reference;
  ASSERT_EQ(mpm::find_problems(s).size(), 1u);
  EXPECT_EQ(mpm::find_problems(s)[0].parameter, "scheme");
}

}  // namespace
