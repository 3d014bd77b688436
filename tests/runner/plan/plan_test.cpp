#include "runner/plan/plan.hpp"

#include <gtest/gtest.h>

#include <chrono>
#include <cstdio>

#include "tests/runner/study/study_text.hpp"

namespace mpmstudy {
namespace {

TEST(Plan, EqualKeysOnlyOnce) {
  const Study study = read_text(study_text({{"cavity_radius", "[\"1 um\", \"2 um\", \"1000 nm\"]"}}));
  EXPECT_EQ(study.scenes.size(), 3u);
  const Plan plan = make_plan(study, 1e6);
  ASSERT_EQ(plan.jobs.size(), 2u);
  EXPECT_EQ(plan.jobs[0].scene.cavity_radius, 1e-6);
  EXPECT_EQ(plan.jobs[1].scene.cavity_radius, 2e-6);
}

TEST(Plan, PredictsFromParticlesAndSteps) {
  const Plan plan = make_plan(read_text(study_text()), 1e6);
  const Job& job = plan.jobs.at(0);
  EXPECT_GT(job.estimate.particles, 0);
  EXPECT_GT(job.estimate.steps, 0);
  const double updates =
      static_cast<double>(job.estimate.particles) * static_cast<double>(job.estimate.steps);
  EXPECT_DOUBLE_EQ(job.predicted_seconds, updates / 1e6);
}

TEST(Plan, WallTimeIsOfTheLongestJobFirst) {
  Plan plan;
  plan.jobs.resize(3);
  plan.jobs[0].predicted_seconds = 1;
  plan.jobs[1].predicted_seconds = 3;
  plan.jobs[2].predicted_seconds = 2;
  EXPECT_EQ(cpu_seconds(plan.jobs), 6);
  EXPECT_EQ(wall_seconds(plan.jobs, 1), 6);
  EXPECT_EQ(wall_seconds(plan.jobs, 2), 3);
  EXPECT_EQ(wall_seconds(plan.jobs, 8), 3);
  EXPECT_EQ(wall_seconds({}, 2), 0);
}

TEST(Plan, AHundredThousandJobs) {
  const std::string text =
      study_text({{"impact_speed", "{ from = 100, to = 300, count = 100, unit = \"m/s\" }"},
                  {"cavity_radius", "{ from = 1, to = 2, count = 100, unit = \"um\" }"},
                  {"yield_stress", "{ from = 60, to = 400, count = 10, unit = \"MPa\" }"}});
  const auto start = std::chrono::steady_clock::now();
  const Plan plan = make_plan(read_text(text));
  const std::chrono::duration<double> elapsed = std::chrono::steady_clock::now() - start;
  EXPECT_EQ(plan.jobs.size(), 100'000u);
  std::printf("100000 jobs read, checked and planned in %.2f s\n", elapsed.count());
}

}  // namespace
}  // namespace mpmstudy
