// Jobs dealt out to the elements of an array: each once, evenly by predicted time, as few shards as asked.
#include "runner/slurm/shards.hpp"

#include <gmock/gmock.h>

#include <algorithm>
#include <set>

namespace mpmstudy {
namespace {

class Shards : public testing::Test {
 protected:
  std::vector<Shard> deal(const std::vector<double>& costs, double seconds, int workers, std::size_t most) {
    jobs.clear();
    for (const double cost : costs) {
      Job job;
      job.key = std::to_string(jobs.size());
      job.predicted_seconds = cost;
      jobs.push_back(job);
    }
    std::vector<const Job*> pointers;
    for (const Job& job : jobs) pointers.push_back(&job);
    return make_shards(pointers, seconds, workers, most);
  }
  std::vector<Job> jobs;
};

TEST_F(Shards, hold_every_job_once) {
  std::multiset<const Job*> dealt;
  for (const Shard& shard : deal({5, 1, 3, 2, 8, 1, 1, 0, 0}, 4, 1, 100))
    dealt.insert(shard.jobs.begin(), shard.jobs.end());
  EXPECT_EQ(dealt.size(), 9u);
  EXPECT_EQ(std::set<const Job*>(dealt.begin(), dealt.end()).size(), 9u);
}

TEST_F(Shards, are_as_few_as_their_time_asks_for) {
  const std::vector<double> costs(12, 10.0);
  EXPECT_EQ(deal(costs, 30, 1, 100).size(), 4u);
  EXPECT_EQ(deal(costs, 30, 2, 100).size(), 2u) << "two threads do twice as much";
  EXPECT_EQ(deal(costs, 1e6, 1, 100).size(), 1u);
  EXPECT_EQ(deal(costs, 30, 1, 3).size(), 3u) << "no more than allowed";
  EXPECT_EQ(deal(costs, 0.1, 1, 100).size(), 12u) << "none is empty";
}

TEST_F(Shards, are_even_and_longest_first) {
  for (const Shard& shard : deal({1, 2, 3, 4, 5, 6, 7, 8}, 12, 1, 3)) {
    EXPECT_NEAR(shard.seconds, 12, 1.001);
    EXPECT_TRUE(std::ranges::is_sorted(shard.jobs, std::ranges::greater{}, &Job::predicted_seconds));
  }
}

TEST_F(Shards, of_nothing_are_none) { EXPECT_TRUE(deal({}, 10, 1, 10).empty()); }

}  // namespace
}  // namespace mpmstudy
