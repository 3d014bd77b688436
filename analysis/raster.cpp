#include "analysis/raster.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

namespace analysis {
namespace {

/// The image while it is painted: for each pixel, how near the particle it shows is.
class Canvas {
 public:
  Canvas(const Window& window, int columns, int rows)
      : window_(window), dx_(window.width() / columns), dy_(window.height() / rows) {
    const auto pixels = static_cast<std::size_t>(columns) * static_cast<std::size_t>(rows);
    raster_ = {columns, rows, std::vector<float>(pixels, std::numeric_limits<float>::quiet_NaN())};
    distance_.assign(pixels, std::numeric_limits<double>::infinity());
  }

  void paint(double x, double y, double depth, double half, double value) {
    // Pixels whose centres lie in the square; a particle smaller than a pixel still takes the one it is in.
    const auto first = [half](double at, double origin, double step) {
      return std::min(std::ceil((at - half - origin) / step - 0.5), std::floor((at - origin) / step));
    };
    const auto last = [half](double at, double origin, double step) {
      return std::max(std::floor((at + half - origin) / step - 0.5), std::floor((at - origin) / step));
    };
    const int i0 = clamp(first(x, window_.x_min, dx_), 0, raster_.columns);
    const int i1 = clamp(last(x, window_.x_min, dx_), -1, raster_.columns - 1);
    const int j0 = clamp(first(y, window_.y_min, dy_), 0, raster_.rows);
    const int j1 = clamp(last(y, window_.y_min, dy_), -1, raster_.rows - 1);
    for (int j = j0; j <= j1; ++j)
      for (int i = i0; i <= i1; ++i) {
        const double px = window_.x_min + (i + 0.5) * dx_ - x, py = window_.y_min + (j + 0.5) * dy_ - y;
        const auto at = static_cast<std::size_t>(j) * static_cast<std::size_t>(raster_.columns) +
                        static_cast<std::size_t>(i);
        const double distance = px * px + py * py + depth * depth;
        if (distance >= distance_[at]) continue;
        distance_[at] = distance;
        raster_.values[at] = static_cast<float>(value);
      }
  }

  Raster take() { return std::move(raster_); }

 private:
  static int clamp(double value, int low, int high) {
    return static_cast<int>(std::clamp(value, static_cast<double>(low), static_cast<double>(high)));
  }

  Window window_;
  double dx_, dy_;
  Raster raster_;
  std::vector<double> distance_;
};

/// The values that all but one in a thousand lie between.
std::pair<double, double> spread(std::vector<double> values) {
  std::erase_if(values, [](double v) { return !std::isfinite(v); });
  if (values.empty()) return {0, 0};
  const auto at = [&](std::size_t i) {
    std::ranges::nth_element(values, values.begin() + static_cast<std::ptrdiff_t>(i));
    return values[i];
  };
  const std::size_t cut = values.size() / 1000;
  const double low = at(cut), high = at(values.size() - 1 - cut);
  return {low, high};
}

}  // namespace

Raster rasterise(const ParticleSquares& particles, bool mirrored, const Window& window, int columns, int rows,
                 double overlap) {
  Canvas canvas(window, columns, rows);
  for (std::size_t p = 0; p < particles.x.size(); ++p) {
    const double x = particles.x[p], y = particles.y[p], value = particles.value[p];
    const double half = particles.size[p] * overlap / 2,
                 depth = particles.depth.empty() ? 0 : particles.depth[p];
    if (!std::isfinite(x) || !std::isfinite(y) || !std::isfinite(value) || !std::isfinite(half)) continue;
    canvas.paint(x, y, depth, half, value);
    if (mirrored) canvas.paint(-x, y, depth, half, value);
  }
  return canvas.take();
}

std::vector<Piece> outlines(const ParticleSquares& particles, bool mirrored, const Window& w, int columns,
                            int rows) {
  std::vector<Piece> pieces;
  if (particles.material.empty()) return pieces;
  ParticleSquares numbers = particles;
  numbers.value.assign(particles.material.begin(), particles.material.end());
  const Raster raster = rasterise(numbers, mirrored, w, columns, rows);
  const double dx = w.width() / columns, dy = w.height() / rows;
  const auto at = [&](int i, int j) {
    return raster.values[static_cast<std::size_t>(j) * static_cast<std::size_t>(columns) +
                         static_cast<std::size_t>(i)];
  };
  const auto differ = [](float a, float b) { return std::isfinite(a) && std::isfinite(b) && a != b; };
  for (int j = 0; j < rows; ++j)
    for (int i = 0; i < columns; ++i) {
      const double x = w.x_min + i * dx, y = w.y_min + j * dy;
      if (i > 0 && differ(at(i - 1, j), at(i, j))) pieces.push_back({x, y, x, y + dy});
      if (j > 0 && differ(at(i, j - 1), at(i, j))) pieces.push_back({x, y, x + dx, y});
    }
  return pieces;
}

Window window_of(const std::vector<const ParticleSquares*>& snapshots, bool mirrored) {
  constexpr double inf = std::numeric_limits<double>::infinity();
  Window w{inf, -inf, inf, -inf};
  for (const ParticleSquares* s : snapshots) {
    const auto [x0, x1] = spread(s->x);
    const auto [y0, y1] = spread(s->y);
    w = {std::min(w.x_min, x0), std::max(w.x_max, x1), std::min(w.y_min, y0), std::max(w.y_max, y1)};
  }
  if (mirrored) w.x_min = -(w.x_max = std::max(std::abs(w.x_min), std::abs(w.x_max)));
  double margin = 0.03 * std::max(w.width(), w.height());
  for (const ParticleSquares* s : snapshots)
    margin = std::max(margin, spread(s->size).second);  // a single particle has room
  return {w.x_min - margin, w.x_max + margin, w.y_min - margin, w.y_max + margin};
}

}  // namespace analysis
