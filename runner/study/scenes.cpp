#include "runner/study/scenes.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <limits>

#include "libmpm/scene/effect.hpp"
#include "runner/study/decimal.hpp"
#include "runner/study/job_values.hpp"
#include "runner/study/ladder.hpp"
#include "runner/study/readable.hpp"
#include "runner/study/wanted_points.hpp"
#include "runner/study/written_unit.hpp"

namespace mpmstudy {
namespace {

/// The period of the area history where a study says nothing, as a share of end_time.
constexpr double default_area_samples = 320;

/// After so many jobs with mistakes the rest would tell a user nothing new.
constexpr int most_bad_jobs = 20;

mpm::Scene base_scene(const SceneRequest& request) {
  mpm::Scene scene;
  scene.kind = request.kind;
  scene.numerics = mpm::default_numerics(request.kind);
  for (const GaugeRequest& one : request.gauges) scene.measures.gauges.push_back(one.gauge);
  if (request.seeks_ejection) {
    scene.measures.decides = mpm::Decides::ejection;
    scene.measures.stop = mpm::Stop::decided;
  }
  return scene;
}

/// The times of the snapshots of one job, in the order of the request.
std::vector<double> snapshot_times(const SceneRequest& request, const ValueOf& value, Mistakes& mistakes) {
  std::vector<double> times;
  for (const JobQuantity& one : request.snapshots) times.push_back(one.value(value, mistakes).value_or(0));
  return times;
}

std::vector<double> ascending(std::vector<double> times) {
  std::ranges::sort(times);
  times.erase(std::unique(times.begin(), times.end()), times.end());
  return times;
}

/// Puts mistakes of one job where their values were written.
class Reporter {
 public:
  Reporter(const SceneRequest& request, const std::vector<Assignment>& assignments,
           const Combinations& combinations, Mistakes& mistakes)
      : request_(request), assignments_(assignments), combinations_(combinations), mistakes_(mistakes) {}

  /// `snapshots`: times in the order of the request.
  void check(const mpm::Scene& scene, std::uint64_t job, const std::vector<double>& snapshots) {
    for (std::size_t k = 0; k < snapshots.size(); ++k)
      if (snapshots[k] > scene.end_time) {
        const auto text = [&](double time) { return in_written_unit(time, "s", "end_time", request_.units); };
        mistakes_.add(request_.snapshots[k].place(), "snapshots", text(snapshots[k]),
                      {"after the end of the run", "allowed: up to end_time = " + text(scene.end_time)});
      }
    for (const mpm::Problem& problem : mpm::find_problems(scene)) {
      if (add_to_gauge(problem)) continue;
      const Assignment* source = source_of(problem.parameter);
      const bool as_written = source && source->column == not_swept &&
                              source->axis->name() == problem.parameter && !source->axis->expression;
      const bool scaled = source && problem.parameter == "cell_size" && request_.cells != 1;
      const std::string value = in_file_units(problem.value, problem.parameter);
      std::string written = as_written ? source->axis->written : value;
      std::string wrong = "cannot be run";
      if (scaled) {
        if (!as_written) written = of_the_file(scene.numerics.cell_size);
        wrong += fmt::format(": times --cells {} it is {}", request_.cells, value);
      }
      mistakes_.add(source ? source->point(combinations_, job).place : other_place(problem.parameter),
                    problem.parameter, written,
                    {wrong, "allowed: " + in_file_units(problem.allowed, problem.parameter)});
    }
    if (mistakes_.empty()) check_ladder(scene);
  }

 private:
  /// Puts a problem of a gauge ("gauge.NAME.KEY") where the file says it. False: it is of something else.
  bool add_to_gauge(const mpm::Problem& problem) {
    for (const GaugeRequest& one : request_.gauges) {
      const std::string before = "gauge." + one.gauge.name + ".";
      if (!problem.parameter.starts_with(before)) continue;
      const std::string key = problem.parameter.substr(before.size());
      const auto written = one.keys.find(key);
      const bool known = written != one.keys.end();
      mistakes_.add(known ? written->second.place : one.place, key.substr(key.find('.') + 1),
                    known ? written->second.text : problem.value,
                    {"is wrong for gauge " + one.gauge.name,
                     "allowed: " + in_file_units(problem.allowed, problem.parameter)});
      return true;
    }
    return false;
  }

  /// The other end of a ladder of cells has to be a scene, too.
  void check_ladder(mpm::Scene scene) {
    const LadderRequest& ladder = request_.ladder;
    double& cell = scene.numerics.cell_size;
    cell = finer_cell(cell, ladder.finds_cell ? ladder.cells - 1 : 1 - ladder.cells);
    for (const mpm::Problem& problem : mpm::find_problems(scene))
      mistakes_.add(request_.ladder_place, "ladder", std::to_string(ladder.cells),
                    {"makes a cell of " + in_written_unit(cell, "m", "cell_size", request_.units) +
                         (request_.cells == 1 ? "" : fmt::format(", with --cells {}", request_.cells)),
                     "allowed: fewer cells, or a cell_size whose ladder keeps " + problem.parameter + " " +
                         in_file_units(problem.allowed, problem.parameter)});
  }

  const Place& other_place(const std::string& parameter) const {
    const Place* place = request_.bodies ? request_.bodies->place_of(parameter) : nullptr;
    return place ? *place : request_.place;
  }

