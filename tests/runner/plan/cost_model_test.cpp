// What jobs will cost: is a made-up law found again, does the interval hold as often as it says, and is there
// no interval where nothing is known?
#include "runner/plan/cost_model.hpp"

#include <gmock/gmock.h>

#include <cmath>
#include <random>

namespace mpmstudy {
namespace {

using testing::DoubleNear;

// Jobs in three dimensions cost more for each update: as a guess, and learnt from others.
TEST(CostModel, KnowsThatUpdatesOfOtherKernelsAndSpacesCostMore) {
  const mpm::Estimate fast{1000, 1000}, slow{1000, 1000, 20};
  const CostModel guess;
  EXPECT_NEAR(guess.seconds(slow) / guess.seconds(fast), 20, 1e-12);
  CostSample seen{1000, 1000, 4, "a"};
  seen.update_cost = 20;
  const CostModel learnt(std::vector<CostSample>{seen, seen, seen});
  EXPECT_NEAR(learnt.seconds(slow), 4, 1e-9);
  EXPECT_NEAR(learnt.seconds(fast), 0.2, 1e-9);
}

/// A host on which larger jobs are slower for each update, studies differ by 30 % and jobs by 10 %.
class Host {
 public:
  explicit Host(unsigned seed) : random_(seed) {}
  double study() { return 0.3 * normal_(random_); }
  CostSample job(double study, const std::string& name) {
    CostSample sample;
    sample.particles = std::exp(uniform(std::log(1e3), std::log(1e5)));
    sample.steps = sample.particles / 10 * uniform(0.5, 2);
    sample.cpu_s = sample.particles * sample.steps / 5e6 * std::pow(sample.particles / 1e4, 0.1) *
                   std::exp(study + 0.1 * normal_(random_));
    sample.study = name;
    return sample;
  }
  std::vector<CostSample> catalog(int studies, int jobs) {
    std::vector<CostSample> samples;
    for (int s = 0; s < studies; ++s) {
      const double factor = study();
      for (int j = 0; j < jobs; ++j) samples.push_back(job(factor, std::to_string(s)));
    }
    return samples;
  }

 private:
  double uniform(double a, double b) { return std::uniform_real_distribution<double>(a, b)(random_); }
  std::mt19937 random_;
  std::normal_distribution<double> normal_;
};

std::vector<mpm::Estimate> estimates_of(const std::vector<CostSample>& samples) {
  std::vector<mpm::Estimate> estimates;
  for (const auto& s : samples)
    estimates.push_back({static_cast<std::int64_t>(s.particles), static_cast<std::int64_t>(s.steps)});
  return estimates;
}

double cost_of(const std::vector<CostSample>& samples) {
  double sum = 0;
  for (const auto& s : samples) sum += s.cpu_s;
  return sum;
}

TEST(CostModel, without_jobs_is_a_guess_without_an_interval) {
  const CostModel model(std::span<const CostSample>{});
  EXPECT_EQ(model.learnt_from(), 0u);
  const mpm::Estimate one[] = {{1000, 5000}};
  EXPECT_NEAR(model.total(one).seconds, 5e6 / assumed_updates_per_second, 1e-12);
  EXPECT_FALSE(model.total(one).interval);
}

TEST(CostModel, one_job_gives_its_rate_and_no_interval) {
  const CostSample sample[] = {{1000, 1000, 2, "a"}};
  const CostModel model(sample);
  EXPECT_NEAR(model.seconds({2000, 500}), 2, 1e-12);
  const mpm::Estimate one[] = {{2000, 500}};
  EXPECT_FALSE(model.total(one).interval);
}

TEST(CostModel, jobs_of_one_size_cost_what_they_cost_before) {
  std::vector<CostSample> samples(10, {1000, 1000, 2, "a"});
  const CostModel model(samples);
  EXPECT_NEAR(model.seconds({1000, 1000}), 2, 1e-9);
  EXPECT_NEAR(model.seconds({4000, 1000}), 8, 0.1) << "nothing says that larger jobs differ";
}

TEST(CostModel, learns_how_the_rate_depends_on_the_size) {
  Host host(1);
  const CostModel model(host.catalog(40, 25));
  for (const double particles : {2e3, 2e4, 8e4}) {
    const mpm::Estimate e{static_cast<std::int64_t>(particles), static_cast<std::int64_t>(particles / 10)};
    EXPECT_THAT(std::log(model.seconds(e) * 5e6 / (particles * particles / 10)),
                DoubleNear(0.1 * std::log(particles / 1e4), 0.15));
  }
}

// 400 catalogs of their own, each with a new study to predict.
TEST(CostModel, the_interval_holds_nineteen_times_out_of_twenty) {
  for (const int studies : {5, 15}) {
    int held = 0;
    constexpr int catalogs = 400;
    double widest = 0;
    for (int i = 0; i < catalogs; ++i) {
      Host host(static_cast<unsigned>(100 + i));
      const CostModel model(host.catalog(studies, 20));
      const double factor = host.study();
      std::vector<CostSample> next;
      for (int j = 0; j < 12; ++j) next.push_back(host.job(factor, "next"));
      const auto interval = model.total(estimates_of(next)).interval;
      ASSERT_TRUE(interval);
      held += interval->low <= cost_of(next) && cost_of(next) <= interval->high;
      widest = std::max(widest, interval->high / interval->low);
    }
    EXPECT_GE(held, 0.92 * catalogs) << studies;
    EXPECT_LE(held, 0.99 * catalogs) << studies << ": wider than it says";
  }
}

TEST(CostModel, many_jobs_of_a_study_are_known_better_than_one) {
  Host host(3);
  const CostModel model(host.catalog(3, 30));
  const mpm::Estimate one[] = {{10'000, 1000}};
  const std::vector<mpm::Estimate> many(50, one[0]);
  const CostModel apart(host.catalog(20, 30));
  const auto width = [](const Prediction& p) { return p.interval->high / p.interval->low; };
  EXPECT_DOUBLE_EQ(width(model.total(one)), width(model.total(many))) << "three studies tell nothing apart";
  EXPECT_LT(width(apart.total(many)), width(apart.total(one)));
}

}  // namespace
}  // namespace mpmstudy
