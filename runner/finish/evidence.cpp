#include "runner/finish/evidence.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numeric>

#include "libmpm/io/vtkhdf.hpp"

namespace mpmstudy {
namespace {

std::optional<double> real(const SqlValue& value) {
  if (const auto* number = std::get_if<double>(&value)) return *number;
  if (const auto* integer = std::get_if<std::int64_t>(&value)) return static_cast<double>(*integer);
  return std::nullopt;
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
  for (std::size_t p = 0; p < s.y.size(); ++p) spot.centroid_y += s.mass[p] * s.y[p] / total;
  return spot;
}

}  // namespace

Rows Evidence::ask(const std::string& study, const std::string& sql) const {
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

std::vector<double> Evidence::collapsibilities(const std::string& study, const std::string& order) const {
  return numbers(study,
                 "SELECT collapsibility FROM jobs WHERE study = ?1 AND status = 'done' ORDER BY " + order);
}

std::string Evidence::largest_interval(const std::string& study) const {
  const auto share = number(study,
                            "SELECT max(error / value) FROM accuracy WHERE study = ?1 "
                            "AND quantity = 'collapsibility'");
  return share ? fmt::format("; intervals of at most {:.1f} %", 100 * *share) : "";
}

std::vector<HotSpot> Evidence::hot_spots(const std::string& study) const {
  std::vector<HotSpot> spots;
  const Rows rows = ask(study,
                        "SELECT path FROM snapshots WHERE key = (SELECT key FROM jobs WHERE study = ?1 AND "
                        "status = 'done' ORDER BY position LIMIT 1) ORDER BY time_s");
  for (const auto& row : rows.rows)
    spots.push_back(hot_spot_of(mpm::read_vtkhdf(results_ / std::get<std::string>(row[0]))));
  return spots;
}

}  // namespace mpmstudy