  std::string in_file_units(const std::string& message, const std::string& parameter) const {
    return in_written_units(message, parameter, request_.units);
  }
  /// The cell that --cells has made this one of.
  std::string of_the_file(double cell) const {
    return in_written_unit(cell / request_.cells, "m", "cell_size", request_.units);
  }

  /// What the file says of a parameter, or of its alternative. Null: nothing, it is a default.
  const Assignment* source_of(std::string_view parameter) const {
    const mpm::Quantity* row = mpm::find_quantity(parameter);
    for (const Assignment& one : assignments_)
      if (one.axis->name() == parameter || (row && one.axis->name() == row->alternative)) return &one;
    return nullptr;
  }

  const SceneRequest& request_;
  const std::vector<Assignment>& assignments_;
  const Combinations& combinations_;
  Mistakes& mistakes_;
};

/// Points between the ends of a range, and those of a distribution, that their quantity cannot have.
void check_ranges(const SceneRequest& request, const std::vector<Assignment>& assignments,
                  const Combinations& combinations, std::uint64_t job, Mistakes& mistakes) {
  for (const Assignment& one : assignments) {
    if (one.column == not_swept || !one.axis->range) continue;
    const Point& point = one.point(combinations, job);
    const mpm::Quantity& row = *one.axis->quantity;
    const Number number = in_range(point.value, {row.unit, row.range});
    if (const auto* refusal = std::get_if<Refusal>(&number))
      mistakes.add(
          point.place, row.name, one.axis->written,
          {"makes " + in_written_unit(point.value, row.unit, row.name, request.units) + ", " + refusal->wrong,
           refusal->allowed});
  }
}

/// Of a parameter of the study's own, for people in the unit in which the file writes it.
mpm::Label own_label(const Axis& axis, double si, const WrittenUnits& units) {
  mpm::Label label{std::string(axis.name()), si, std::string(axis.quantity->unit)};
  const auto unit = units.find(label.name);
  if (unit != units.end()) label.written = in_unit(si, unit->second);
  return label;
}

}  // namespace

std::vector<const Axis*> swept_axes(const SceneRequest& request) {
  std::vector<const Axis*> swept;
  for (const Axis& axis : request.axes)
    if (axis.swept) swept.push_back(&axis);
  return swept;
}

SweptScenes build_scenes(const SceneRequest& request, const Combinations& combinations, Mistakes& mistakes) {
  const std::vector<Assignment> ordered = assignments(request.axes);
  const mpm::Scene base = base_scene(request);
  const bool names_kernel =
      std::ranges::any_of(ordered, [](const Assignment& one) { return one.axis->name() == "kernel"; });
  JobValues value(ordered, combinations);
  WantedPoints points(request, value);
  SweptScenes swept;
  swept.scenes.reserve(combinations.jobs());
  int bad_jobs = 0;
  const auto refuse = [&](const Mistakes& of_job) {
    if (request.skips_invalid) {
      points.skip(of_job.first_key() + " cannot be run", of_job.first_line());
    } else {
      mistakes.add(of_job);
      ++bad_jobs;
    }
  };
  for (std::uint64_t job = 0; job < combinations.jobs() && bad_jobs < most_bad_jobs; ++job) {
    value.of_job(job);
    if (!points.wants(mistakes)) continue;
    Mistakes of_job;
    check_ranges(request, ordered, combinations, job, of_job);
    if (!of_job.empty()) {
      refuse(of_job);
      continue;
    }
    mpm::Scene scene = base;
    for (const Assignment& one : ordered) {
      const double si = value(one);
      if (one.axis->expression &&
          !expression_value(one.axis->value_place, one.axis->name(), one.axis->written, si,
                            {one.axis->quantity->unit, one.axis->quantity->range}, of_job))
        continue;
      if (one.axis->own)
        scene.labels.push_back(own_label(*one.axis, si, request.units));
      else if (one.axis->quantity)
        one.axis->quantity->set(scene, si);
      else
        one.axis->choice->set(scene, static_cast<std::size_t>(si));
      if (one.axis->name() == space_name) scene.numerics = mpm::default_numerics(scene.kind, scene.space);
    }
    if (request.bodies) request.bodies->apply(scene, std::cref(value), of_job);
    for (std::size_t k = 0; k < request.gauges.size(); ++k)
      request.gauges[k].value_in(scene.measures.gauges[k], std::cref(value), of_job);
    const std::vector<double> snapshots = snapshot_times(request, std::cref(value), of_job);
    scene.measures.snapshots = ascending(snapshots);
    if (!of_job.empty()) {
      refuse(of_job);
      continue;  // what follows compares numbers that have to be there
    }
    if (!names_kernel && !mpm::fast_step_has(scene)) scene.numerics.kernel = mpm::Kernel::reference;
    if (request.ladder.finds_cell) scene.numerics.cell_size = coarsest_cell(scene);
    if (scene.measures.area_every == 0) scene.measures.area_every = scene.end_time / default_area_samples;
    if (scene.measures.detached_for == 0) scene.measures.detached_for = mpm::default_detached_for(scene);
    Reporter(request, ordered, combinations, of_job).check(scene, job, snapshots);
    if (of_job.empty())
      swept.scenes.push_back(std::move(scene));
    else
      refuse(of_job);
  }
  swept.skipped = points.end(swept.scenes.empty(), combinations.jobs(), mistakes);
  return swept;
}

}  // namespace mpmstudy
