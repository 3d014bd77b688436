#include "analysis/map_plot.hpp"

#include <fmt/format.h>

#include <Eigen/Dense>
#include <algorithm>
#include <cmath>
#include <limits>
#include <map>
#include <stdexcept>

#include "analysis/gnuplot.hpp"
#include "analysis/log_axis.hpp"
#include "analysis/palette.hpp"

namespace analysis {
namespace {

constexpr int cells = 90;                 ///< of the surface, along each axis
constexpr std::size_t most_points = 800;  ///< of a spline: its equations take the cube of their number

/// A point of the map in coordinates from 0 to 1.
struct Place {
  double x, y, value;
};

bool is_drawn(const MapPlot& plot, const MapPoint& p) {
  return std::isfinite(p.x) && std::isfinite(p.y) && std::isfinite(p.value) && (!plot.log_x || p.x > 0) &&
         (!plot.log_y || p.y > 0);
}

/// One axis of the map.
struct Range {
  double low = std::numeric_limits<double>::infinity(), high = -low;
  bool log = false;

  double scaled(double value) const { return log ? std::log(value) : value; }
  void include(double value) {
    low = std::min(low, scaled(value));
    high = std::max(high, scaled(value));
  }
  double width() const { return high > low ? high - low : 1; }
  double to_unit(double value) const { return (scaled(value) - low) / width(); }
  double from_unit(double share) const {
    const double value = low + share * width();
    return log ? std::exp(value) : value;
  }
};

struct Ranges {
  Range x, y;
};

Ranges ranges_of(const MapPlot& plot) {
  Ranges r;
  r.x.log = plot.log_x, r.y.log = plot.log_y;
  for (const MapPoint& p : plot.points)
    if (is_drawn(plot, p)) r.x.include(p.x), r.y.include(p.y);
  return r;
}

/// Each place once, with the mean of its values.
std::vector<Place> places_of(const MapPlot& plot, const Ranges& ranges) {
  std::map<std::pair<double, double>, std::pair<double, int>> sums;
  for (const MapPoint& p : plot.points) {
    if (!is_drawn(plot, p)) continue;
    auto& [sum, count] = sums[{ranges.x.to_unit(p.x), ranges.y.to_unit(p.y)}];
    sum += p.value, ++count;
  }
  std::vector<Place> places;
  for (const auto& [at, sum] : sums) places.push_back({at.first, at.second, sum.first / sum.second});
  return places;
}

/// Above zero where (x, y) is on the left of the way from a to b.
double side(const Place& a, const Place& b, double x, double y) {
  return (b.x - a.x) * (y - a.y) - (b.y - a.y) * (x - a.x);
}

/// The convex hull, counterclockwise; `places` are ordered by x, then y [Andrew 1979].
std::vector<Place> hull_of(const std::vector<Place>& places) {
  std::vector<Place> hull;
  const auto add = [&](const Place& p, std::size_t least) {
    while (hull.size() >= least + 2 && side(hull[hull.size() - 2], hull.back(), p.x, p.y) <= 1e-12)
      hull.pop_back();
    hull.push_back(p);
  };
  for (const Place& p : places) add(p, 0);
  const std::size_t lower = hull.size() - 1;
  for (std::size_t i = places.size() - 1; i-- > 0;) add(places[i], lower);
  hull.pop_back();
  return hull;
}

/// Where the line of that x enters and leaves the hull.
std::pair<double, double> crossing(const std::vector<Place>& hull, double x) {
  double low = std::numeric_limits<double>::infinity(), high = -low;
  for (std::size_t i = 0; i < hull.size(); ++i) {
    const Place &a = hull[i], &b = hull[(i + 1) % hull.size()];
    if (x < std::min(a.x, b.x) || x > std::max(a.x, b.x)) continue;
    const double on_edge = a.y + (b.y - a.y) * (x - a.x) / (b.x - a.x);
    low = std::min(low, a.x == b.x ? std::min(a.y, b.y) : on_edge);
    high = std::max(high, a.x == b.x ? std::max(a.y, b.y) : on_edge);
  }
  return {low, high};
}

/// r^2 ln r, of r^2.
double plate(double square) { return square > 0 ? 0.5 * square * std::log(square) : 0; }

/// value = w . plate(|p - p_i|) + a + b x + c y; the w are orthogonal to 1, x and y.
class Spline {
 public:
  explicit Spline(const std::vector<Place>& places) : places_(places) {
    const auto n = std::ssize(places);
    Eigen::MatrixXd a = Eigen::MatrixXd::Zero(n + 3, n + 3);
    Eigen::VectorXd b = Eigen::VectorXd::Zero(n + 3);
    for (Eigen::Index i = 0; i < n; ++i) {
      const Place& p = places[static_cast<std::size_t>(i)];
      for (Eigen::Index j = 0; j < i; ++j) {
        const Place& q = places[static_cast<std::size_t>(j)];
        a(i, j) = a(j, i) = plate((p.x - q.x) * (p.x - q.x) + (p.y - q.y) * (p.y - q.y));
      }
      a.row(i).tail(3) << 1, p.x, p.y;
      a.col(i).tail(3) << 1, p.x, p.y;
      b(i) = p.value;
    }
    solution_ = a.partialPivLu().solve(b);
  }

