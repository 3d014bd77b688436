#include "analysis/empty_regions.hpp"

#include <algorithm>
#include <cmath>
#include <functional>

namespace analysis {

std::vector<double> closed_empty_regions(const Raster& raster, const Window& window) {
  std::vector<char> seen(raster.values.size(), 0);
  const auto at = [&](int i, int j) {
    return static_cast<std::size_t>(j) * static_cast<std::size_t>(raster.columns) +
           static_cast<std::size_t>(i);
  };
  const double pixel = window.width() / raster.columns * (window.height() / raster.rows);
  std::vector<double> areas;
  std::vector<std::pair<int, int>> open;
  const auto visit = [&](int i, int j) {
    if (seen[at(i, j)] || !std::isnan(raster.values[at(i, j)])) return;
    seen[at(i, j)] = 1;
    open.emplace_back(i, j);
  };
  for (int row = 0; row < raster.rows; ++row)
    for (int column = 0; column < raster.columns; ++column) {
      visit(column, row);
      int pixels = 0;
      bool closed = true;
      while (!open.empty()) {
        const auto [i, j] = open.back();
        open.pop_back();
        ++pixels;
        const bool border = i == 0 || j == 0 || i == raster.columns - 1 || j == raster.rows - 1;
        closed = closed && !border;
        if (i > 0) visit(i - 1, j);
        if (i < raster.columns - 1) visit(i + 1, j);
        if (j > 0) visit(i, j - 1);
        if (j < raster.rows - 1) visit(i, j + 1);
      }
      if (pixels > 0 && closed) areas.push_back(pixels * pixel);
    }
  std::ranges::sort(areas, std::greater<>());
  return areas;
}

}  // namespace analysis
