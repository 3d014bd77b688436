// The gap between a body and the impact wall that it has left: boundary/impact_wall.hpp.
#include <gtest/gtest.h>

#include "libmpm/scene/build.hpp"
#include "libmpm/scene/dispatch.hpp"
#include "libmpm/scene/effect.hpp"
#include "tests/libmpm/scenes.hpp"

namespace {

using mpm::WallGap;

mpm::Scene block(WallGap gap, mpm::Kernel kernel) {
  mpm::Scene s = scenes::planar(50, 10e-6, 1e-6, 1e-9);
  s.numerics.kernel = kernel;
  s.numerics.wall_gap = gap;
  return s;
}

/// A block rises off the wall for so many steps, 0.3 cells in all, and comes back: steps until it is pushed.
template <int axes>
int steps_until_push(const mpm::Scene& scene, int up) {
  auto state = mpm::build_state<axes>(scene);
  const double speed = scene.impact_speed, dt = 0.3 * scene.numerics.cell_size / (speed * up);
  const auto stepper = mpm::stepper_for<axes>(scene);
  double momentum = 0;
  for (std::size_t p = 0; p < state.particles.size(); ++p) {
    state.particles.velocity[p].y() = speed;
    momentum += state.particles.mass[p] * speed;
  }
  const auto pushed = [&](auto& by) { return by.step(state, dt).wall_impulse.y() > 1e-6 * momentum; };
  for (int k = 0; k < up; ++k) EXPECT_FALSE(pushed(*stepper));
  // a stepper reads the particles when it begins
  stepper->refresh_particles(state);
  for (auto& v : state.particles.velocity) v.y() = -speed;
  const auto back = mpm::stepper_for<axes>(scene);
  for (int k = 1; k < 2 * up; ++k)
    if (pushed(*back)) return k;
  return -1;
}

TEST(WallGap, ABodyThatComesBackIsPushedWhenItHasClosedTheGap) {
  constexpr int up = 400;  // steps of a tenth of the stability limit
  for (const auto kernel : {mpm::Kernel::fast, mpm::Kernel::reference}) {
    EXPECT_EQ(steps_until_push<2>(block(WallGap::unseen, kernel), up), 1);
    EXPECT_NEAR(steps_until_push<2>(block(WallGap::tracked, kernel), up), up, 1);
    for (const WallGap gap : {WallGap::unseen, WallGap::tracked}) {
      mpm::Scene solid = scenes::in_space(mpm::Space::three_d, block(gap, kernel));
      solid.numerics.kernel = kernel;
      solid.numerics.wall_gap = gap;
      EXPECT_NEAR(steps_until_push<3>(solid, up), gap == WallGap::tracked ? up : 1, 1);
    }
  }
}

/// The block of a weak collapse parts from the wall column by column, and is back before the end.
mpm::Scene collapse(mpm::Kernel kernel) {
  mpm::Scene s = scenes::cavity(0.3e-6);
  s.end_time = 4e-9;
  s.numerics.kernel = kernel;
  s.numerics.wall_gap = WallGap::tracked;
  return s;
}

TEST(WallGap, FastAndReferenceStepAgree) {
  for (const auto space : {mpm::Space::plane_strain, mpm::Space::axisymmetric}) {
    mpm::Scene fast = collapse(mpm::Kernel::fast), reference = collapse(mpm::Kernel::reference);
    fast.space = reference.space = space;
    const mpm::RunResult a = mpm::run(fast), b = mpm::run(reference);
    ASSERT_EQ(a.steps, b.steps);
    EXPECT_NEAR(*a.collapsibility, *b.collapsibility, 1e-9);
    EXPECT_LT(a.energy_error, 1e-12);
    EXPECT_LT(scenes::metric(a, "momentum_error"), 1e-12);
    fast.numerics.wall_gap = WallGap::unseen;
    EXPECT_GT(std::abs(*mpm::run(fast).collapsibility - *a.collapsibility), 1e-4);
  }
}

TEST(WallGap, HasNoEffectWithoutAWall) {
  const mpm::Condition* condition = mpm::condition_of("wall_gap");
  ASSERT_NE(condition, nullptr);
  EXPECT_TRUE(condition->holds(collapse(mpm::Kernel::fast)));
  EXPECT_FALSE(condition->holds(scenes::shell(185, 0.2e-6)));
}

}  // namespace
