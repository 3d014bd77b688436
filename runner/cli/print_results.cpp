#include "runner/cli/print_results.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <optional>
#include <vector>

#include "analysis/plot.hpp"
#include "analysis/units.hpp"
#include "libmpm/measure/results.hpp"
#include "libmpm/scene/parameters.hpp"
#include "runner/catalog/query.hpp"
#include "runner/cli/print_failures.hpp"
#include "runner/cli/text_table.hpp"
#include "runner/finish/fits.hpp"
#include "runner/finish/labels.hpp"
#include "runner/finish/study_results.hpp"
#include "runner/status/label.hpp"

namespace mpmstudy {
namespace {

constexpr std::int64_t most_rows = 30;  ///< of a table; of more, so many from the start and from the end:
constexpr std::int64_t first_rows = 25, last_rows = 5;
constexpr std::size_t most_results = 3;  ///< columns of results
constexpr int error_digits = 3;
constexpr std::size_t first_parameter = 4;  ///< in a row of select()
constexpr const char* mark = "*";           ///< behind what a flag is about; the line below says why

/// A column of the view `jobs`, or a metric.
struct Result {
  std::string name;
  std::string value, error;  ///< as SQL over `jobs j`
};

Result result_named(const std::string& name, const std::vector<std::string>& columns_of_jobs) {
  if (std::ranges::find(columns_of_jobs, name) != columns_of_jobs.end()) {
    const mpm::ResultRow* row = mpm::find_result(name);
    const bool has_error = row && !row->error_column.empty();
    return {name, "j." + name, has_error ? "j." + std::string(row->error_column) : "NULL"};
  }
  const auto of_metric = [&](const char* what) {
    return fmt::format("(SELECT m.{} FROM metrics m WHERE m.key = j.key AND m.name = '{}')", what, name);
  };
  return {name, of_metric("value"), of_metric("error")};
}

/// The headline of the scene, then what the study fits and draws.
std::vector<Result> results_of_interest(const Study& study, const std::filesystem::path& folder) {
  std::vector<std::string> names;
  const auto add = [&](const std::string& name) {
    if (!name.empty() && names.size() < most_results && std::ranges::find(names, name) == names.end())
      names.push_back(name);
  };
  add(study.ladder.quantity);
  for (const auto& fit : study.fits) add(fit.y);
  for (const auto& figure : study.figures)
    if (figure.kind == "xy") add(figure.y);
  const auto columns = query(folder, "SELECT * FROM jobs LIMIT 0").names;
  std::vector<Result> results;
  for (const auto& name : names) results.push_back(result_named(name, columns));
  return results;
}

std::string column_of_jobs(const std::string& parameter) {
  if (const auto* quantity = mpm::find_quantity(parameter)) return std::string(quantity->column);
  return std::string(mpm::find_choice(parameter)->column);
}

/// What the table's rows are asked by: key, status, outcome, flags, then parameters, then value and error of
/// each result.
std::string select(const Study& study, const std::vector<Result>& results) {
  std::string sql = "SELECT j.key, j.status, j.outcome, j.flags";
  for (const auto& name : study.swept) sql += ", j.\"" + column_of_jobs(name) + "\"";
  for (const auto& result : results) sql += ", " + result.value + ", " + result.error;
  return sql + " FROM jobs j WHERE j.study = ?1 ORDER BY j.position, j.key";
}

/// The same for people: names in place of SQL.
std::string readable_query(const Study& study, const std::vector<Result>& results,
                           const std::filesystem::path& folder) {
  std::string columns = "key, status, outcome, flags";
  for (const auto& name : study.swept) columns += ", " + column_of_jobs(name);
  for (const auto& result : results) {
    const bool of_jobs = result.value.starts_with("j.");
    if (!of_jobs) continue;
    columns += ", " + result.name;
    if (result.error != "NULL") columns += ", " + result.error.substr(2);
  }
  return fmt::format("mpmstudy query{} \"SELECT {} FROM jobs WHERE study = '{}' ORDER BY position\"",
                     results_option(folder), columns, study.name);
}

/// Numbers of one column in the unit that the study's file writes, else in one that keeps them short.
void fill(TextColumn& column, const std::vector<std::optional<double>>& values, const Study& study,
          const std::string& parameter, std::string_view si_unit) {
  double factor = 1, offset = 0;
  const auto written = study.units.find(parameter);
  if (written != study.units.end()) {
    factor = 1 / written->second.slope;
    offset = written->second.offset;
    column.unit = written->second.text;
  } else {
    double largest = 0;
    for (const auto& value : values)
      if (value && std::isfinite(*value)) largest = std::max(largest, std::abs(*value));
    const auto unit = analysis::display_unit(si_unit, largest);
    factor = unit.factor;
    column.unit = unit.text == "1" ? "" : unit.text;
  }
  std::vector<double> shown;
  for (const auto& value : values)
    if (value) shown.push_back((*value - offset) * factor);
  const auto texts = distinct_texts(shown);
  std::size_t next = 0;
  for (const auto& value : values) column.cells.push_back(value ? texts[next++] : "-");
}

/// The half widths beside a column of values, in its unit.
TextColumn errors_beside(const std::vector<std::optional<double>>& values,
                         const std::vector<std::optional<double>>& errors, std::string_view si_unit) {
  double largest = 0;
  for (const auto& value : values)
    if (value && std::isfinite(*value)) largest = std::max(largest, std::abs(*value));
  const auto unit = analysis::display_unit(si_unit, largest);
  const double factor = unit.factor;
  TextColumn column{"+-", unit.text, {}, false};
  for (const auto& error : errors)
    column.cells.push_back(error ? fmt::format("{:.{}g}", *error * factor, error_digits) : "-");
  return column;
}

bool is_flagged(const std::vector<SqlValue>& row) { return !text_of(row[3]).empty(); }

bool says_whether_a_cavity_is_gone(const std::string& outcome) {
  return outcome == "collapsed" || outcome == "partial";
}

/// Blanks behind the others: digits stand under digits.
void mark_flagged(TextColumn& column, const std::vector<std::vector<SqlValue>>& rows) {
  if (std::ranges::none_of(rows, is_flagged)) return;
  for (std::size_t i = 0; i < rows.size(); ++i) column.cells[i] += is_flagged(rows[i]) ? mark : " ";
}

/// Why numbers are marked: a line per reason, of all jobs of the study.
std::string flags_text(const Study& study, const std::filesystem::path& results) {
  const SqlValue name = study.name;
  std::string text;
  for (const auto& row :
       query(results,
             "SELECT flags, count(*) FROM jobs WHERE study = ?1 AND status = 'done' AND flags "
             "<> '' GROUP BY flags ORDER BY min(position)",
             std::span(&name, 1))
           .rows)
    text +=
        fmt::format("  {} {}, {}\n", mark, text_of(row[0]), counted(std::get<std::int64_t>(row[1]), "job"));
  return text.empty() ? "" : text + "    such numbers are in no figure and no fit\n";
}

std::vector<TextColumn> columns_of_rows(const Study& study, const std::vector<Result>& results,
                                        const StudyResults& folder,
                                        const std::vector<std::vector<SqlValue>>& rows) {
  TextColumn keys{"job", "", {}, true}, outcomes{"outcome", "", {}, true};
  for (const auto& row : rows) {
    keys.cells.push_back(short_key(text_of(row[0])));
    const std::string status = text_of(row[1]), outcome = text_of(row[2]);
    const bool doubtful = is_flagged(row) && says_whether_a_cavity_is_gone(outcome);
    outcomes.cells.push_back(status != "done"  ? status
                             : outcome.empty() ? "-"
                                               : outcome + (doubtful ? mark : ""));
  }
  std::vector<TextColumn> columns = {std::move(keys)};
  std::size_t at = first_parameter;
  const auto numbers = [&](std::size_t column) {
    std::vector<std::optional<double>> values;
    for (const auto& row : rows) values.push_back(number_of(row[column]));
    return values;
  };
  for (const auto& name : study.swept) {
    TextColumn column{name, "", {}, false};
    if (const auto* quantity = mpm::find_quantity(name)) {
      fill(column, numbers(at), study, name, quantity->unit);
    } else {
      column.left = true;
      for (const auto& row : rows) column.cells.push_back(text_of(row[at]));
    }
    ++at;
    columns.push_back(std::move(column));
  }
  for (const auto& result : results) {
    const auto values = numbers(at), errors = numbers(at + 1);
    at += 2;
    const std::string unit = unit_of(folder, result.name);
    TextColumn column{std::string(analysis::without_unit(result.name, unit)), "", {}, false};
    fill(column, values, study, "", unit);
    if (is_of_the_final_area(result.name)) mark_flagged(column, rows);
    columns.push_back(std::move(column));
    if (std::ranges::any_of(errors, [](const auto& error) { return error.has_value(); }))
      columns.push_back(errors_beside(values, errors, unit));
  }
  columns.push_back(std::move(outcomes));
  return columns;
}

/// Swept columns go, the last first, until a line fits; their names.
std::string make_narrow(std::vector<TextColumn>& columns, std::size_t swept) {
  std::string gone;
  while (swept > 1 && table_columns(columns) > line_columns) {
    const auto last = columns.begin() + static_cast<std::ptrdiff_t>(swept);
    gone = last->name + (gone.empty() ? "" : ", " + gone);
    columns.erase(last);
    --swept;
  }
  return gone;
}

double largest_of(const std::vector<double>& numbers) {
  double largest = 0;
  for (const double number : numbers) largest = std::max(largest, std::abs(number));
  return largest;
}

}  // namespace

std::string results_text(const Study& study, const std::filesystem::path& results) {
  const StudyResults folder{study.name, results, {}, 0, {}};
  const auto of_interest = results_of_interest(study, results);
  const SqlValue name = study.name;
  const auto parameters = std::span(&name, 1);
  const auto count = std::get<std::int64_t>(
      query(results, "SELECT count(*) FROM jobs WHERE study = ?1", parameters).rows.at(0).at(0));
  const std::string sql = select(study, of_interest);
  auto rows =
      query(results, fmt::format("{} LIMIT {}", sql, count > most_rows ? first_rows : most_rows), parameters)
          .rows;
  if (count > most_rows) {
    auto last =
        query(results, fmt::format("{} LIMIT {} OFFSET {}", sql, last_rows, count - last_rows), parameters)
            .rows;
    std::ranges::move(last, std::back_inserter(rows));
  }
  auto columns = columns_of_rows(study, of_interest, folder, rows);
  const std::string gone = make_narrow(columns, study.swept.size());
  std::string table = text_table(columns);
  if (count > most_rows) {
    std::size_t end = table.size();
    for (std::int64_t line = 0; line <= last_rows; ++line) end = table.rfind('\n', end - 1);
    table.insert(end + 1, fmt::format("  ... {} more\n", count - first_rows - last_rows));
  }
  std::string text = fmt::format("\n{}: {}\n", study.name, study.title) + table;
  if (!gone.empty()) text += cut_text("  not shown: " + gone, line_columns) + "\n";
  if (count > most_rows || !gone.empty())
    text += "  all: " + readable_query(study, of_interest, results) + "\n";
  // Of an outcome that flags say nothing of, such as "ejected", and results of another kind nothing is
  // marked.
  if (table.find(mark) != std::string::npos ||
      std::ranges::any_of(of_interest, [](const auto& one) { return is_of_the_final_area(one.name); }))
    text += flags_text(study, results);
  if (study.ladder.cells == 1 && table.find("+-") != std::string::npos)
    text +=
        "  +- is the measuring error on these cells only; [numerics] ladder = 3 adds how far cells of other "
        "sizes "
        "are from it\n";
  return text + failures_text(study, results) + fits_text(study, results);
}

std::string fits_text(const Study& study, const std::filesystem::path& results) {
  if (study.fits.empty()) return "";
  const StudyResults read = read_results(study, results);
  std::string text;
  for (const FitRequest& request : study.fits) {
    const auto x = label_of(request.x, mpm::find_quantity(request.x)->unit);
    const auto y = label_of(request.y, unit_of(read, request.y));
    for (const Group& group : group_jobs(study, read, curve_of(study, request.x, request.y))) {
      const Column c = column_of(read, group, request.x, request.y);
      if (c.x.empty() && stands_elsewhere(group, request.y)) continue;
      const analysis::Fit fit = fit_column(request, c);
      const std::string what = fmt::format("{} of {} against {}{}", request.model, request.y, request.x,
                                           group.label.empty() ? "" : ", " + group.label);
      if (fit.ok())
        text += fmt::format("  {}: {}\n", what,
                            analysis::fit_caption(fit, x, analysis::display_unit(x.unit, largest_of(c.x)), y,
                                                  analysis::display_unit(y.unit, largest_of(c.y))));
      else
        text += fmt::format("  {}: no fit, {}\n", what, fit.problem);
    }
  }
  return text;
}

}  // namespace mpmstudy