  double operator()(double x, double y) const {
    const auto n = std::ssize(places_);
    double value = solution_(n) + solution_(n + 1) * x + solution_(n + 2) * y;
    for (Eigen::Index i = 0; i < n; ++i) {
      const Place& p = places_[static_cast<std::size_t>(i)];
      value += solution_(i) * plate((p.x - x) * (p.x - x) + (p.y - y) * (p.y - y));
    }
    return value;
  }

 private:
  const std::vector<Place>& places_;
  Eigen::VectorXd solution_;
};

/// Nodes from end to end of x, and at each x from end to end of the hull: its rim is no staircase.
std::vector<MapPoint> make_surface(const MapPlot& plot, const Ranges& ranges, int columns, int rows) {
  const std::vector<Place> places = places_of(plot, ranges);
  if (places.size() < 3 || places.size() > most_points) return {};
  const std::vector<Place> hull = hull_of(places);
  if (hull.size() < 3) return {};
  const Spline spline(places);
  std::vector<MapPoint> nodes;
  for (int column = 0; column < columns; ++column) {
    const double x = static_cast<double>(column) / (columns - 1);
    const auto [low, high] = crossing(hull, x);
    for (int row = 0; row < rows; ++row) {
      const double y = low + (high - low) * row / (rows - 1);
      nodes.push_back({ranges.x.from_unit(x), ranges.y.from_unit(y), spline(x, y)});
    }
  }
  return nodes;
}

/// A blank line behind every column.
std::string rows_of(const std::vector<MapPoint>& nodes, const DisplayUnit& x, const DisplayUnit& y,
                    const DisplayUnit& colour) {
  std::string text;
  for (std::size_t i = 0; i < nodes.size(); ++i) {
    const MapPoint& p = nodes[i];
    text += fmt::format("{:.9g} {:.9g} {:.9g}\n", p.x * x.factor, p.y * y.factor, p.value * colour.factor);
    if ((i + 1) % cells == 0) text += "\n";
  }
  return text;
}

double largest(const MapPlot& plot, double MapPoint::*column) {
  double result = 0;
  for (const MapPoint& p : plot.points)
    if (is_drawn(plot, p)) result = std::max(result, std::abs(p.*column));
  return result;
}

/// An axis from end to end of the points, with room for the dots at its ends.
std::string axis_range(const char* axis, const Range& range, double factor) {
  if (range.log) return log_axis(axis, range.from_unit(0) * factor, range.from_unit(1) * factor);
  constexpr double room = 0.03;
  return fmt::format("set {}range [{:.9g}:{:.9g}]\n", axis, range.from_unit(-room) * factor,
                     range.from_unit(1 + room) * factor);
}

std::string script(const MapPlot& plot, const Ranges& ranges, const DisplayUnit& x, const DisplayUnit& y,
                   const DisplayUnit& colour, bool surface, double low, double high) {
  std::string text = fmt::format("set label 1 {} at screen 0.46, screen 0.955 center font ',14'\n",
                                 gnuplot_text(plot.title));
  if (!plot.footer.empty())
    text += fmt::format("set label 3 {} at screen 0.985, screen 0.018 right font ',7.5' tc rgb '#888888'\n",
                        gnuplot_text(plot.footer));
  if (surface)
    text +=
        "set label 4 'dots: runs; colours between them: a spline through them' at screen 0.105, screen 0.018 "
        "left "
        "font ',7.5' tc rgb '#888888'\n";
  text += fmt::format("set xlabel {} offset 0,-0.3\nset ylabel {} offset -1,0\nset cblabel {} offset 1.5,0\n",
                      gnuplot_text(axis_label(plot.x, x)), gnuplot_text(axis_label(plot.y, y)),
                      gnuplot_text(axis_label(plot.colour, colour)));
  text +=
      "set border 31 lw 1 lc rgb '#333333'\nset tics nomirror out scale 0.7 tc rgb '#222222'\nset format "
      "'%g'\n";
  text +=
      "set lmargin at screen 0.115\nset rmargin at screen 0.81\nset bmargin at screen 0.135\n"
      "set tmargin at screen 0.915\nunset key\n";
  text += fmt::format("set palette defined {}\nset cbrange [{:.9g}:{:.9g}]\n", viridis, low, high);
  text += "set colorbox user origin screen 0.835, screen 0.135 size screen 0.025, screen 0.78\n";
  text += axis_range("x", ranges.x, x.factor) + axis_range("y", ranges.y, y.factor);
  text += "set view map\nset pm3d corners2color mean\n";
  std::string clauses;
  if (surface) {
    text +=
        "set contour base\nset cntrparam levels auto 8\nset cntrlabel onecolor start 12 interval 60 font "
        "',8'\n";
    clauses =
        "'surface.dat' using 1:2:3 with pm3d nocontour, "
        "'surface.dat' using 1:2:3 with lines lw 0.8 lc rgb '#ffffff' nosurface, "
        "'surface.dat' using 1:2:3 with labels textcolor rgb '#ffffff' nosurface, ";
  }
  clauses +=
      "'points.dat' using 1:2:3 with points pt 7 ps 1.25 lc rgb '#ffffff' nocontour, "
      "'points.dat' using 1:2:3 with points pt 7 ps 1.05 lc rgb '#222222' nocontour, "
      "'points.dat' using 1:2:3:3 with points pt 7 ps 0.8 lc palette nocontour";
  return text + "splot " + clauses + "\n";
}

}  // namespace

std::vector<MapPoint> surface_of(const MapPlot& plot, int columns, int rows) {
  return make_surface(plot, ranges_of(plot), columns, rows);
}

void draw(const MapPlot& plot, const std::filesystem::path& stem) {
  if (std::ranges::none_of(plot.points, [&](const MapPoint& p) { return is_drawn(plot, p); }))
    throw std::invalid_argument("figure '" + plot.title + "': there is nothing to draw");
  const Ranges ranges = ranges_of(plot);
  const DisplayUnit x = display_unit(plot.x.unit, largest(plot, &MapPoint::x)),
                    y = display_unit(plot.y.unit, largest(plot, &MapPoint::y)),
                    colour = display_unit(plot.colour.unit, largest(plot, &MapPoint::value));
  const std::vector<MapPoint> surface = make_surface(plot, ranges, cells, cells);
  Range values;
  std::string rows;
  for (const MapPoint& p : plot.points) {
    if (!is_drawn(plot, p)) continue;
    values.include(p.value * colour.factor);
    rows += fmt::format("{:.9g} {:.9g} {:.9g}\n", p.x * x.factor, p.y * y.factor, p.value * colour.factor);
  }
  if (!(values.high > values.low)) values.high = values.low + (values.low == 0 ? 1 : std::abs(values.low));
  const FigureFolder folder(stem);
  folder.write("points.dat", rows);
  if (!surface.empty()) folder.write("surface.dat", rows_of(surface, x, y, colour));
  run_gnuplot(folder, script(plot, ranges, x, y, colour, !surface.empty(), values.low, values.high),
              figure_size, stem);
}

}  // namespace analysis
