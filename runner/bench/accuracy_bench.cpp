#include "runner/bench/accuracy_bench.hpp"

#include <algorithm>
#include <atomic>
#include <cmath>
#include <limits>
#include <mutex>
#include <stdexcept>
#include <thread>

#include "analysis/extrapolation.hpp"
#include "libmpm/core/thread_clock.hpp"
#include "libmpm/scene/parameters.hpp"

namespace mpmstudy {
namespace {

/// Every shape function with 1, 4 and 9 particles per cell; those of the fast step in float too; with
/// B-splines also the transfer that carries the gradient.
std::vector<AccuracyScheme> schemes_for(const mpm::Scene& scene) {
  const mpm::Choice& shapes = *mpm::find_choice("scheme");
  std::vector<AccuracyScheme> all;
  for (std::size_t k = 0; k < shapes.allowed.size(); ++k)
    for (const int particles : {1, 4, 9}) {
      AccuracyScheme scheme{std::string(shapes.allowed[k]), particles};
      scheme.is_default = k == shapes.get(scene) && particles == scene.numerics.particles_per_cell;
      all.push_back(scheme);
      scheme.is_default = false;
      mpm::Scene changed = scene;
      changed.numerics.scheme = static_cast<mpm::ShapeFunction>(k);
      if (mpm::fast_step_has(changed)) {
        scheme.precision = "float";
        all.push_back(scheme);
        scheme.precision = "double";
      }
      if (scheme.shape.starts_with("bspline")) {
        scheme.transfer = "apic";
        all.push_back(scheme);
      }
    }
  return all;
}

struct Work {
  const AccuracyProblem* problem;
  AccuracyRow row;
};

void choose(mpm::Scene& scene, std::string_view choice, const std::string& word) {
  const mpm::Choice& row = *mpm::find_choice(choice);
  row.set(scene, static_cast<std::size_t>(std::ranges::find(row.allowed, word) - row.allowed.begin()));
}

mpm::Scene scene_of(const AccuracyProblem& problem, const AccuracyRow& row) {
  mpm::Scene scene = problem.scene;
  choose(scene, "scheme", row.scheme.shape);
  choose(scene, "transfer", row.scheme.transfer);
  choose(scene, "precision", row.scheme.precision);
  scene.numerics.particles_per_cell = row.scheme.particles_per_cell;
  scene.numerics.cell_size = row.cell_size;
  if (!mpm::fast_step_has(scene)) scene.numerics.kernel = mpm::Kernel::reference;
  return scene;
}

void run(Work& work) {
  AccuracyRow& row = work.row;
  const double start = mpm::thread_cpu_seconds();
  const mpm::RunResult result = mpm::run(scene_of(*work.problem, row));
  row.cpu_s = mpm::thread_cpu_seconds() - start;
  row.value = std::numeric_limits<double>::quiet_NaN();
  if (result.status != mpm::RunStatus::done)
    row.problem_of_run = result.reason;
  else if (row.value = work.problem->value(result); std::isnan(row.value))
    row.problem_of_run = "not measured";
}

/// Where nothing is exact: each scheme's ladder, extrapolated. No single ladder is to be trusted, however
/// narrow its interval: schemes differ by more. The reference is the middle of the five narrowest, and its
/// interval reaches over all five.
void find_reference(std::vector<Work*>& rows) {
  std::vector<analysis::Extrapolation> found;
  for (std::size_t i = 0; i < rows.size();) {
    const AccuracyScheme& scheme = rows[i]->row.scheme;
    std::vector<analysis::LadderPoint> ladder;
    for (; i < rows.size() && rows[i]->row.scheme == scheme; ++i)
      if (std::isfinite(rows[i]->row.value))
        ladder.push_back({rows[i]->row.cell_size, rows[i]->row.value, 0});
    const bool own = scheme.precision == "double";  // in float a scheme says the same again
    if (ladder.size() >= 3 && own) found.push_back(analysis::extrapolate(ladder));
  }
  std::ranges::sort(found, {}, &analysis::Extrapolation::extrapolated_error);
  found.resize(std::min<std::size_t>(found.size(), 5));
  std::vector<double> values;
  for (const analysis::Extrapolation& e : found) values.push_back(e.extrapolated_value);
  std::ranges::sort(values);
  for (Work* w : rows) {
    w->row.reference = values.empty() ? std::numeric_limits<double>::quiet_NaN() : values[values.size() / 2];
    if (!values.empty())
      w->row.reference_error = std::max(values.back() - w->row.reference, w->row.reference - values.front());
  }
}

void find_front(std::vector<Work*>& rows) {
  for (Work* w : rows) w->row.error = std::abs(w->row.value / w->row.reference - 1);
  for (Work* w : rows)
    w->row.on_front =
        std::isfinite(w->row.error) && std::ranges::none_of(rows, [&](const Work* other) {
          return other->row.cpu_s <= w->row.cpu_s && other->row.error <= w->row.error && other != w;
        });
}

std::vector<const AccuracyProblem*> wanted(const std::vector<AccuracyProblem>& all,
                                           const std::vector<std::string>& names) {
  std::vector<const AccuracyProblem*> some;
  for (const AccuracyProblem& p : all)
    if (names.empty() || std::ranges::find(names, p.name) != names.end()) some.push_back(&p);
  for (const std::string& name : names)
    if (std::ranges::find(all, name, &AccuracyProblem::name) == all.end()) {
      std::string allowed;
      for (const AccuracyProblem& p : all) allowed += (allowed.empty() ? "" : ", ") + p.name;
      throw std::invalid_argument("no problem is called " + name + "; there are: " + allowed);
    }
  return some;
}

}  // namespace

std::string AccuracyScheme::label() const {
  std::string text = shape + ", " + std::to_string(particles_per_cell) + " per cell";
  if (transfer != "flip") text += ", " + transfer;
  if (precision != "double") text += ", " + precision;
  return text;
}

std::vector<AccuracyRow> bench_accuracy(const AccuracyBenchOptions& options) {
  const std::vector<AccuracyProblem> all = accuracy_problems();
  const auto problems = wanted(all, options.problems);
  std::vector<Work> work;
  for (const AccuracyProblem* problem : problems)
    for (const AccuracyScheme& scheme : schemes_for(problem->scene))
      for (int rung = 0; rung < problem->cells - options.skip_finest; ++rung) {
        AccuracyRow row;
        row.problem = problem->name;
        row.what = problem->what;
        row.scheme = scheme;
        row.cell_size = std::ldexp(problem->scene.numerics.cell_size, -rung);
        const bool finest = rung == problem->cells - 1;
        if (finest && scene_of(*problem, row).numerics.kernel == mpm::Kernel::reference) continue;
        work.push_back({problem, row});
      }
  std::atomic<std::size_t> next{0};
  std::mutex telling;
  std::size_t done = 0;
  std::vector<std::thread> threads;
  for (unsigned t = 0; t < std::max(1u, options.workers); ++t)
    threads.emplace_back([&] {
      for (std::size_t i; (i = next.fetch_add(1)) < work.size();) {
        run(work[i]);
        const std::lock_guard lock(telling);
        ++done;
        if (options.progress) options.progress(done, work.size());
      }
    });
  for (std::thread& t : threads) t.join();

  for (const AccuracyProblem* problem : problems) {
    std::vector<Work*> rows;
    for (Work& w : work)
      if (w.problem == problem) rows.push_back(&w);
    if (problem->exact) {
      const double exact = problem->exact();
      for (Work* w : rows) w->row.reference = exact;
    } else {
      find_reference(rows);
    }
    find_front(rows);
  }
  std::vector<AccuracyRow> rows;
  for (Work& w : work) rows.push_back(std::move(w.row));
  return rows;
}

}  // namespace mpmstudy
