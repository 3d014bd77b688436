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
#include "libmpm/scene/kinds/kind.hpp"
#include "runner/catalog/study_tables.hpp"
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

/// A table of what the catalog answers: all rows, or only those whose job is among `keys`. Empty rows:
/// nothing to show.
analysis::PageTable page_table(const std::string& caption, const StudyTable& answer,
                               const std::set<std::string>* keys = nullptr) {
  analysis::PageTable table{caption, answer.head, {}};
  for (const StudyTable::Row& row : answer.rows) {
    if (keys && !keys->contains(row.key)) continue;
    std::vector<std::string> cells;
    for (const SqlValue& value : row.cells) cells.push_back(shown(value));
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

/// Snapshots of a job as images of one scale.
analysis::PageAnimation animation_of(const StudyResults& results, const JobResults& job,
                                     const FigureRequest& figure) {
  constexpr int width = 180;
  analysis::PageAnimation animation;
  std::vector<analysis::ParticleSquares> frames;
  std::vector<double> values, times;
  for (const fs::path& file : snapshots_of(results, job)) {
    const mpm::Snapshot s = mpm::read_vtkhdf(file);
    frames.push_back(particles_of(s, figure.y, {}, figure.view));
    if (frames.back().x.empty()) return {};
    times.push_back(s.time);
    values.insert(values.end(), frames.back().value.begin(), frames.back().value.end());
  }
  if (frames.size() < 3) return {};
  animation.captions = analysis::value_labels(label_of("time"), times);
  const FieldPicture picture = picture_of(figure, job.scene);
  const bool mirrored = picture.mirrored;
  std::vector<const analysis::ParticleSquares*> all;
  for (const auto& frame : frames) all.push_back(&frame);
  const analysis::Window window = analysis::window_of(all, mirrored);
  std::ranges::sort(values);
  const double low = std::min(0.0, values[values.size() / 200]),
               high = values[values.size() - 1 - values.size() / 200];
  animation.title = picture.title;
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
  const analysis::QuantityLabel quantity = label_of(figure.y);
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
  if (study.surface)
    for (const mpm::Scene& scene : study.surface->candidates) keys.insert(job_key(scene));
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
    if (!row_of(figure.kind).of_snapshots) continue;
    for (const JobResults& job : results.done)
      if (auto animation = animation_of(results, job, figure); !animation.frames.empty())
        section.animations.push_back(std::move(animation));
  }
  const auto add = [&](analysis::PageTable table) {
    if (!table.rows.empty()) section.tables.push_back(std::move(table));
  };
  if (study.search) {
    if (!results.done.empty())
      add(page_table("Brackets", table_of_brackets(folder, study.name, study.swept)));
    std::vector<std::string> varied = study.swept;
    varied.push_back(study.search->critical);
    add(page_table("Audit: runs that stopped when decided, run to their end",
                   table_of_audit(folder, study.name, varied)));
  } else {
    add(page_table("Jobs", table_of_jobs(folder, study.name, study.swept), &keys));
    add(page_table("Error bars from several cells",
                   table_of_accuracy(folder, study.name, study.swept, "collapsibility"), &keys));
  }
  add(fits_of(study, results));
  if (!study.search) add(page_table("Measured", table_of_metrics(folder, study.name), &keys));
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
  std::set<int> versions;
  for (const ReportedStudy& study : studies) {
    versions.merge(physics_versions_of(study.study));
    page.sections.push_back(section_of(study, folder));
    fingerprints += read_results(study.study, folder).fingerprint;
  }
  analysis::PageSection costs{"costs", "Costs", "", {}, {}, {}};
  costs.tables.push_back(page_table("Time on a processor, by study", table_of_costs(folder)));
  page.sections.push_back(std::move(costs));
  page.footer =
      fmt::format("catalog {:016x}, {}, commit {}", XXH3_64bits(fingerprints.data(), fingerprints.size()),
                  physics_versions_text(versions), git_revision());
  return analysis::html_of(page);
}

}  // namespace mpmstudy
