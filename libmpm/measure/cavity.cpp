#include "libmpm/measure/cavity.hpp"

#include <algorithm>
#include <cmath>

namespace mpm {
namespace {

double center_of_mass_height(const Particles& ps) {
  double mass = 0, moment = 0;
  for (std::size_t p = 0; p < ps.size(); ++p) {
    mass += ps.mass[p];
    moment += ps.mass[p] * ps.position[p].y();
  }
  return moment / mass;
}

constexpr double window = 0.25;  ///< share of the run that counts as its end

}  // namespace

Cavity::Cavity(const Scene& s, const State& state, bool open_below)
    : open_below_(open_below),
      contour_(Vec2(0, s.cavity_center_height), s.cavity_radius, s.numerics.cell_size,
               s.numerics.symmetry == Symmetry::half),
      void_(Vec2(0, s.cavity_center_height), s.cavity_radius, s.numerics.symmetry == Symmetry::full,
            s.numerics.particles_per_cell),
      jet_(s),
      initial_offset_(contour_.centroid().y() - center_of_mass_height(state.particles)),
      smallest_area_(contour_.area()),
      smallest_sample_(smallest_area_) {}

void Cavity::after_step(const State& s, const StepReport&, double dt) {
  contour_.advance(s.grid, dt);
  if (crossed_time_ < 0) smallest_area_ = std::min(smallest_area_, std::max(contour_.area(), 0.0));
}

bool Cavity::joined_outside() const {
  return void_.joined_outside() || (open_below_ && void_.touches_wall());
}

void Cavity::sample(const State& s, Observer& observer) {
  const AreaSample now{s.time, contour_.area(), void_.update(s)};
  if (now.void_area == 0 && closed_time_ < 0) closed_time_ = s.time;
  if (joined_outside() && joined_time_ < 0) joined_time_ = s.time;
  if (crossed_time_ < 0 && contour_.crosses_itself()) crossed_time_ = s.time;
  if (topology_time_ < 0 && std::max({closed_time_, joined_time_, crossed_time_}) >= 0)
    topology_time_ = s.time;
  if (topology_time_ < 0) area_difference_ = std::max(area_difference_, std::abs(now.void_area - now.area));
  const bool itself = now.void_area > 0 && !void_.joined_outside() && !void_.touches_wall();
  const int others = void_.closed_regions() - (itself ? 1 : 0);
  most_new_ = std::max(most_new_, others);
  if (others > 0 && new_time_ < 0) new_time_ = s.time;
  jet_.sample(s, contour_);
  if (crossed_time_ < 0 && now.area < smallest_sample_) {
    smallest_sample_ = now.area;
    smallest_difference_ = std::abs(now.void_area - now.area);
  }
  history_.push_back(now);
  observer.on_area(now);
}

void Cavity::finish(const State& s, RunResult& result) const {
  // the last sample, if a run that was stopped has none in the window
  const double start = std::min((1 - window) * s.time, history_.back().time);
  const auto area_of = [this](const AreaSample& a) {
    return crossed_time_ >= 0 && a.time >= crossed_time_ ? a.void_area : a.area;
  };
  double count = 0, sum = 0, sum_of_squares = 0, difference = 0;
  for (const AreaSample& a : history_) {
    if (a.time < start) continue;
    ++count;
    sum += area_of(a);
    difference += a.void_area - a.area;
  }
  const double final_area = sum / count;
  for (const AreaSample& a : history_)
    if (a.time >= start) sum_of_squares += (area_of(a) - final_area) * (area_of(a) - final_area);
  const double scatter = std::sqrt(sum_of_squares / count);
  const double error = std::hypot(scatter, difference / count);
  const double initial_area = history_.front().area;

  result.initial_area = initial_area;
  result.final_area = final_area;
  result.final_area_error = error;
  result.collapsibility = (initial_area - final_area) / initial_area;
  result.collapsibility_error = error / initial_area;
  result.outcome = history_.back().void_area == 0 ? "collapsed" : "partial";

  auto& m = result.metrics;
  m.push_back({"final_area_scatter_m2", scatter, "m2", {}});
  m.push_back({"final_area_difference_m2", std::abs(difference / count), "m2", {}});
  m.push_back({"largest_collapsibility", (initial_area - smallest_area_) / initial_area, "1",
               smallest_difference_ / initial_area});
  if (crossed_time_ < 0) {
    m.push_back({"aspect_ratio", contour_.width() / contour_.height(), "1", {}});
    m.push_back({"lower_upper_area_ratio", contour_.lower_upper_ratio(), "1", {}});
    m.push_back({"centroid_shift_m",
                 contour_.centroid().y() - center_of_mass_height(s.particles) - initial_offset_,
                 "m",
                 {}});
  } else {
    m.push_back({"contour_crossed_time_s", crossed_time_, "s", {}});
  }
  m.push_back({"area_difference_m2", area_difference_, "m2", {}});
  if (topology_time_ >= 0) m.push_back({"topology_changed_time_s", topology_time_, "s", {}});
  m.push_back({"final_void_area_m2", history_.back().void_area, "m2", {}});
  m.push_back({"new_cavities", static_cast<double>(most_new_), "1", {}});
  if (new_time_ >= 0) m.push_back({"new_cavities_time_s", new_time_, "s", {}});
  m.push_back({"cavities_at_end", static_cast<double>(void_.closed_regions()), "1", {}});
  jet_.finish(result);
  if (closed_time_ >= 0) m.push_back({"cavity_closed_time_s", closed_time_, "s", {}});
  if (joined_time_ >= 0) m.push_back({"cavity_joined_outside_time_s", joined_time_, "s", {}});
  result.area_history = history_;
}

void Cavity::carry(Archive& a) {
  Archive contour = a.part("contour"), empty = a.part("void"), jet = a.part("jet");
  contour_.carry(contour), void_.carry(empty), jet_.carry(jet);
  a.numbers("history", history_);
  a.number("smallest_area", smallest_area_), a.number("smallest_difference", smallest_difference_);
  a.number("smallest_sample", smallest_sample_);
  a.integer("most_new", most_new_), a.number("new_time", new_time_);
  a.number("closed_time", closed_time_), a.number("joined_time", joined_time_);
  a.number("crossed_time", crossed_time_), a.number("topology_time", topology_time_);
  a.number("area_difference", area_difference_);
}

}  // namespace mpm
