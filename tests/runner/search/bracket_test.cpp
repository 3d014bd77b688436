// The search for a critical value, against made-up verdicts.
#include "runner/search/bracket.hpp"

#include <gmock/gmock.h>

#include <functional>
#include <stdexcept>

#include "runner/search/critical_value.hpp"

namespace mpmstudy {
namespace {

using Truth = std::function<Verdict(int)>;
Truth from(int critical) {
  return [critical](int i) { return i >= critical ? Verdict::above : Verdict::below; };
}

/// Runs the search to its end; how many values it tried.
int run(BracketSearch& search, const Truth& truth, int most) {
  int tried = 0;
  for (auto next = search.next(most); !next.empty(); next = search.next(most)) {
    for (const int i : next) search.tell(i, truth(i));
    tried += static_cast<int>(next.size());
    if (tried > 1000) break;
  }
  return tried;
}

TEST(SearchValues, StepsAreWithinTheToleranceAndEndsAreHit) {
  const SearchValues values(200, 2000, 10);
  EXPECT_EQ(values.intervals, 180);
  EXPECT_EQ(values.value(0), 200);
  EXPECT_EQ(values.value(180), 2000);
  EXPECT_EQ(values.value(1), 210);
  EXPECT_EQ(values.index(214), 1);
  EXPECT_EQ(values.index(1e9), 180);
  EXPECT_EQ(SearchValues(0, 1, 0.3).intervals, 4);
}

TEST(BracketSearch, FindsEveryCriticalValueWithAnyWidthOfRounds) {
  for (int critical = 1; critical <= 64; ++critical)
    for (const int most : {1, 2, 3, 8}) {
      BracketSearch search(64);
      EXPECT_LT(run(search, from(critical), most), 30);
      ASSERT_TRUE(search.bracket()) << critical << ' ' << most;
      EXPECT_EQ(search.bracket()->lower, critical - 1);
      EXPECT_EQ(search.bracket()->upper, critical);
      EXPECT_EQ(search.flags(SearchValues(0, 64, 1), "m/s"), "");
    }
}

TEST(BracketSearch, AGoodGuessTakesFewRunsAndABadOneIsLeft) {
  for (int guess = 0; guess <= 180; guess += 9)
    for (int critical = 1; critical <= 180; critical += 7) {
      BracketSearch search(180, Guess{guess, 2});
      const int tried = run(search, from(critical), 1);
      ASSERT_TRUE(search.bracket()) << guess << ' ' << critical;
      EXPECT_EQ(search.bracket()->upper, critical);
      EXPECT_LE(guess == critical ? tried : 0, 3);
      EXPECT_LE(std::abs(guess - critical) < 5 ? tried : 0, 7) << guess << ' ' << critical;
      EXPECT_LE(tried, 20);
    }
}

// Straight distances find the value in fewer runs; those that bend, as real ones do, cost none.
TEST(BracketSearch, DistancesFromTheOtherVerdictSaveRuns) {
  const auto runs = [](double slope_below, double slope_above) {
    int count = 0;
    for (int critical = 21; critical <= 60; ++critical) {
      BracketSearch search(180, Guess{20, 40});
      for (auto next = search.next(1); !next.empty(); next = search.next(1))
        for (const int i : next) {
          const double way = i - critical + 0.5;
          search.tell(i, from(critical)(i), way * (way < 0 ? slope_below : slope_above));
          ++count;
        }
      EXPECT_EQ(search.bracket()->upper, critical);
    }
    return count;
  };
  EXPECT_LT(runs(1, 1), 0.85 * runs(0, 0));
  EXPECT_LE(runs(0.1, 1), runs(0, 0));
  EXPECT_LE(runs(1, 0.1), runs(0, 0));
}

TEST(BracketSearch, NeverTriesAValueTwice) {
  BracketSearch search(100, Guess{30, 2});
  std::vector<int> tried;
  for (auto next = search.next(3); !next.empty(); next = search.next(3))
    for (const int i : next) {
      EXPECT_EQ(std::count(tried.begin(), tried.end(), i), 0) << i;
      tried.push_back(i);
      search.tell(i, from(77)(i));
    }
  EXPECT_EQ(search.bracket()->upper, 77);
}

TEST(BracketSearch, SaysWhereThereIsNoEnd) {
  BracketSearch low(20), high(20);
  run(low, from(0), 1);
  run(high, from(21), 1);
  EXPECT_FALSE(low.bracket());
  EXPECT_FALSE(high.bracket());
  EXPECT_EQ(low.flags(SearchValues(0, 20, 1), "m/s"), "no lower end");
  EXPECT_EQ(high.flags(SearchValues(0, 20, 1), "m/s"), "no upper end");
}

TEST(BracketSearch, FlagsWhatFlipsBackWhatFailedAndWhatIsUndecided) {
  const SearchValues values(0, 200, 10);
  BracketSearch flips(20);
  flips.tell(4, Verdict::below);
  flips.tell(5, Verdict::above);
  flips.tell(9, Verdict::below);
  EXPECT_EQ(flips.flags(values, "m/s"), "flips back at 90 m/s");
  EXPECT_EQ(flips.bracket()->upper, 5);

  BracketSearch broken(20);
  run(
      broken, [](int i) { return i == 10 ? Verdict::broken : from(12)(i); }, 1);
  EXPECT_EQ(broken.bracket()->lower, 11);
  EXPECT_EQ(broken.bracket()->upper, 12);
  EXPECT_EQ(broken.flags(values, "m/s"), "failed at 100 m/s");

  BracketSearch undecided(20);
  run(
      undecided, [](int i) { return i == 7 ? Verdict::undecided : from(8)(i); }, 3);
  EXPECT_EQ(undecided.flags(values, "m/s"), "lower end undecided");
}

TEST(SearchValues, RefusesMoreStepsThanAnySearchNeeds) {
  EXPECT_EQ(SearchValues(0, 100'000, 1).intervals, 100'000);
  EXPECT_THROW(SearchValues(200, 2000, 1e-6), std::invalid_argument);
  EXPECT_THROW(SearchValues(200, 2000, 1e-300), std::invalid_argument);
}

// Runs fail from one value on, or up to one: the critical value is looked for where they do not.
TEST(BracketSearch, TriesTheOtherEndWhereRunsFailAtOne) {
  for (const int most : {1, 2, 3})
    for (int critical = 5; critical < 175; critical += 10) {
      const auto fails_above = [&](int i) { return i > critical + 3 ? Verdict::broken : from(critical)(i); };
      const auto fails_below = [&](int i) { return i < critical - 3 ? Verdict::broken : from(critical)(i); };
      for (const Truth& truth : {Truth(fails_above), Truth(fails_below)}) {
        BracketSearch search(180), guessed(180, Guess{90, 4});
        EXPECT_LT(run(search, truth, most), 40);
        EXPECT_LT(run(guessed, truth, most), 40);
        for (const auto* one : {&search, &guessed}) {
          ASSERT_TRUE(one->bracket())
              << critical << ' ' << most << ' ' << one->flags(SearchValues(0, 180, 1), "m/s");
          EXPECT_EQ(one->bracket()->upper, critical);
          EXPECT_EQ(one->bracket()->lower, critical - 1);
        }
      }
    }
}

TEST(BracketSearch, EndsWhereRunsHaveNoVerdict) {
  BracketSearch none(100'000);
  EXPECT_LE(run(
                none, [](int) { return Verdict::broken; }, 1),
            9);
  EXPECT_THAT(none.flags(SearchValues(0, 100'000, 1), "m/s"),
              testing::StartsWith("no run has a verdict; failed at 0 m/s; "));
  BracketSearch low(100'000);  // what runs is below
  EXPECT_LE(run(
                low, [](int i) { return i > 12'345 ? Verdict::broken : Verdict::below; }, 1),
            40);
  EXPECT_THAT(low.flags(SearchValues(0, 100'000, 1), "m/s"), testing::StartsWith("no upper end; failed at "));
  BracketSearch gap(100'000);  // all that lies between the verdicts fails
  EXPECT_LE(run(
                gap,
                [](int i) {
                  return i < 30'000 ? Verdict::below : i > 60'000 ? Verdict::above : Verdict::broken;
                },
                1),
            60);
  ASSERT_TRUE(gap.bracket());
  EXPECT_LT(gap.bracket()->lower, 30'000);
  EXPECT_GT(gap.bracket()->upper, 60'000);
}

TEST(Extrapolate, IsExactForFirstOrderAndCoversTheWayAndTheWidths) {
  const CellBracket cells[] = {{0.4, 535, 545}, {0.2, 515, 525}, {0.1, 505, 515}};  // 500 + 100 h
  const auto e = critical_value_at_cell_0(cells);
  ASSERT_TRUE(e);
  EXPECT_NEAR(e->value, 500, 1e-9);
  EXPECT_NEAR(e->interval, 10 + 15, 1e-9);  // the way, and 5 * 2 + 5 * 1
  EXPECT_FALSE(critical_value_at_cell_0(std::span(cells, 1)));
  // The last step is small after a large one: half of that one stays in doubt.
  const CellBracket sudden[] = {{0.4, 700, 700}, {0.2, 500, 500}, {0.1, 490, 490}};
  EXPECT_NEAR(critical_value_at_cell_0(sudden)->value, 480, 1e-9);
  EXPECT_NEAR(critical_value_at_cell_0(sudden)->interval, 100, 1e-9);
  // Cells that do not come closer: the finest, and the last difference is in doubt.
  const CellBracket wild[] = {{0.4, 500, 500}, {0.2, 510, 510}, {0.1, 540, 540}};
  EXPECT_NEAR(critical_value_at_cell_0(wild)->value, 540, 1e-9);
  EXPECT_NEAR(critical_value_at_cell_0(wild)->interval, 30, 1e-9);
  // Cells that turn: the finest, and all that they differ by.
  const CellBracket turning[] = {{0.4, 500, 500}, {0.2, 450, 450}, {0.1, 480, 480}};
  EXPECT_NEAR(critical_value_at_cell_0(turning)->value, 480, 1e-9);
  EXPECT_NEAR(critical_value_at_cell_0(turning)->interval, 50, 1e-9);
}

}  // namespace
}  // namespace mpmstudy
