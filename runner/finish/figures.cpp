#include "runner/finish/figures.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <stdexcept>

#include "analysis/calibration_plot.hpp"
#include "analysis/field_plot.hpp"
#include "analysis/fonts.hpp"
#include "analysis/map_plot.hpp"
#include "analysis/plot.hpp"
#include "libmpm/io/vtkhdf.hpp"
#include "libmpm/scene/kinds/kind.hpp"
#include "libmpm/scene/parameters.hpp"
#include "runner/finish/calibration.hpp"
#include "runner/finish/fields.hpp"
#include "runner/finish/fits.hpp"
#include "runner/finish/labels.hpp"
#include "runner/study/parameter_value.hpp"
#include "runner/study/searched.hpp"

namespace mpmstudy {
namespace {

namespace fs = std::filesystem;

std::string footer_of(const Study& study, const StudyResults& results) {
  return fmt::format("catalog {}, {}", results.fingerprint,
                     physics_versions_text(physics_versions_of(study)));
}

void add_area_history(const StudyResults& results, const JobResults& job, analysis::Series& series) {
  for (const mpm::AreaSample& sample : area_history_of(results, job)) {
    series.x.push_back(sample.time);
    series.y.push_back(sample.area);
    series.y_error.push_back(std::abs(sample.void_area - sample.area));
  }
}

/// Of a gauge. Gives back how it is labelled: "Velocity along y, rear".
analysis::QuantityLabel add_history(const Study& study, const StudyResults& results, const JobResults& job,
                                    const std::string& gauge, analysis::Series& series) {
  mpm::History history = history_of(results, job, gauge);
  series.x = std::move(history.times);
  series.y = std::move(history.values);
  const auto known = std::ranges::find(study.gauges, gauge, &mpm::Gauge::name);
  analysis::QuantityLabel label = label_of(known == study.gauges.end() ? gauge : known->of, history.unit);
  label.name += ", " + gauge;
  label.symbol = "";
  label.unit = history.unit;
  return label;
}

bool draw_history(const Study& study, const StudyResults& results, const FigureRequest& request,
                  const fs::path& stem) {
  analysis::Plot plot;
  plot.kind = analysis::Plot::Kind::history;
  plot.title = request.title;
  plot.footer = footer_of(study, results);
  plot.x = label_of("time");
  plot.y = label_of("area");
  plot.y_from_zero = request.y.empty();
  for (const Group& group : group_jobs(study, results, {}))
    for (const JobResults* job : group.jobs) {
      analysis::Series series{group.label, {}, {}, {}};
      if (request.y.empty())
        add_area_history(results, *job, series);
      else
        plot.y = add_history(study, results, *job, request.y, series);
      if (!series.x.empty()) plot.series.push_back(std::move(series));
    }
  if (plot.series.empty()) return false;
  draw(plot, stem);
  return true;
}

/// Critical values for cells of size 0, and the curve through them if the study asks for one. Several
/// families have several curves; one formula under the title would speak of one of them only.
void add_extrapolated(const Study& study, const StudyResults& results, const FigureRequest& request,
                      analysis::Plot& plot) {
  const std::string y = request.y + "_extrapolated";
  const auto fit = std::ranges::find_if(
      study.fits, [&](const FitRequest& f) { return f.x == request.x && same_result(f.y, y); });
  const auto families = group_jobs(study, results, curve_of(study, request.x, y));
  for (const Group& family : families) {
    Column c = column_of(results, family, request.x, y);
    if (c.x.empty()) continue;
    if (families.size() == 1 && fit != study.fits.end()) plot.fit = fit_column(*fit, c);
    plot.series.push_back({(family.label.empty() ? "" : family.label + ", ") + "h → 0", std::move(c.x),
                           std::move(c.y), std::move(c.y_error)});
  }
}

/// "Critical yield stress": of either name of a search's result.
analysis::QuantityLabel critical_label(const mpm::Quantity& searched) {
  auto label = label_of(searched.name, searched.unit);
  if (!label.name.empty() && label.name[0] >= 'A' && label.name[0] <= 'Z')
    label.name[0] = static_cast<char>(label.name[0] - 'A' + 'a');
  label.name = "Critical " + label.name;
  return label;
}

analysis::QuantityLabel label_of_result(const StudyResults& results, const std::string& name) {
  return results.critical && critical_result(name) ? critical_label(*results.critical)
                                                   : label_of(name, unit_of(results, name));
}

/// Of several families of critical values only those on their finest cell are drawn, with the extrapolated
/// ones: the coarser ones are in the table of brackets.
bool is_left_out(const Study& study, const FigureRequest& request, const Group& group) {
  if (critical_result(request.y) != CriticalResult::bracket ||
      std::ranges::find(study.swept, "cell_size") == study.swept.end())
    return false;
  const auto cell = [](const mpm::Scene& s) { return s.numerics.cell_size; };
  const double finest = cell(*std::ranges::min_element(study.scenes, {}, cell));
  const bool several = study.swept.size() > 2;  // beside the axis and the cell
  return several && cell(group.jobs.front()->scene) > finest;
}

bool draw_xy(const Study& study, const StudyResults& results, const FigureRequest& request,
             const fs::path& stem) {
  analysis::Plot plot;
  plot.kind = analysis::Plot::Kind::xy;
  plot.title = request.title;
  plot.footer = footer_of(study, results);
  plot.x = quantity_unit(study, request.x).empty() ? label_of_result(results, request.x)
                                                   : label_of_parameter(study, request.x);
  plot.log_x = request.log_x, plot.log_y = request.log_y;
  plot.y = label_of_result(results, request.y);
  const auto groups = group_jobs(study, results, curve_of(study, request.x, request.y));
  for (const Group& group : groups) {
    Column c = column_of(results, group, request.x, request.y);
    if (c.x.empty() || is_left_out(study, request, group)) continue;
    const auto fit = std::ranges::find_if(
        study.fits, [&](const FitRequest& f) { return f.x == request.x && same_result(f.y, request.y); });
    // Several groups have several curves; one formula under the title would speak of one of them only.
    if (groups.size() == 1 && fit != study.fits.end()) plot.fit = fit_column(*fit, c);
    plot.series.push_back({group.label.empty() ? "simulation" : group.label, std::move(c.x), std::move(c.y),
                           std::move(c.y_error)});
  }
  if (critical_result(request.y) == CriticalResult::bracket) {
    add_extrapolated(study, results, request, plot);
    plot.y_from_zero = !plot.fit && !plot.log_y;
  }
  if (plot.series.empty()) return false;
  draw(plot, stem);
  return true;
}

/// One figure per group of jobs that differ in more than x and y: NAME, or NAME-1, NAME-2, ...
std::vector<fs::path> draw_map(const Study& study, const StudyResults& results, const FigureRequest& request,
                               const fs::path& stem) {
  std::vector<fs::path> stems;
  const auto groups = group_jobs(study, results, map_of(study, request.x, request.y));
  for (std::size_t g = 0; g < groups.size(); ++g) {
    analysis::MapPlot map;
    map.title = groups[g].label.empty() ? request.title : request.title + ", " + groups[g].label;
    map.footer = footer_of(study, results);
    map.x = label_of_parameter(study, request.x);
    map.y = label_of_parameter(study, request.y);
    map.colour = label_of_result(results, request.colour);
    map.log_x = request.log_x, map.log_y = request.log_y;
    for (const JobResults* job : groups[g].jobs) {
      const auto value = result_of(results, *job, request.colour);
      if (!value) continue;
      map.points.push_back({quantity_value(job->scene, request.x).value_or(0),
                            quantity_value(job->scene, request.y).value_or(0), value->value});
    }
    if (map.points.empty()) continue;
    stems.push_back(stem.string() + (groups.size() == 1 ? "" : fmt::format("-{}", g + 1)));
    draw(map, stems.back());
  }
  return stems;
}

/// One panel per snapshot; times have digits until they differ.
std::vector<analysis::FieldPanel> panels_of(const std::vector<fs::path>& files, const std::string& field,
                                            const mpm::Scene& scene, const FieldView& view) {
  const std::vector<int> materials = files.empty() ? std::vector<int>() : materials_of(scene);
  std::vector<analysis::FieldPanel> panels;
  std::vector<double> times;
  for (const fs::path& file : files) {
    const mpm::Snapshot s = mpm::read_vtkhdf(file);
    panels.push_back({"", particles_of(s, field, materials, view)});
    times.push_back(s.time);
  }
  const auto titles = analysis::value_labels(label_of("time"), times);
  for (std::size_t i = 0; i < panels.size(); ++i) panels[i].title = titles[i];
  return panels;
}

/// One figure per job: NAME, or NAME-1, NAME-2, ... in the order of the sweep.
std::vector<fs::path> draw_fields(const Study& study, const StudyResults& results,
                                  const FigureRequest& request, const fs::path& stem) {
  std::vector<fs::path> stems;
  const auto groups = group_jobs(study, results, {});
  for (std::size_t g = 0; g < groups.size(); ++g) {
    const JobResults& job = *groups[g].jobs.front();
    analysis::FieldPlot plot;
    FieldPicture picture = picture_of(request, job.scene, groups[g].label);
    plot.title = std::move(picture.title);
    plot.across = std::move(picture.across), plot.up = std::move(picture.up);
    plot.mirrored = picture.mirrored;
    plot.footer = footer_of(study, results);
    plot.value = label_of(request.y);
    plot.panels = panels_of(snapshots_of(results, job), request.y, job.scene, request.view);
    // a slice may be beside all material
    if (std::ranges::all_of(plot.panels, [](const auto& panel) { return panel.particles.x.empty(); }))
      continue;
    const std::string suffix = groups.size() == 1 ? "" : fmt::format("-{}", g + 1);
    stems.push_back(stem.string() + suffix);
    draw(plot, stems.back());
    plot.palette = analysis::Palette::grey;
    stems.push_back(stem.string() + suffix + "-grey");
    draw(plot, stems.back());
  }
  return stems;
}

bool draw_calibration(const Study& study, const StudyResults& results, const FigureRequest& request,
                      const fs::path& stem) {
  const auto points = calibration_of(study, results, request.y);
  if (points.empty()) return false;
  analysis::draw({request.title, footer_of(study, results), points}, stem);
  return true;
}

/// How a kind of figure is drawn; gives back the stems of its files, none where there is nothing to draw.
using Draw = std::vector<fs::path> (*)(const Study&, const StudyResults&, const FigureRequest&,
                                       const fs::path& stem);
/// Of kinds that are one file.
template <bool (*draw_one)(const Study&, const StudyResults&, const FigureRequest&, const fs::path&)>
std::vector<fs::path> one_file(const Study& study, const StudyResults& results, const FigureRequest& request,
                               const fs::path& stem) {
  return draw_one(study, results, request, stem) ? std::vector{stem} : std::vector<fs::path>();
}
Draw drawing_of(FigureKind of) {
  switch (of) {
    case FigureKind::history:
      return one_file<draw_history>;
    case FigureKind::xy:
      return one_file<draw_xy>;
    case FigureKind::map:
      return draw_map;
    case FigureKind::fields:
      return draw_fields;
    case FigureKind::calibration:
      return one_file<draw_calibration>;
  }
  throw std::logic_error("a kind of figure without a function that draws it");
}

}  // namespace

std::vector<fs::path> draw_figures(const Study& study, const StudyResults& results) {
  std::vector<fs::path> stems;
  for (const FigureRequest& request : study.figures) {
    const fs::path stem = results.folder / "figures" / study.name / request.name;
    for (fs::path& one : drawing_of(request.kind)(study, results, request, stem))
      stems.push_back(std::move(one));
  }
  for (fs::path& stem : stems) stem += ".png";
  return stems;
}

std::vector<std::string> not_drawn(const Study& study, const std::vector<fs::path>& drawn,
                                   const fs::path& results) {
  std::vector<std::string> lines;
  for (const FigureRequest& request : study.figures) {
    const FigureKindRow& kind = row_of(request.kind);
    if (kind.least_cells > 1) continue;  // an accuracy may be reached before there are cells for it
    if (std::ranges::any_of(drawn, [&](const fs::path& file) {
          const std::string stem = file.stem().string();
          return stem == request.name ||
                 ((kind.of_snapshots || kind.has_colour) && stem.starts_with(request.name + "-"));
        }))
      continue;
    const fs::path before = results / "figures" / study.name / (request.name + ".png");
    lines.push_back(fmt::format("figure {}: there is nothing to draw{}", request.name,
                                fs::exists(before) ? "; " + before.string() + " is of an earlier run" : ""));
  }
  return lines;
}

std::vector<std::string> figure_notes(const Study& study, const StudyResults& results) {
  std::vector<std::string> notes;
  for (const std::string& line : left_out(study, results))
    notes.push_back("left out of figures and fits: " + line);
  for (const std::string& line : flagged_brackets(study, results))
    notes.push_back("drawn and fitted, since the runs at both ends have their outcomes: " + line);
  for (const FigureRequest& request : study.figures)
    if (request.kind == FigureKind::calibration && results.missing == 0 &&
        calibration_of(study, results, request.y).empty())
      notes.push_back(
          fmt::format("figure {}: not drawn, its ladders have too few cells to judge intervals of {}",
                      request.name, request.y));
  for (const FigureRequest& request : study.figures)
    if (const auto missing = analysis::characters_without_font(request.title); !missing.empty())
      notes.push_back(
          fmt::format("title of figure {}: no font of this machine has {}; a question mark stands for "
                      "each (Debian: fonts-noto-cjk has Chinese, Japanese and Korean)",
                      request.name, fmt::join(missing, ", ")));
  return notes;
}

}  // namespace mpmstudy
