#include "libmpm/core/thread_team.hpp"

#include <gtest/gtest.h>

#include <vector>

namespace {

/// How often each part was done.
std::vector<int> counts_of(mpm::ThreadTeam& team, std::size_t parts) {
  std::vector<int> counts(parts, 0);
  team.run(parts, [&](std::size_t k) { ++counts[k]; });
  return counts;
}

TEST(ThreadTeam, DoesEachPartOnce) {
  mpm::ThreadTeam team;
  for (const int threads : {1, 3, 2, 5, 1})
    for (const std::size_t parts : {0, 1, 2, 1000}) {
      team.resize(threads);
      EXPECT_EQ(team.size(), threads);
      EXPECT_EQ(counts_of(team, parts), std::vector<int>(parts, 1));
    }
}

TEST(ThreadTeam, DoesManySmallPiecesOfWorkOneAfterTheOther) {
  mpm::ThreadTeam team;
  team.resize(3);
  std::vector<int> values(7, 0);
  for (int round = 0; round < 5000; ++round)
    team.run(values.size(), [&](std::size_t k) { values[k] += round; });
  EXPECT_EQ(values, std::vector<int>(7, 5000 * 4999 / 2));
}

TEST(ThreadTeam, ThreadsWorkSideBySide) {
  mpm::ThreadTeam team;
  team.resize(2);
  // each of the two parts ends only when the other has begun
  std::atomic<int> begun{0};
  std::vector<std::thread::id> by(2);
  team.run(2, [&](std::size_t k) {
    by[k] = std::this_thread::get_id();
    for (++begun; begun < 2;) std::this_thread::yield();
  });
  EXPECT_NE(by[0], by[1]);
}

TEST(ThreadTeam, ZeroThreadsAreOne) {
  mpm::ThreadTeam team;
  team.resize(0);
  EXPECT_EQ(team.size(), 1);
}

}  // namespace
