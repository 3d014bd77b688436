#include "libmpm/measure/hot_spots.hpp"

#include <algorithm>
#include <cmath>
#include <numeric>

namespace mpm {
namespace {

constexpr ResultRow rows[] = {
    {.name = "hot_spot_work_J_m3",
     .unit = "J/m3",
     .title = "Plastic work of the hot spot",
     .meaning = "99.9 percentile by mass of the plastic work per volume at the end"},
    {.name = "hot_spot_temperature_K",
     .unit = "K",
     .meaning = "99.9 percentile by mass of the temperature at the end"},
    {.name = "hot_spot_x_m",
     .unit = "m",
     .meaning =
         "mass centre of what lies above `hot_spot_work_J_m3`, along x (of half a scene: in the half)"},
    {.name = "hot_spot_y_m", .unit = "m", .meaning = "the same along y"},
    {.name = "hot_spot_z_m", .unit = "m", .meaning = "the same along z", .spaces = {Space::three_d}},
};

constexpr double share_above = 0.001;

template <int axes>
struct Spot {
  double value;
  Vec<axes> place;
};

/// The value that a thousandth of the mass exceeds, and the mass centre of that thousandth.
template <int axes>
Spot<axes> hottest(const BasicParticles<axes>& ps, const std::vector<double>& value) {
  std::vector<std::size_t> order(value.size());
  std::iota(order.begin(), order.end(), std::size_t{0});
  std::stable_sort(order.begin(), order.end(),
                   [&](std::size_t a, std::size_t b) { return value[a] > value[b]; });
  const double total = std::accumulate(ps.mass.begin(), ps.mass.end(), 0.0);
  Spot<axes> spot{0, Vec<axes>::Zero()};
  double mass = 0;
  for (const std::size_t p : order) {
    mass += ps.mass[p];
    spot.place += ps.mass[p] * ps.position[p];
    spot.value = value[p];
    if (mass >= share_above * total) break;
  }
  spot.place /= mass;
  return spot;
}

}  // namespace

template <int axes>
std::span<const ResultRow> BasicHotSpots<axes>::results() {
  return rows;
}

template <int axes>
void BasicHotSpots<axes>::finish(const BasicState<axes>& s, RunResult& result) const {
  const auto& ps = s.particles;
  std::vector<double> work(ps.size()), temperature(ps.size());
  const std::span<const double> plastic_work = ps.own_values("plastic_work");
  for (std::size_t p = 0; p < ps.size(); ++p) {
    work[p] = plastic_work.empty() ? 0 : plastic_work[p] * ps.density(p);
    temperature[p] = temperatures_[ps.material_of(p)](ps.dilation[p], ps.energy[p]);
  }
  const Spot<axes> spot = hottest(ps, work);
  result.metrics.push_back(metric(row_of(rows, "hot_spot_work_J_m3"), spot.value));
  result.metrics.push_back(metric(row_of(rows, "hot_spot_x_m"), spot.place.x()));
  result.metrics.push_back(metric(row_of(rows, "hot_spot_y_m"), spot.place.y()));
  if constexpr (axes == 3) result.metrics.push_back(metric(row_of(rows, "hot_spot_z_m"), spot.place.z()));
  result.metrics.push_back(metric(row_of(rows, "hot_spot_temperature_K"), hottest(ps, temperature).value));
}

template class BasicHotSpots<2>;
template class BasicHotSpots<3>;

}  // namespace mpm
