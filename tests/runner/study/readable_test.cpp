#include "runner/study/readable.hpp"

#include <gtest/gtest.h>

namespace mpmstudy {
namespace {

TEST(Readable, TakesAPrefix) {
  EXPECT_EQ(readable(1e-5, "m"), "10 um");
  EXPECT_EQ(readable(2.0000000000000003e-06, "m"), "2 um");
  EXPECT_EQ(readable(1.62e-9, "s"), "1.62 ns");
  EXPECT_EQ(readable(5e-11, "s"), "50 ps");
  EXPECT_EQ(readable(120e6, "Pa"), "120 MPa");
  EXPECT_EQ(readable(-69e9, "Pa"), "-69 GPa");
  EXPECT_EQ(readable(999999.99, "Pa"), "1 MPa");
  EXPECT_EQ(readable(1000, "m"), "1000 m");
}

TEST(Readable, LeavesTheRest) {
  EXPECT_EQ(readable(200, "m/s"), "200 m/s");
  EXPECT_EQ(readable(0.33, "1"), "0.33");
  EXPECT_EQ(readable(0, "Pa"), "0 Pa");
  EXPECT_EQ(readable(2700, "kg/m3"), "2700 kg/m3");
}

}  // namespace
}  // namespace mpmstudy
