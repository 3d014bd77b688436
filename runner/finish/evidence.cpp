#include "runner/finish/evidence.hpp"

#include <fmt/format.h>

#include "libmpm/io/vtkhdf.hpp"

namespace mpmstudy {
namespace {

std::optional<double> real(const SqlValue& value) {
  if (const auto* number = std::get_if<double>(&value)) return *number;
  if (const auto* integer = std::get_if<std::int64_t>(&value)) return static_cast<double>(*integer);
  return std::nullopt;
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

}  // namespace mpmstudy
