#pragma once
/// A number over two others, as colours with contours, and the places where it is known as dots.
#include <filesystem>
#include <string>
#include <vector>

#include "analysis/units.hpp"

namespace analysis {

struct MapPoint {
  double x, y, value;  ///< SI
};

struct MapPlot {
  std::string title;
  std::string footer;  ///< small, below
  QuantityLabel x, y, colour;
  std::vector<MapPoint>
      points;  ///< those that are not finite are left out; so are, on an axis that is, those not above zero
  bool log_x = false, log_y = false;  ///< axes by their logarithm
};

/// Between the points, within their convex hull, the colours are a thin plate spline through them [Duchon
/// 1977], in coordinates from 0 to 1 along each axis. Without three points that are on no line, and with more
/// than 800, there are dots alone. Writes stem.png (1800 x 1200) and stem.svg. Throws std::invalid_argument
/// where there is nothing to draw, std::runtime_error where gnuplot or the disk fails.
void draw(const MapPlot&, const std::filesystem::path& stem);

/// What of `draw` is no picture: the spline at nodes, column by column from the lowest x, each from end to
/// end of the hull. Empty where there are dots alone.
std::vector<MapPoint> surface_of(const MapPlot&, int columns, int rows);

}  // namespace analysis
