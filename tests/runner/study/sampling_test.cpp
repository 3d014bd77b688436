#include "runner/study/sampling.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

namespace mpmstudy {
namespace {

/// First numbers of the published generator for the seed 1234567.
TEST(SplitMix64, IsThePublishedGenerator) {
  SplitMix64 random(1234567);
  EXPECT_EQ(random.next(), 6457827717110365317u);
  EXPECT_EQ(random.next(), 3203168211198807973u);
  EXPECT_EQ(random.next(), 9817491932198370423u);
}

TEST(SplitMix64, BelowStaysBelowAndReachesAll) {
  SplitMix64 random(1);
  std::vector<int> hits(7);
  for (int i = 0; i < 7000; ++i) ++hits.at(random.below(7));
  EXPECT_GT(*std::min_element(hits.begin(), hits.end()), 850);
}

TEST(RandomSamples, ALargerStudyBeginsWithASmallerOne) {
  const auto small = random_samples(5, 3, 42), large = random_samples(9, 3, 42);
  for (std::size_t i = 0; i < small.size(); ++i) EXPECT_EQ(small[i], large[i]);
  EXPECT_NE(random_samples(5, 3, 43), small);
}

TEST(LatinHypercube, HitsEveryStratumOnce) {
  constexpr std::uint64_t n = 50;
  const auto samples = latin_hypercube(n, 3, 7);
  ASSERT_EQ(samples.size(), n);
  for (std::size_t axis = 0; axis < 3; ++axis) {
    std::vector<int> hits(n);
    for (const auto& sample : samples) ++hits.at(static_cast<std::size_t>(std::floor(sample[axis] * n)));
    EXPECT_EQ(hits, std::vector<int>(n, 1)) << axis;
  }
  EXPECT_EQ(latin_hypercube(n, 3, 7), samples);
}

}  // namespace
}  // namespace mpmstudy
