// Three ways to say one scene, while nothing pulls: a block on a wall, two blocks that meet, and the same two
// seen by an observer who moves.
#include <gtest/gtest.h>

#include "libmpm/verification/problems/problems.hpp"
#include "tests/verification/expect_numbers.hpp"

namespace {

// To rounding the mirror is the other body, before anything is in tension. The wall takes the approach of
// what touches it, which two bodies in one grid keep in their first particles: the difference stays there.
TEST(TwoBodies, AreTheBlockOnAMirrorAndOnTheWallAwayFromIt) {
  expect_all_hold(mpm::verification::wall_and_two_bodies_numbers({}));
}

// The grid stands still, so a body that drifts through it crosses cells: the same to its quadrature error.
TEST(TwoBodies, LookTheSameToAMovingObserver) {
  expect_all_hold(mpm::verification::moving_frame_numbers({}));
}

}  // namespace
