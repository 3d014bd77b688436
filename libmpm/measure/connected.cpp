#include "libmpm/measure/connected.hpp"

#include <algorithm>
#include <array>
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

template <int axes>
using Index = std::array<int, axes>;

/// Points by bins, along the first axis first.
template <int axes>
struct Bins {
  Index<axes> counts{};    ///< along each axis
  std::vector<int> first;  ///< of each bin, in `order`; one more than bins
  std::vector<int> order;  ///< points
  std::vector<int> bin;    ///< of each point

  Bins(std::span<const Vec<axes>> points, double side) {
    Vec<axes> low = points[0], high = points[0];
    for (const Vec<axes>& x : points) low = low.cwiseMin(x), high = high.cwiseMax(x);
    std::size_t all = 1;
    for (int d = 0; d < axes; ++d) {
      counts[d] = 1 + static_cast<int>((high[d] - low[d]) / side);
      all *= static_cast<std::size_t>(counts[d]);
    }
    first.assign(all + 1, 0);
    bin.reserve(points.size());
    for (const Vec<axes>& x : points) {
      Index<axes> at;
      for (int d = 0; d < axes; ++d) at[d] = static_cast<int>((x[d] - low[d]) / side);
      bin.push_back(number(at));
      ++first[static_cast<std::size_t>(bin.back()) + 1];
    }
    std::partial_sum(first.begin(), first.end(), first.begin());
    order.resize(points.size());
    std::vector<int> next(first.begin(), first.end() - 1);
    for (std::size_t p = 0; p < points.size(); ++p)
      order[static_cast<std::size_t>(next[static_cast<std::size_t>(bin[p])]++)] = static_cast<int>(p);
  }
  int count() const { return static_cast<int>(first.size()) - 1; }
  int number(const Index<axes>& at) const {
    int k = 0;
    for (int d = axes - 1; d >= 0; --d) k = k * counts[d] + at[d];
    return k;
  }
  Index<axes> index(int k) const {
    Index<axes> at;
    for (int d = 0; d < axes; ++d) at[d] = k % counts[d], k /= counts[d];
    return at;
  }
  std::span<const int> of(int k) const {
    const auto b = static_cast<std::size_t>(k);
    return std::span(order).subspan(static_cast<std::size_t>(first[b]),
                                    static_cast<std::size_t>(first[b + 1] - first[b]));
  }
};

/// The steps to the bins within two of one that come after it: each pair of bins once.
template <int axes>
std::vector<Index<axes>> steps_ahead() {
  std::vector<Index<axes>> steps;
  const int all = axes == 2 ? 25 : 125;
  for (int k = all / 2 + 1; k < all; ++k) {
    Index<axes> step;
    for (int d = 0, rest = k; d < axes; ++d, rest /= 5) step[d] = rest % 5 - 2;
    steps.push_back(step);
  }
  return steps;
}

}  // namespace

template <int axes>
ConnectedParts connected_parts(std::span<const Vec<axes>> points, double link) {
  if (points.empty()) return {};
  const Bins<axes> bins(points, link / std::sqrt(static_cast<double>(axes)));
  const auto close = [&](int a, int b) {
    for (const int p : bins.of(a))
      for (const int q : bins.of(b))
        if ((points[static_cast<std::size_t>(p)] - points[static_cast<std::size_t>(q)]).squaredNorm() <
            link * link)
          return true;
    return false;
  };
  Roots roots(static_cast<std::size_t>(bins.count()));
  const auto steps = steps_ahead<axes>();
  for (int here = 0; here < bins.count(); ++here) {
    if (bins.of(here).empty()) continue;
    const Index<axes> at = bins.index(here);
    for (const Index<axes>& step : steps) {
      Index<axes> to;
      bool inside = true;
      for (int d = 0; d < axes; ++d) {
        to[d] = at[d] + step[d];
        inside = inside && to[d] >= 0 && to[d] < bins.counts[d];
      }
      if (!inside) continue;
      const int there = bins.number(to);
      if (!bins.of(there).empty() && roots.find(here) != roots.find(there) && close(here, there))
        roots.join(here, there);
    }
  }
  ConnectedParts result;
  result.part.reserve(points.size());
  std::vector<int> number(static_cast<std::size_t>(bins.count()), -1);
  for (std::size_t p = 0; p < points.size(); ++p) {
    int& n = number[static_cast<std::size_t>(roots.find(bins.bin[p]))];
    if (n < 0) n = result.count++;
    result.part.push_back(n);
  }
  return result;
}

template ConnectedParts connected_parts<2>(std::span<const Vec2>, double);
template ConnectedParts connected_parts<3>(std::span<const Vec3>, double);

}  // namespace mpm
