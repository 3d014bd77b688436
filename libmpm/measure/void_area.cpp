#include "libmpm/measure/void_area.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "libmpm/shape/bspline2.hpp"

namespace mpm {
namespace {

using std::numbers::pi;
constexpr double half_full = 0.5;
/// A region along the wall that is farther than this beside the first circle is the gap under a body that
/// leaves it. Two: the indicator smears an edge over that many.
constexpr int cells_beside_wall = 2;

/// Of a part of a unit square.
struct Part {
  double area = 0, moment_x = 0;
};

/// The part of a unit square where the bilinear corner values (a b / d c, counter-clockwise) are below 1/2,
/// by straight cuts. In a saddle the two empty corners are joined.
Part empty_part(const double (&corner)[4]) {
  double area2 = 0, moment6 = 0;
  Vec2 first, last;
  bool any = false;
  const Vec2 at[4] = {{0, 0}, {1, 0}, {1, 1}, {0, 1}};
  const auto visit = [&](const Vec2& x) {
    if (any) {
      const double cross = last.x() * x.y() - x.x() * last.y();
      area2 += cross;
      moment6 += cross * (last.x() + x.x());
    } else
      first = x;
    any = true;
    last = x;
  };
  for (int k = 0; k < 4; ++k) {
    const double a = corner[k], b = corner[(k + 1) % 4];
    if (a < half_full) visit(at[k]);
    if ((a < half_full) != (b < half_full))
      visit(at[k] + ((half_full - a) / (b - a)) * (at[(k + 1) % 4] - at[k]));
  }
  if (any) visit(first);
  return {0.5 * area2, moment6 / 6};
}

}  // namespace

Indicator indicator_of(const State& s, int points_per_particle) {
  const Grid& g = s.grid;
  const Particles& ps = s.particles;
  double highest = g.origin().y();
  for (const Vec2& x : ps.position) highest = std::max(highest, x.y());
  const int rows = static_cast<int>((highest - g.origin().y()) * g.inverse_cell().y()) + 4;
  const int stride = g.columns() + 3;
  std::vector<double> raw(static_cast<std::size_t>(stride * (rows + 3)), 0.0);  // one ghost layer around
  const auto at = [&](int i, int j) -> double& {
    return raw[static_cast<std::size_t>((j + 1) * stride + i + 1)];
  };

  const double inverse = g.inverse_cell().x() * g.inverse_cell().y();
  for (std::size_t p = 0; p < ps.size(); ++p) {
    const double share = area(s, p) * inverse / points_per_particle;
    for (int k = 0; k < points_per_particle; ++k) {
      Vec2 x = ps.position[p];
      if (points_per_particle == 4)
        x += 0.5 * Vec2(k % 2 ? 1 : -1, k / 2 ? 1 : -1).cwiseProduct(ps.half_size[p]);
      const Stencil n = stencil_at<BSpline2>(g, x, Vec2::Zero());
      for (int j = 0; j < 3; ++j)
        for (int i = 0; i < 3; ++i) at(n.x.first + i, n.y.first + j) += share * n.weight(i, j);
    }
  }
  const int right = g.columns();
  for (int j = -1; j <= rows; ++j) {
    at(0, j) *= 2;
    at(1, j) += at(-1, j);
    at(right, j) *= 2;
    at(right - 1, j) += at(right + 1, j);
  }
  Indicator field{g.columns(), rows, g.cell(), {}};
  field.fraction.reserve(static_cast<std::size_t>((right + 1) * (rows + 1)));
  for (int j = 0; j <= rows; ++j)
    for (int i = 0; i <= right; ++i)
      field.fraction.push_back(j == 0 ? 2 * at(i, 0) : j == 1 ? at(i, 1) + at(i, -1) : at(i, j));
  return field;
}

VoidArea::VoidArea(Vec2 center, double radius, bool full_width, int particles_per_cell)
    : center_(center),
      radius_(radius),
      full_width_(full_width),
      points_per_particle_(particles_per_cell == 1 ? 4 : 1),
      points_per_cell_(points_per_particle_ * particles_per_cell) {}

/// Empty nodes of the cavity at the start; later, empty nodes of or beside the last region.
void VoidArea::seed(const Indicator& f, const Vec2& origin, std::vector<char>& region) const {
  for (int j = 0; j <= f.rows; ++j)
    for (int i = 0; i <= f.columns; ++i) {
      if (f.at(i, j) >= half_full) continue;
      bool inside = false;
      if (!started_) {
        const Vec2 x = origin + Vec2(i * f.cell.x(), j * f.cell.y());
        inside = (x - center_).norm() < radius_;
      } else {
        for (int dj = -1; dj <= 1; ++dj)
          for (int di = -1; di <= 1; ++di) {
            const int a = i + di, b = j + dj;
            if (a < 0 || b < 0 || a > previous_columns_ || b > previous_rows_) continue;
            inside |= previous_[static_cast<std::size_t>(b * (previous_columns_ + 1) + a)] != 0;
          }
      }
      if (inside) region[static_cast<std::size_t>(j * (f.columns + 1) + i)] = 1;
    }
}

namespace {

/// Marks all empty nodes that are connected to the marked ones; returns how many are marked in all.
int spread(const Indicator& f, std::vector<char>& region, std::vector<int> front) {
  const int stride = f.columns + 1;
  int count = static_cast<int>(front.size());
  while (!front.empty()) {
    const int k = front.back(), i = k % stride, j = k / stride;
    front.pop_back();
    const int neighbours[4][2] = {{i - 1, j}, {i + 1, j}, {i, j - 1}, {i, j + 1}};
    for (const auto& [a, b] : neighbours) {
      if (a < 0 || b < 0 || a > f.columns || b > f.rows) continue;
      char& mark = region[static_cast<std::size_t>(b * stride + a)];
      if (mark || f.at(a, b) >= half_full) continue;
      mark = 1;
      ++count;
      front.push_back(b * stride + a);
    }
  }
  return count;
}

/// Empty regions of `smallest` nodes or more that reach neither the topmost row, which is above every
/// particle, nor the lowest, where a body leaves the wall.
int count_closed(const Indicator& f) {
  constexpr int smallest = 4;
  std::vector<char> seen(f.fraction.size(), 0);
  std::vector<int> outside;
  for (int k = 0; k < static_cast<int>(seen.size()); ++k) {
    const int row = k / (f.columns + 1);
    if ((row > 0 && row < f.rows) || f.fraction[static_cast<std::size_t>(k)] >= half_full) continue;
    seen[static_cast<std::size_t>(k)] = 1;
    outside.push_back(k);
  }
  spread(f, seen, std::move(outside));
  int regions = 0;
  for (std::size_t k = 0; k < seen.size(); ++k) {
    if (seen[k] || f.fraction[k] >= half_full) continue;
    seen[k] = 1;
    regions += spread(f, seen, {static_cast<int>(k)}) >= smallest;
  }
  return regions;
}

}  // namespace

double VoidArea::update(const State& s) {
  const Indicator f = indicator_of(s, points_per_particle_);
  const int stride = f.columns + 1;
  std::vector<char> region(f.fraction.size(), 0);
  seed(f, s.grid.origin(), region);

  std::vector<int> front;
  for (std::size_t k = 0; k < region.size(); ++k)
    if (region[k]) front.push_back(static_cast<int>(k));
  spread(f, region, std::move(front));
  closed_regions_ = count_closed(f);

  joined_outside_ = touches_wall_ = false;
  bool any = false;
  for (int i = 0; i <= f.columns; ++i) {
    joined_outside_ |= region[static_cast<std::size_t>(f.rows * stride + i)] != 0;
    if (!region[static_cast<std::size_t>(i)]) continue;
    touches_wall_ = true;
    const double x = s.grid.origin().x() + i * f.cell.x();
    joined_outside_ |= std::abs(x - center_.x()) > radius_ + cells_beside_wall * f.cell.x();
  }
  double cells = 0, radial_cells = 0;  // the latter times their distance from x = 0, in cells
  int lowest = f.rows, highest = 0;    // rows of cells that the region has a part of
  for (int j = 0; j < f.rows; ++j)
    for (int i = 0; i < f.columns; ++i) {
      const int at[4][2] = {{i, j}, {i + 1, j}, {i + 1, j + 1}, {i, j + 1}};
      double corner[4];
      bool mine = false;
      for (int k = 0; k < 4; ++k) {
        corner[k] = f.at(at[k][0], at[k][1]);
        mine |= region[static_cast<std::size_t>(at[k][1] * stride + at[k][0])] != 0;
      }
      any |= mine;
      if (!mine) continue;
      const Part part = empty_part(corner);
      cells += part.area;
      radial_cells += i * part.area + part.moment_x;
      lowest = std::min(lowest, j), highest = std::max(highest, j);
    }
  started_ = true;
  previous_ = std::move(region);
  previous_columns_ = f.columns;
  previous_rows_ = f.rows;
  volume_ = 0;
  if (!any) return 0;
  const double variance = 1.0 / 4 + 1.0 / 6 - 1.0 / (12.0 * points_per_cell_);
  const double closed = joined_outside_ ? 0 : touches_wall_ ? 0.5 : 1;
  const double height = highest - lowest;
  const double cell = f.cell.x() * f.cell.y();
  volume_ = 2 * pi * (radial_cells + 0.5 * closed * variance * height) * cell * f.cell.x();
  return ((full_width_ ? 1 : 2) * cells + closed * pi * variance) * cell;
}

void VoidArea::carry(Archive& a) {
  a.integer("started", started_), a.integer("joined_outside", joined_outside_);
  a.integer("touches_wall", touches_wall_), a.integer("closed_regions", closed_regions_);
  a.number("volume", volume_);
  a.integer("columns", previous_columns_), a.integer("rows", previous_rows_);
  a.integers("region", previous_);
}

}  // namespace mpm
