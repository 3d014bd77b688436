#include "libmpm/measure/connected.hpp"

#include <algorithm>
#include <cmath>
#include <numeric>

namespace mpm {
namespace {

/// Union-find over bins; the smaller number is the root, so that nothing depends on the order of joins.
class Roots {
 public:
  explicit Roots(std::size_t count) : parent_(count) { std::iota(parent_.begin(), parent_.end(), 0); }
  int find(int k) {
    while (at(k) != k) k = at(k) = at(at(k));
    return k;
  }
  void join(int a, int b) {
    a = find(a), b = find(b);
    at(std::max(a, b)) = std::min(a, b);
  }

 private:
  int& at(int k) { return parent_[static_cast<std::size_t>(k)]; }
  std::vector<int> parent_;
};

/// Points by bins, row by row.
struct Bins {
  int columns = 0, rows = 0;
  std::vector<int> first;  ///< of each bin, in `order`; one more than bins
  std::vector<int> order;  ///< points
  std::vector<int> bin;    ///< of each point

  Bins(std::span<const Vec2> points, double side) {
    Vec2 low = points[0], high = points[0];
    for (const Vec2& x : points) low = low.cwiseMin(x), high = high.cwiseMax(x);
    columns = 1 + static_cast<int>((high.x() - low.x()) / side);
    rows = 1 + static_cast<int>((high.y() - low.y()) / side);
    first.assign(static_cast<std::size_t>(columns) * static_cast<std::size_t>(rows) + 1, 0);
    bin.reserve(points.size());
    for (const Vec2& x : points) {
      bin.push_back(static_cast<int>((x.y() - low.y()) / side) * columns +
                    static_cast<int>((x.x() - low.x()) / side));
      ++first[static_cast<std::size_t>(bin.back()) + 1];
    }
    std::partial_sum(first.begin(), first.end(), first.begin());
    order.resize(points.size());
    std::vector<int> next(first.begin(), first.end() - 1);
    for (std::size_t p = 0; p < points.size(); ++p)
      order[static_cast<std::size_t>(next[static_cast<std::size_t>(bin[p])]++)] = static_cast<int>(p);
  }
  std::span<const int> of(int k) const {
    const auto b = static_cast<std::size_t>(k);
    return std::span(order).subspan(static_cast<std::size_t>(first[b]),
                                    static_cast<std::size_t>(first[b + 1] - first[b]));
  }
};

}  // namespace

ConnectedParts connected_parts(std::span<const Vec2> points, double link) {
  if (points.empty()) return {};
  const Bins bins(points, link * std::sqrt(0.5));
  const auto close = [&](int a, int b) {
    for (const int p : bins.of(a))
      for (const int q : bins.of(b))
        if ((points[static_cast<std::size_t>(p)] - points[static_cast<std::size_t>(q)]).squaredNorm() <
            link * link)
          return true;
    return false;
  };
  Roots roots(bins.first.size() - 1);
  for (int j = 0; j < bins.rows; ++j)
    for (int i = 0; i < bins.columns; ++i) {
      const int here = j * bins.columns + i;
      if (bins.of(here).empty()) continue;
      for (int dj = 0; dj <= 2; ++dj)
        for (int di = dj == 0 ? 1 : -2; di <= 2; ++di) {
          if (i + di < 0 || i + di >= bins.columns || j + dj >= bins.rows) continue;
          const int there = here + dj * bins.columns + di;
          if (!bins.of(there).empty() && roots.find(here) != roots.find(there) && close(here, there))
            roots.join(here, there);
        }
    }
  ConnectedParts result;
  result.part.reserve(points.size());
  std::vector<int> number(bins.first.size() - 1, -1);
  for (std::size_t p = 0; p < points.size(); ++p) {
    int& n = number[static_cast<std::size_t>(roots.find(bins.bin[p]))];
    if (n < 0) n = result.count++;
    result.part.push_back(n);
  }
  return result;
}

}  // namespace mpm
