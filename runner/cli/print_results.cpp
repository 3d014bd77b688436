#include "runner/cli/print_results.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <optional>
#include <vector>

#include "analysis/plot.hpp"
#include "analysis/units.hpp"
#include "libmpm/scene/parameters.hpp"
#include "runner/catalog/found_values.hpp"
#include "runner/catalog/job_rows.hpp"
#include "runner/cli/print_failures.hpp"
#include "runner/cli/text_table.hpp"
#include "runner/finish/fits.hpp"
#include "runner/finish/labels.hpp"
#include "runner/finish/study_results.hpp"
#include "runner/status/label.hpp"
#include "runner/study/gauges.hpp"
#include "runner/study/parameter_value.hpp"
#include "runner/study/readable.hpp"

namespace mpmstudy {
namespace {

constexpr std::int64_t most_rows = 30;  ///< of a table; of more, so many from the start and from the end:
constexpr std::int64_t first_rows = 25, last_rows = 5;
constexpr std::size_t most_results = 5;   ///< columns of results
constexpr std::size_t least_results = 3;  ///< that stay where a line is too long
constexpr int error_digits = 3;
constexpr const char* mark = "*";  ///< behind what a flag is about; the line below says why

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

bool says_whether_a_cavity_is_gone(const std::string& outcome) {
  return outcome == "collapsed" || outcome == "partial";
}

/// Blanks behind the others: digits stand under digits.
void mark_flagged(TextColumn& column, const std::vector<JobRow>& rows) {
  if (std::ranges::all_of(rows, &std::string::empty, &JobRow::flags)) return;
  for (std::size_t i = 0; i < rows.size(); ++i) column.cells[i] += rows[i].flags.empty() ? " " : mark;
}

/// Why numbers are marked: a line per reason, of all jobs of the study.
std::string flags_text(const Study& study, const std::filesystem::path& results) {
  std::string text;
  for (const FlagCount& one : flag_counts(results, study.name))
    text += fmt::format("  {} {}, {}\n", mark, one.flags, counted(one.jobs, "job"));
  return text.empty() ? "" : text + "    such numbers are in no figure and no fit\n";
}

std::vector<TextColumn> columns_of_rows(const Study& study, const std::vector<std::string>& results,
                                        const StudyResults& folder, const std::vector<JobRow>& rows) {
  TextColumn keys{"job", "", {}, true}, outcomes{"outcome", "", {}, true};
  for (const JobRow& row : rows) {
    keys.cells.push_back(short_key(row.key));
    const bool doubtful = !row.flags.empty() && says_whether_a_cavity_is_gone(row.outcome);
    outcomes.cells.push_back(row.status != JobStatus::done ? std::string(to_string(row.status))
                             : row.outcome.empty()         ? "-"
                                                           : row.outcome + (doubtful ? mark : ""));
  }
  std::vector<TextColumn> columns = {std::move(keys)};
  for (std::size_t at = 0; at < study.swept.size(); ++at) {
    const std::string& name = study.swept[at];
    TextColumn column{name, "", {}, false};
    if (const std::string unit = quantity_unit(study, name); !unit.empty()) {
      std::vector<std::optional<double>> values;
      for (const JobRow& row : rows) values.push_back(number_of(row.parameters[at]));
      fill(column, values, study, name, unit);
    } else {
      column.left = true;
      for (const JobRow& row : rows) column.cells.push_back(text_of(row.parameters[at]));
    }
    columns.push_back(std::move(column));
  }
  std::vector<const mpm::Scene*> scenes;
  for (const mpm::Scene& scene : study.scenes) scenes.push_back(&scene);
  for (std::size_t at = 0; at < results.size(); ++at) {
    std::vector<std::optional<double>> values, errors;
    for (const JobRow& row : rows) {
      values.push_back(row.results[at].value);
      errors.push_back(row.results[at].error);
    }
    const std::string& name = results[at];
    const std::string of_gauge = unit_of_gauge(scenes, name);
    const std::string unit = of_gauge.empty() ? unit_of(folder, name) : of_gauge;
    TextColumn column{std::string(analysis::without_unit(name, unit)), "", {}, false};
    fill(column, values, study, "", unit);
    if (is_of_the_final_area(name)) mark_flagged(column, rows);
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

std::vector<std::string> results_of_interest(const Study& study, std::size_t most) {
  std::vector<std::string> names;
  const auto add = [&](const std::string& name) {
    if (!name.empty() && names.size() < most && std::ranges::find(names, name) == names.end())
      names.push_back(name);
  };
  add(study.ladder.quantity);
  if (study.surface) add(study.surface->of);
  for (const auto& fit : study.fits) add(fit.y);
  for (const auto& figure : study.figures)
    if (const FigureKindRow& row = row_of(figure.kind); row.has_x) {
      add(row.has_colour ? figure.colour : figure.y);
      if (row.y == FigureY::result && quantity_unit(study, figure.x).empty()) add(figure.x);
    }
  for (const mpm::Gauge& gauge : study.gauges) {
    for (const mpm::Reduction& reduction : gauge.reductions) add(gauge.name + "." + reduction.name);
    if (gauge.reductions.empty()) add(gauge.name + ".end");
  }
  return names;
}

std::string results_text(const Study& study, const std::filesystem::path& results) {
  const StudyResults folder{study.name, results, {}, 0, {}};
  auto of_interest = results_of_interest(study, most_results);
  const auto count = count_jobs(results, study.name);
  JobRequest request{study.name, study.swept, of_interest};
  request.most = count > most_rows ? first_rows : most_rows;
  auto rows = job_rows(results, request);
  if (count > most_rows) {
    request.most = last_rows;
    request.from = count - last_rows;
    std::ranges::move(job_rows(results, request), std::back_inserter(rows));
  }
  auto columns = columns_of_rows(study, of_interest, folder, rows);
  // what no fit and no figure asks for goes before what tells the rows apart
  const std::size_t asked_for = study.fits.empty() && study.figures.empty() ? 1 : least_results;
  while (table_columns(columns) > line_columns && of_interest.size() > asked_for) {
    of_interest.pop_back();
    columns = columns_of_rows(study, of_interest, folder, rows);
  }
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
    text += fmt::format("  all: mpmstudy query{} \"{}\"\n", results_option(results), readable_sql(request));
  // Of an outcome that flags say nothing of, such as "ejected", and results of another kind nothing is
  // marked.
  if (table.find(mark) != std::string::npos || std::ranges::any_of(of_interest, is_of_the_final_area))
    text += flags_text(study, results);
  if (study.ladder.cells == 1 && table.find("+-") != std::string::npos)
    text +=
        "  +- is the measuring error on these cells only; [numerics] ladder = 3 adds how far cells of other "
        "sizes "
        "are from it\n";
  return text + failures_text(study, results) + fits_text(study, results);
}

std::string brackets_text(const Study& study, const std::filesystem::path& results) {
  const auto unit = mpm::find_quantity(study.search->critical)->unit;
  std::string text;
  for (const BracketRow& row : brackets_of(results, study.name, study.search->critical)) {
    if (row.position >= std::ssize(study.scenes)) continue;  // of an earlier form of the study
    const std::string point = label_of(study.scenes[static_cast<std::size_t>(row.position)], study.swept);
    text +=
        fmt::format("{}{}{} {}{}\n", point, point.empty() ? "" : "  ", study.search->critical,
                    row.lower && row.upper ? readable(*row.lower, unit) + " to " + readable(*row.upper, unit)
                                           : "not found",
                    row.flags.empty() ? "" : "; " + row.flags);
  }
  return text;
}

std::string fits_text(const Study& study, const std::filesystem::path& results) {
  if (study.fits.empty()) return "";
  const StudyResults read = read_results(study, results);
  std::string text;
  for (const FitRequest& request : study.fits) {
    const auto x = label_of_parameter(study, request.x);
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
        text += fmt::format("  {}: no fit, {}\n", what, fit.failure);
    }
  }
  return text;
}

}  // namespace mpmstudy
