// Empty regions of an image: those that are closed, by size.
#include "analysis/empty_regions.hpp"

#include <gmock/gmock.h>

#include <limits>
#include <string>

namespace {

using analysis::closed_empty_regions;
using testing::DoubleEq;
using testing::ElementsAre;

/// '#' is material, anything else is empty; a pixel is 0.5 m wide and 2 m high.
std::vector<double> areas_of(const std::vector<std::string>& rows) {
  analysis::Raster raster{static_cast<int>(rows[0].size()), static_cast<int>(rows.size()), {}};
  for (const std::string& row : rows)
    for (const char c : row)
      raster.values.push_back(c == '#' ? 1.0F : std::numeric_limits<float>::quiet_NaN());
  return closed_empty_regions(raster, {0, 0.5 * raster.columns, 0, 2.0 * raster.rows});
}

TEST(EmptyRegions, AreClosedAndOrderedBySize) {
  EXPECT_THAT(areas_of({"########",  //
                        "#.##..##",  //
                        "####.###",  //
                        "########"}),
              ElementsAre(DoubleEq(3), DoubleEq(1)));
}

TEST(EmptyRegions, ThatReachTheBorderAreOutside) {
  EXPECT_THAT(areas_of({"###.####",  //
                        "#...####",  //
                        "#####..#",  //
                        "########"}),
              ElementsAre(DoubleEq(2)));
}

TEST(EmptyRegions, ThatShareACornerAreTwo) {
  EXPECT_THAT(areas_of({"####", "#.##", "##.#", "####"}), ElementsAre(DoubleEq(1), DoubleEq(1)));
}

}  // namespace
