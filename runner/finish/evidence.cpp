#include "runner/finish/evidence.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numeric>

#include "analysis/empty_regions.hpp"
#include "libmpm/io/vtkhdf.hpp"
#include "runner/finish/fields.hpp"

namespace mpmstudy {
namespace {

std::optional<double> real(const SqlValue& value) {
  if (const auto* number = std::get_if<double>(&value)) return *number;
  if (const auto* integer = std::get_if<std::int64_t>(&value)) return static_cast<double>(*integer);
  return std::nullopt;
}

/// Of what lies within a radius of a point of the right half.
double rotation_about(const mpm::Snapshot& s, double x, double y, double radius) {
  const auto near = [&](std::size_t p) { return std::hypot(s.x[p] - x, s.y[p] - y) < radius; };
  double mass = 0, center_x = 0, center_y = 0, u = 0, v = 0;
  for (std::size_t p = 0; p < s.x.size(); ++p) {
    if (!near(p)) continue;
    mass += s.mass[p];
    center_x += s.mass[p] * s.x[p];
    center_y += s.mass[p] * s.y[p];
    u += s.mass[p] * s.velocity_x[p];
    v += s.mass[p] * s.velocity_y[p];
  }
  if (!(mass > 0)) return 0;
  double momentum = 0, inertia = 0;
  for (std::size_t p = 0; p < s.x.size(); ++p) {
    if (!near(p)) continue;
    const double dx = s.x[p] - center_x / mass, dy = s.y[p] - center_y / mass;
    momentum += s.mass[p] * (dx * (s.velocity_y[p] - v / mass) - dy * (s.velocity_x[p] - u / mass));
    inertia += s.mass[p] * (dx * dx + dy * dy);
  }
  return inertia > 0 ? momentum / inertia : 0;
}

HotSpot hot_spot_of(const mpm::Snapshot& s) {
  constexpr double share = 0.001;
  std::vector<std::size_t> order(s.x.size());
  std::iota(order.begin(), order.end(), std::size_t{0});
  std::ranges::stable_sort(order, std::greater<>(), [&](std::size_t p) { return s.plastic_work[p]; });
  const double total = std::accumulate(s.mass.begin(), s.mass.end(), 0.0);
  HotSpot spot{s.time, 0, 0, 0};
  double mass = 0;
  for (const std::size_t p : order) {
    mass += s.mass[p];
    spot.x += s.mass[p] * std::abs(s.x[p]);
    spot.y += s.mass[p] * s.y[p];
    if (mass >= share * total) break;
  }
  spot.x /= mass;
  spot.y /= mass;
  spot.rotation = rotation_about(s, spot.x, spot.y, spot.x / 2);
  return spot;
}

Cavities cavities_of(const mpm::Snapshot& s, double cell) {
  constexpr int pixels_per_cell = 2;
  const analysis::Particles particles = particles_of(s, "density");
  const bool mirrored = std::ranges::min(s.x) >= 0;
  const analysis::Window window = analysis::window_of({&particles}, mirrored);
  const auto pixels = [&](double length) {
    return std::max(1, static_cast<int>(std::lround(length / cell * pixels_per_cell)));
  };
  const auto areas = analysis::closed_empty_regions(
      analysis::rasterise(particles, mirrored, window, pixels(window.width()), pixels(window.height())),
      window);
  const auto end = std::ranges::find_if(areas, [&](double area) { return area < cell * cell; });
  return {s.time, end - areas.begin(), end == areas.begin() ? 0 : areas.front(),
          std::accumulate(areas.begin(), end, 0.0)};
}

}  // namespace

Evidence::Evidence(std::filesystem::path results, const std::vector<Study>& studies)
    : results_(std::move(results)) {
  for (const Study& study : studies) standings_[study.name] = standing_of(study, results_);
}

const StudyStanding& Evidence::standing(const std::string& study) const {
  static const StudyStanding unknown{Standing::other, "its study file is not among those given"};
  const auto found = standings_.find(study);
  return found == standings_.end() ? unknown : found->second;
}

Rows Evidence::ask(const std::string& study, const std::string& sql) const {
  if (standing(study).standing != Standing::whole) return {};
  const SqlValue name = study;
  return query(results_, sql, std::span(&name, 1));
}

std::optional<double> Evidence::number(const std::string& study, const std::string& sql) const {
  const Rows rows = ask(study, sql);
  return rows.rows.empty() ? std::nullopt : real(rows.rows[0][0]);
}

std::optional<std::string> Evidence::text(const std::string& study, const std::string& sql) const {
  const Rows rows = ask(study, sql);
  if (rows.rows.empty()) return std::nullopt;
  const auto* text = std::get_if<std::string>(&rows.rows[0][0]);
  return text ? std::optional(*text) : std::nullopt;
}

std::vector<double> Evidence::numbers(const std::string& study, const std::string& sql) const {
  std::vector<double> values;
  for (const auto& row : ask(study, sql).rows)
    if (const auto value = real(row[0])) values.push_back(*value);
  return values;
}

std::vector<double> Evidence::metrics(const std::string& study, const std::string& name,
                                      const std::string& order, const std::string& condition) const {
  return numbers(study,
                 "SELECT m.value FROM jobs j JOIN metrics m USING (key) WHERE j.study = ?1 AND j.status = "
                 "'done' AND m.name = '" +
                     name + "' AND " + condition + " ORDER BY j." + order);
}

std::optional<double> Evidence::metric(const std::string& study, const std::string& name,
                                       const std::string& condition) const {
  const auto values = metrics(study, name, "position", condition);
  return values.empty() ? std::nullopt : std::optional(values.front());
}

std::vector<Measured> Evidence::with_errors(const std::string& study, const std::string& sql) const {
  std::vector<Measured> all;
  for (const auto& row : ask(study, sql).rows)
    if (const auto value = real(row[0])) all.push_back({*value, real(row[1])});
  return all;
}

std::vector<Measured> Evidence::measured(const std::string& study, const std::string& name,
                                         const std::string& order, const std::string& condition) const {
  return with_errors(study,
                     "SELECT m.value, m.error FROM jobs j JOIN metrics m USING (key) WHERE j.study = ?1 AND "
                     "j.status = 'done' AND m.name = '" +
                         name + "' AND " + condition + " ORDER BY j." + order);
}

std::vector<Measured> Evidence::collapsibilities(const std::string& study, const std::string& order) const {
  return with_errors(study,
                     "SELECT collapsibility, collapsibility_error FROM jobs WHERE study = ?1 AND status = "
                     "'done' AND (flags IS NULL OR flags = '') ORDER BY " +
                         order);
}

std::string Evidence::largest_interval(const std::string& study) const {
  const auto share = number(study,
                            "SELECT max(error / value) FROM accuracy WHERE study = ?1 "
                            "AND quantity = 'collapsibility'");
  return share ? fmt::format("; intervals of at most {:.1f} %", 100 * *share) : "";
}

void Evidence::each_snapshot(const std::string& study,
                             const std::function<void(const mpm::Snapshot&)>& visit) const {
  const Rows rows = ask(study,
                        "SELECT path FROM snapshots WHERE key = (SELECT key FROM jobs WHERE study = ?1 AND "
                        "status = 'done' ORDER BY position LIMIT 1) ORDER BY time_s");
  for (const auto& row : rows.rows) visit(mpm::read_vtkhdf(results_ / std::get<std::string>(row[0])));
}

std::vector<HotSpot> Evidence::hot_spots(const std::string& study) const {
  std::vector<HotSpot> spots;
  each_snapshot(study, [&](const mpm::Snapshot& s) { spots.push_back(hot_spot_of(s)); });
  return spots;
}

std::vector<Cavities> Evidence::cavities(const std::string& study) const {
  const auto cell = number(
      study, "SELECT cell_size_m FROM jobs WHERE study = ?1 AND status = 'done' ORDER BY position LIMIT 1");
  std::vector<Cavities> cavities;
  if (cell) each_snapshot(study, [&](const mpm::Snapshot& s) { cavities.push_back(cavities_of(s, *cell)); });
  return cavities;
}

}  // namespace mpmstudy
