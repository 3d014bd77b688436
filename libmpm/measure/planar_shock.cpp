#include "libmpm/measure/planar_shock.hpp"

#include <algorithm>
#include <cmath>

namespace mpm {
namespace {

constexpr ResultRow rows[] = {
    {.name = "shock_normal_stress_Pa",
     .unit = "Pa",
     .meaning = "normal stress behind the plastic front, compression positive",
     .always = false},
    {.name = "shock_pressure_Pa", .unit = "Pa", .symbol = "P", .meaning = "pressure there", .always = false},
    {.name = "shock_von_mises_Pa",
     .unit = "Pa",
     .symbol = "q",
     .meaning = "von Mises stress there",
     .always = false},
    {.name = "plateau_noise",
     .unit = "1",
     .meaning = "rms deviation of the normal stress there / its mean",
     .has_interval = false,
     .lower = 0,
     .always = false},
    {.name = "plastic_wave_speed_m_s",
     .unit = "m/s",
     .meaning = "Lagrangian speed of the plastic front",
     .always = false},
    {.name = "elastic_wave_speed_m_s",
     .unit = "m/s",
     .meaning = "Lagrangian speed of the elastic front; none if overdriven",
     .always = false},
    {.name = "elastic_limit_stress_Pa",
     .unit = "Pa",
     .meaning = "normal stress behind the elastic precursor, compression positive",
     .always = false},
    {.name = "free_surface_speed_m_s",
     .unit = "m/s",
     .meaning = "speed of the free surface after the shock, against the moving body",
     .always = false},
};

constexpr std::size_t most_gauges = 128;

/// Slope of the least-squares line through (x, y).
double slope(const std::vector<double>& x, const std::vector<double>& y) {
  double mx = 0, my = 0, xx = 0, xy = 0;
  for (std::size_t k = 0; k < x.size(); ++k) mx += x[k] / x.size(), my += y[k] / x.size();
  for (std::size_t k = 0; k < x.size(); ++k) xx += (x[k] - mx) * (x[k] - mx), xy += (x[k] - mx) * (y[k] - my);
  return xy / xx;
}

}  // namespace

template <int axes>
std::span<const ResultRow> BasicPlanarShock<axes>::results() {
  return rows;
}

template <int axes>
BasicPlanarShock<axes>::BasicPlanarShock(const Scene& s, const State& state)
    : height_(s.block_height), impact_speed_(s.impact_speed) {
  // Uniaxial strain: sigma = (K + 4G/3) eps up to q = 2 G eps = Y.
  const Material& m = s.material;
  const double bulk = m.reference_density * m.bulk_sound_speed * m.bulk_sound_speed;
  const double longitudinal = bulk + 4 * m.shear_modulus() / 3;
  elastic_limit_ = longitudinal * m.yield_stress / (2 * m.shear_modulus());
  elastic_speed_ = std::sqrt(longitudinal / m.reference_density);

  const auto& x = state.particles.position;
  Vec<axes> column = x[0];  // nearest to the middle
  for (const Vec<axes>& p : x)
    for (int k = 0; k < axes; ++k)
      if (std::abs(p[k]) < std::abs(column[k])) column[k] = p[k];
  std::vector<std::size_t> all;
  for (std::size_t p = 0; p < x.size(); ++p) {
    bool there = x[p].x() == column.x();
    if constexpr (axes == 3) there &= x[p].z() == column.z();
    if (there) all.push_back(p);
  }
  std::sort(all.begin(), all.end(), [&](std::size_t a, std::size_t b) { return x[a].y() < x[b].y(); });
  top_ = all.back();
  const std::size_t stride = (all.size() + most_gauges - 1) / most_gauges;
  for (std::size_t k = stride / 2; k < all.size(); k += stride) {
    gauges_.push_back(all[k]);
    gauge_height_.push_back(x[all[k]].y());
  }
  watched_ = gauges_;
  watched_.push_back(top_);
}

template <int axes>
void BasicPlanarShock<axes>::after_step(const State& s, const StepReport&, double) {
  const auto& ps = s.particles;
  times_.push_back(s.time);
  top_speed_.push_back(ps.velocity[top_].y() + impact_speed_);
  for (const std::size_t p : gauges_)
    readings_.push_back({-ps.stress(p).yy, ps.pressure[p], von_mises(ps.deviator[p])});
}

template <int axes>
std::size_t BasicPlanarShock<axes>::first_gauge_above(double height) const {
  return static_cast<std::size_t>(std::lower_bound(gauge_height_.begin(), gauge_height_.end(), height) -
                                  gauge_height_.begin());
}

template <int axes>
double BasicPlanarShock<axes>::arrival(std::size_t gauge, double stress) const {
  for (std::size_t k = 1; k < times_.size(); ++k) {
    const double before = readings_[(k - 1) * gauges_.size() + gauge].normal_stress;
    const double after = readings_[k * gauges_.size() + gauge].normal_stress;
    if (after >= stress) {
      const double part = after > before ? (stress - before) / (after - before) : 1;
      return times_[k - 1] + std::clamp(part, 0.0, 1.0) * (times_[k] - times_[k - 1]);
    }
  }
  return -1;
}

template <int axes>
double BasicPlanarShock<axes>::front_speed(double stress) const {
  std::vector<double> heights, arrivals;
  for (std::size_t g = first_gauge_above(0.5 * height_); g < first_gauge_above(0.8 * height_); ++g) {
    const double t = arrival(g, stress);
    if (t < 0) return 0;
    heights.push_back(gauge_height_[g]);
    arrivals.push_back(t);
  }
  return heights.size() < 2 ? 0 : 1 / slope(heights, arrivals);
}

template <int axes>
double BasicPlanarShock<axes>::stress_at(std::size_t gauge, double time) const {
  const auto after = std::upper_bound(times_.begin() + 1, times_.end() - 1, time);
  const auto k = static_cast<std::size_t>(after - times_.begin());
  const double left = readings_[(k - 1) * gauges_.size() + gauge].normal_stress;
  const double right = readings_[k * gauges_.size() + gauge].normal_stress;
  return left + (right - left) * (time - times_[k - 1]) / (times_[k] - times_[k - 1]);
}

template <int axes>
double BasicPlanarShock<axes>::stress_between(double elastic_level, double plastic_level) const {
  constexpr int parts = 40, width = 4;
  double sum = 0, count = 0;
  for (std::size_t g = first_gauge_above(0.7 * height_); g < first_gauge_above(0.8 * height_); ++g) {
    const double first = arrival(g, elastic_level), second = arrival(g, plastic_level);
    if (first < 0 || second < 0) return 0;
    double least = plastic_level, flattest = 0;
    for (int k = 0; k + width <= parts; ++k) {
      const double from = stress_at(g, first + (second - first) * k / parts);
      const double to = stress_at(g, first + (second - first) * (k + width) / parts);
      if (to - from < least) least = to - from, flattest = 0.5 * (from + to);
    }
    sum += flattest;
    ++count;
  }
  return count > 0 ? sum / count : 0;
}

template <int axes>
void BasicPlanarShock<axes>::finish(const State&, RunResult& result) const {
  if (times_.size() < 2) return;
  const std::size_t low = first_gauge_above(0.15 * height_), high = first_gauge_above(0.45 * height_),
                    watch = first_gauge_above(0.6 * height_);
  if (low >= high || watch >= gauges_.size()) return;

  const auto mean_at = [&](std::size_t step) {
    Reading mean{};
    const double share = 1.0 / static_cast<double>(high - low);
    for (std::size_t g = low; g < high; ++g) {
      const Reading& r = readings_[step * gauges_.size() + g];
      mean.normal_stress += share * r.normal_stress;
      mean.pressure += share * r.pressure;
      mean.von_mises += share * r.von_mises;
    }
    return mean;
  };
  const auto plastic_level = [&](double plateau) {
    return 0.5 * (std::min(elastic_limit_, plateau) + plateau);
  };
  // The plateau sets the level at which the plastic front is seen, the front the time at which the plateau is
  // read. The highest mean of the run is close enough to the plateau to begin with.
  Reading mean{};
  for (std::size_t k = 0; k < times_.size(); ++k)
    mean.normal_stress = std::max(mean.normal_stress, mean_at(k).normal_stress);
  const double seen = arrival(watch, plastic_level(mean.normal_stress));
  if (seen < 0) return;
  const auto step =
      static_cast<std::size_t>(std::lower_bound(times_.begin(), times_.end(), seen) - times_.begin());
  mean = mean_at(step);
  const double level = plastic_level(mean.normal_stress);
  double square = 0;
  for (std::size_t g = low; g < high; ++g) {
    const double d = readings_[step * gauges_.size() + g].normal_stress - mean.normal_stress;
    square += d * d / static_cast<double>(high - low);
  }
  const double noise = std::sqrt(square) / mean.normal_stress;

  const auto add = [&](const ResultRow& row, double value) { result.metrics.push_back(metric(row, value)); };
  add(row_of(rows, "shock_normal_stress_Pa"), mean.normal_stress);
  add(row_of(rows, "shock_pressure_Pa"), mean.pressure);
  add(row_of(rows, "shock_von_mises_Pa"), mean.von_mises);
  add(row_of(rows, "plateau_noise"), noise);

  const double plastic = front_speed(level);
  if (plastic > 0) add(row_of(rows, "plastic_wave_speed_m_s"), plastic);
  const double elastic_level = 0.5 * std::min(elastic_limit_, mean.normal_stress);
  const double elastic = front_speed(elastic_level);
  if (elastic > 0 && plastic < elastic_speed_) {
    add(row_of(rows, "elastic_wave_speed_m_s"), elastic);
    const double limit = stress_between(elastic_level, level);
    if (limit > 0 && mean.normal_stress > elastic_limit_) add(row_of(rows, "elastic_limit_stress_Pa"), limit);
  }

  if (plastic > 0) {
    const double transit = height_ / plastic;
    const double from = 1.5 * transit, to = 1.75 * transit;
    double sum = 0, count = 0;
    for (std::size_t k = 0; k < times_.size(); ++k)
      if (times_[k] >= from && times_[k] <= to) sum += top_speed_[k], ++count;
    if (count > 0 && times_.back() >= to) add(row_of(rows, "free_surface_speed_m_s"), sum / count);
  }
}

template <int axes>
void BasicPlanarShock<axes>::carry(Archive& a) {
  a.numbers("times", times_), a.numbers("top_speed", top_speed_), a.numbers("readings", readings_);
}

template class BasicPlanarShock<2>;
template class BasicPlanarShock<3>;

}  // namespace mpm
