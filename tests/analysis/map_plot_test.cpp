#include "analysis/map_plot.hpp"

#include <gmock/gmock.h>

#include <cmath>
#include <stdexcept>

#include "analysis/gnuplot.hpp"
#include "temporary_folder.hpp"

namespace {

using namespace analysis;

class MapPlotTest : public TemporaryFolderTest {};

MapPlot make_map(double (*value)(double, double), int count) {
  MapPlot map;
  map.title = "Collapse over speed and radius";
  map.x = quantity_label("impact_speed", "m/s", "u");
  map.y = quantity_label("cavity_radius", "m", "R");
  map.colour = quantity_label("collapsibility", "1", "Φ");
  for (int i = 0; i < count; ++i) {
    // a Kronecker sequence: scattered, and no two on one line with an axis
    const double x = std::fmod(0.5 + 0.7548776662466927 * i, 1),
                 y = std::fmod(0.5 + 0.5698402909980532 * i, 1);
    map.points.push_back({100 + 300 * x, 1e-6 * (0.5 + y), value(x, y)});
  }
  return map;
}

/// A plane is its own spline.
TEST_F(MapPlotTest, ThePlaneIsReproduced) {
  const MapPlot map = make_map([](double x, double y) { return 1 + 2 * x - 3 * y; }, 20);
  const auto surface = surface_of(map, 11, 11);
  ASSERT_EQ(surface.size(), 121u);
  double lowest = 1;
  for (const MapPoint& p : surface) {
    EXPECT_NEAR(p.value, 1 + 2 * (p.x - 100) / 300 - 3 * (p.y / 1e-6 - 0.5), 1e-9);
    lowest = std::min(lowest, p.y / 1e-6);
  }
  EXPECT_GT(lowest, 0.5);  // not outside of the points
}

/// It goes through its points: a grid whose nodes are points.
TEST_F(MapPlotTest, GoesThroughItsPoints) {
  MapPlot map = make_map([](double, double) { return 0.0; }, 0);
  for (int column = 0; column < 5; ++column)
    for (int row = 0; row < 4; ++row)
      map.points.push_back({std::pow(10, column), 1e-6 * (1 + row), std::sin(1.0 * column) * row});
  map.log_x = true;
  const auto surface = surface_of(map, 5, 4);
  ASSERT_EQ(surface.size(), 20u);
  for (std::size_t i = 0; i < 20; ++i) {
    EXPECT_NEAR(surface[i].x / map.points[i].x, 1, 1e-12);
    EXPECT_NEAR(surface[i].value, map.points[i].value, 1e-9);
  }
}

TEST_F(MapPlotTest, WithoutAnAreaThereAreDotsAlone) {
  MapPlot map = make_map([](double x, double) { return x; }, 2);
  EXPECT_TRUE(surface_of(map, 5, 5).empty());
  map.points.push_back(
      {0.5 * (map.points[0].x + map.points[1].x), 0.5 * (map.points[0].y + map.points[1].y), 1});
  EXPECT_TRUE(surface_of(map, 5, 5).empty()) << "three on one line";
  draw(map, folder_ / "dots");
  EXPECT_TRUE(std::filesystem::exists(folder_ / "dots.png"));
}

TEST_F(MapPlotTest, ARunThatComesTwiceCountsOnce) {
  MapPlot map = make_map([](double x, double y) { return x * y; }, 12);
  const auto once = surface_of(map, 9, 9);
  map.points.push_back(map.points[3]);
  const auto twice = surface_of(map, 9, 9);
  for (std::size_t i = 0; i < once.size(); ++i) EXPECT_DOUBLE_EQ(once[i].value, twice[i].value);
}

TEST_F(MapPlotTest, IsDrawnAndOneWithoutPointsIsRefused) {
  draw(make_map([](double x, double y) { return std::exp(x) - y * y; }, 40), folder_ / "map");
  EXPECT_GT(std::filesystem::file_size(folder_ / "map.png"), 20000u);
  EXPECT_TRUE(std::filesystem::exists(folder_ / "map.svg"));
  EXPECT_THROW(draw(make_map(nullptr, 0), folder_ / "none"), std::invalid_argument);
}

}  // namespace
