#pragma once
#include <gtest/gtest.h>

#include "libmpm/simulation.hpp"

/// That a run which is stopped after `step` steps, and goes on from its checkpoint on two threads, ends with
/// the bits of one that was not.
inline void expect_same_from_a_checkpoint(const mpm::Scene& s, std::int64_t step) {
  struct Keeper : mpm::Observer {
    explicit Keeper(std::int64_t at) : last(at) {}
    bool on_step(const mpm::Progress& p) override { return p.step != last; }
    bool wants_checkpoint() override { return true; }
    void on_checkpoint(const mpm::Record& r) override { record = r; }
    std::int64_t last;
    mpm::Record record;
  } keeper(step);
  struct Resumer : mpm::Observer {
    explicit Resumer(mpm::Record& r) : record(r) {}
    mpm::Record* resume_from() override { return &record; }
    int threads() override { return 2; }
    mpm::Record& record;
  } resumer(keeper.record);
  const mpm::RunResult whole = mpm::run(s);
  mpm::run(s, keeper);
  const mpm::RunResult resumed = mpm::run(s, resumer);
  ASSERT_GT(whole.steps, step);
  ASSERT_EQ(whole.metrics.size(), resumed.metrics.size());
  for (std::size_t k = 0; k < whole.metrics.size(); ++k)
    EXPECT_EQ(whole.metrics[k].value, resumed.metrics[k].value) << whole.metrics[k].name;
  for (std::size_t k = 0; k < whole.histories.size(); ++k)
    EXPECT_EQ(whole.histories[k].values, resumed.histories[k].values) << whole.histories[k].name;
}
