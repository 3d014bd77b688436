#include "runner/finish/report.hpp"

#include <fmt/format.h>
#include <xxhash.h>

#include <algorithm>
#include <cmath>
#include <fstream>
#include <set>

#include "analysis/page.hpp"
#include "analysis/raster.hpp"
#include "analysis/units.hpp"
#include "libmpm/io/vtkhdf.hpp"
#include "libmpm/scene/parameters.hpp"
#include "runner/catalog/query.hpp"
#include "runner/exec/git_revision.hpp"
#include "runner/finish/fields.hpp"
#include "runner/finish/figures.hpp"
#include "runner/finish/fits.hpp"
#include "runner/finish/labels.hpp"
#include "runner/finish/standing.hpp"
#include "runner/finish/study_results.hpp"
#include "runner/plan/plan.hpp"

namespace mpmstudy {
namespace {

namespace fs = std::filesystem;

std::string shown(const SqlValue& value) {
  if (const auto* real = std::get_if<double>(&value)) return fmt::format("{:.6g}", *real);
  if (const auto* integer = std::get_if<std::int64_t>(&value)) return std::to_string(*integer);
  if (const auto* text = std::get_if<std::string>(&value)) return *text;
  return "";
}

/// Name of a last column that only says which rows belong: it holds the whole key of the row's job.
constexpr const char* whole_key = "whole_key";

/// A table of what the catalog answers; empty rows: nothing to show. Where the last column is whole_key, only
/// rows whose job is among `keys`, and without that column.
analysis::PageTable table_of(const fs::path& results, const std::string& caption, const std::string& sql,
                             const std::string& study, const std::set<std::string>& keys = {}) {
  const SqlValue name = study;
  const Rows rows = query(results, sql, std::span(&name, 1));
  analysis::PageTable table{caption, rows.names, {}};
  const bool by_key = !table.head.empty() && table.head.back() == whole_key;
  if (by_key) table.head.pop_back();
  for (const auto& row : rows.rows) {
    if (by_key && !keys.contains(std::get<std::string>(row.back()))) continue;
    std::vector<std::string> cells;
    for (std::size_t i = 0; i < table.head.size(); ++i) cells.push_back(shown(row[i]));
    table.rows.push_back(std::move(cells));
  }
  return table;
}

/// The comment at the head of a study file: the reading that it rests on.
std::string reading_of(const fs::path& file) {
  std::ifstream in(file);
  std::string text, line;
  while (std::getline(in, line) && line.starts_with("#")) {
    line.erase(0, std::min<std::size_t>(line.size(), line.starts_with("# ") ? 2 : 1));
    text += line.empty() ? "\n\n" : (text.empty() || text.ends_with('\n') ? "" : " ") + line;
  }
  return text;
}

std::string columns_of(const std::vector<std::string>& swept) {
  std::string columns;
  for (const std::string& name : swept) {
    const mpm::Quantity* q = mpm::find_quantity(name);
    const mpm::Choice* c = mpm::find_choice(name);
    if (q || c) columns += std::string(q ? q->column : c->column) + ", ";
  }
  return columns;
}

/// Runs of an audit beside the runs that stopped early: the same in all that the search varies.
std::string audit_sql(const Study& study) {
  std::vector<std::string> varied = study.swept;
  varied.push_back(study.search->critical);
  std::string columns, same, order;
  for (const std::string& name : varied) {
    const mpm::Quantity* q = mpm::find_quantity(name);
    const std::string column(q ? q->column : mpm::find_choice(name)->column);
    columns += "a." + column + ", ";
    same += " AND a." + column + " IS e." + column;
    order += (order.empty() ? "" : ", ") + ("a." + column);
  }
  return "SELECT " + columns +
         "e.outcome AS stopped_early, a.outcome AS run_to_end, substr(a.key, 1, 12) AS job FROM jobs a "
         "JOIN jobs e ON e.study = ?1 AND a.study = e.study || '-audit'" +
         same + " ORDER BY " + order;
}

/// What a study with [search] sweeps beside its cells, out of the JSON of the view `brackets`.
std::string swept_of_brackets(const std::vector<std::string>& swept) {
  std::string columns;
  for (const std::string& name : swept) {
    if (name == "cell_size") continue;
    const mpm::Quantity* q = mpm::find_quantity(name);
    const std::string column(q ? q->column : mpm::find_choice(name)->column);
    columns += fmt::format("swept ->> '{0}' AS \"{0}\", ", column);
  }
  return columns;
}

/// Snapshots of a job as images of one scale.
analysis::PageAnimation animation_of(const StudyResults& results, const JobResults& job,
                                     const std::string& field, const std::string& title) {
  constexpr int width = 180;
  analysis::PageAnimation animation;
  std::vector<analysis::Particles> frames;
  std::vector<double> values, times;
  for (const fs::path& file : snapshots_of(results, job)) {
    const mpm::Snapshot s = mpm::read_vtkhdf(file);
    frames.push_back(particles_of(s, field));
    times.push_back(s.time);
    values.insert(values.end(), frames.back().value.begin(), frames.back().value.end());
  }
  if (frames.size() < 3) return {};
  animation.captions = analysis::value_labels(label_of("time"), times);
  const bool mirrored = job.scene.numerics.symmetry == mpm::Symmetry::half;
  std::vector<const analysis::Particles*> all;
  for (const auto& frame : frames) all.push_back(&frame);
  const analysis::Window window = analysis::window_of(all, mirrored);
  std::ranges::sort(values);
  const double low = std::min(0.0, values[values.size() / 200]),
               high = values[values.size() - 1 - values.size() / 200];
  animation.title = title;
  animation.columns = width;
  animation.rows = std::max(1, static_cast<int>(std::lround(width * window.height() / window.width())));
  for (const auto& frame : frames) {
    const analysis::Raster raster =
        analysis::rasterise(frame, mirrored, window, animation.columns, animation.rows);
    std::vector<std::uint8_t> pixels;
    for (int j = raster.rows - 1; j >= 0; --j)
      for (int i = 0; i < raster.columns; ++i) {
        const double v = raster.values[static_cast<std::size_t>(j * raster.columns + i)];
        const double share = high > low ? (v - low) / (high - low) : 0;
        pixels.push_back(std::isnan(v)
                             ? 0
                             : static_cast<std::uint8_t>(1 + std::lround(254 * std::clamp(share, 0.0, 1.0))));
      }
    animation.frames.push_back(std::move(pixels));
  }
  const analysis::Quantity quantity = label_of(field);
  const analysis::DisplayUnit unit =
      analysis::display_unit(quantity.unit, std::max(std::abs(low), std::abs(high)));
  animation.low = fmt::format("{:.3g}", low * unit.factor);
  animation.high = fmt::format("{:.3g} {}", high * unit.factor, unit.text);
  return animation;
}

/// Keys that the jobs of a study can have: with an accuracy those of several cells.
std::set<std::string> keys_of(const Study& study) {
  std::set<std::string> keys;
  for (const mpm::Scene& scene : study.scenes) {
    const LadderScenes ladder = ladder_scenes(scene, study.ladder);
    for (std::size_t rung = ladder.first_answer; rung < ladder.scenes.size(); ++rung)
      keys.insert(job_key(ladder.scenes[rung]));
  }
  return keys;
}

std::string shown_number(const std::optional<double>& value) {
  return value ? fmt::format("{:.6g}", *value) : "";
}

analysis::PageTable fits_of(const Study& study, const StudyResults& results) {
  analysis::PageTable table{"Fits",
                            {"quantity", "against", "model", "coefficient", "value", "standard_error", "r2",
                             "reduced_chi2", "unit"},
                            {}};
  for (const FitRow& fit : fit_study(study, results).rows)
    table.rows.push_back({fit.quantity, fit.against, fit.model, fit.coefficient, shown_number(fit.value),
                          shown_number(fit.standard_error), fit.r2 ? shown_number(fit.r2) : fit.r2_text,
                          shown_number(fit.reduced_chi2), fit.unit});
  return table;
}

analysis::PageSection section_of(const ReportedStudy& reported, const fs::path& folder) {
  const Study& study = reported.study;
  const std::set<std::string> keys = keys_of(study);
  analysis::PageSection section{study.name, study.title, reading_of(study.path), {}, {}, {}};
  const StudyResults results = read_results(study, folder);
  if (!reported.options.empty()) section.text += "\n\nAs it was run with" + reported.options + ".";
  if (results.missing > 0)
    section.text += fmt::format("\n\nNot complete: {} of {} are missing; {}.", results.missing,
                                results.missing + results.done.size(), standing_of(study, folder).why);
  for (const std::string& note : figure_notes(study, results)) section.text += "\n\n" + note + ".";
  for (const fs::path& png : draw_figures(study, results)) {
    fs::path svg = png;
    svg.replace_extension(".svg");
    // Curves are small and sharp as SVG; fields are pixels.
    const bool curves = fs::file_size(svg) < 200'000;
    section.images.push_back({curves ? svg : png, png.stem().string()});
  }
  for (const FigureRequest& figure : study.figures) {
    if (figure.kind != "fields") continue;
    for (const JobResults& job : results.done)
      if (auto animation = animation_of(results, job, figure.y, figure.title); !animation.frames.empty())
        section.animations.push_back(std::move(animation));
  }
  const auto add = [&](const std::string& caption, const std::string& sql) {
    if (auto table = table_of(folder, caption, sql, study.name, keys); !table.rows.empty())
      section.tables.push_back(std::move(table));
  };
  if (study.search && !results.done.empty())
    add("Brackets",
        "SELECT " + swept_of_brackets(study.swept) +
            "cell_size_m, quantity, unit, lower, upper, extrapolated, interval, runs, flags, "
            "substr(lower_key, 1, 12) AS lower_job, substr(upper_key, 1, 12) AS upper_job FROM brackets "
            "WHERE study = ?1 ORDER BY position");
  if (!study.search)
    add("Jobs",
        "SELECT " + columns_of(study.swept) +
            "status, outcome, collapsibility, collapsibility_error, energy_error, particles, steps, cpu_s, "
            "flags, substr(key, 1, 12) AS job, key AS whole_key FROM jobs WHERE study = ?1 ORDER BY "
            "position");
  if (study.search)
    add("Audit: runs that stopped when decided, run to their end", audit_sql(study));
  else
    add("Error bars from several cells",
        "SELECT " + columns_of(study.swept) +
            "a.value, a.error, a.extrapolated_value, a.extrapolated_error, a.observed_order, a.method, "
            "substr(a.key, 1, 12) AS job, a.key AS whole_key FROM accuracy a JOIN jobs j ON j.key = a.key "
            "AND j.study = a.study "
            "WHERE a.study = ?1 AND a.quantity = 'collapsibility' ORDER BY j.position");
  if (auto fits = fits_of(study, results); !fits.rows.empty()) section.tables.push_back(std::move(fits));
  if (!study.search)
    add("Measured",
        "SELECT substr(j.key, 1, 12) AS job, m.name, m.value, m.error, m.unit, j.key AS whole_key FROM jobs "
        "j "
        "JOIN metrics m USING (key) WHERE j.study = ?1 ORDER BY j.position, "
        "m.name");
  return section;
}

}  // namespace

std::string report_page(const std::vector<ReportedStudy>& studies, const fs::path& folder,
                        const Preface& preface) {
  analysis::Page page{preface.title, preface.subtitle, "", preface.sections};
  if (page.title.empty()) {
    for (const ReportedStudy& one : studies) page.title += (page.title.empty() ? "" : ", ") + one.study.name;
    page.subtitle = "mpmstudy";
  }

  std::string fingerprints;
  for (const ReportedStudy& study : studies) {
    page.sections.push_back(section_of(study, folder));
    fingerprints += read_results(study.study, folder).fingerprint;
  }
  analysis::PageSection costs{"costs", "Costs", "", {}, {}, {}};
  costs.tables.push_back(table_of(
      folder, "Time on a processor, by study",
      "SELECT study, count(*) AS jobs, sum(cpu_s) AS cpu_s, sum(CAST(particles AS REAL) * steps) AS "
      "particle_updates, avg(particle_updates_per_s) AS particle_updates_per_s, max(energy_error) AS "
      "largest_energy_error FROM jobs WHERE study IS NOT NULL AND status = 'done' AND ?1 IS NOT "
      "NULL GROUP BY study ORDER BY study",
      "all"));
  page.sections.push_back(std::move(costs));
  page.footer = fmt::format("catalog {:016x}, physics version {}, commit {}",
                            XXH3_64bits(fingerprints.data(), fingerprints.size()), mpm::physics_version,
                            git_revision());
  return analysis::html_of(page);
}

}  // namespace mpmstudy
