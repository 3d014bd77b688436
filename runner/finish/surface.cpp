#include "runner/finish/surface.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <set>

#include "analysis/sobol_indices.hpp"
#include "runner/study/parameter_value.hpp"
#include "runner/study/quasi_random.hpp"
#include "runner/study/schema.hpp"

namespace mpmstudy {
namespace {

constexpr std::size_t most_runs =
    1500;  ///< the likelihood takes the cube of their number, and is asked often

bool has_words(const mpm::Scene& scene, const std::map<std::string, std::string>& words) {
  return std::ranges::all_of(
      words, [&](const auto& word) { return readable_parameter(scene, word.first) == word.second; });
}

/// Throws StudyError where the words do not choose one of each that is swept.
void check_words(const Study& study, const StudyResults& results,
                 const std::map<std::string, std::string>& words) {
  const auto swept = swept_words(study);
  for (const auto& [name, word] : words)
    if (std::ranges::find(swept, name) == swept.end())
      throw StudyError(fmt::format("--at: {}={}: {} is no word that {} sweeps; allowed: {}", name, word, name,
                                   study.name, swept.empty() ? "none" : listed(swept)));
  for (const std::string& name : swept) {
    std::set<std::string> known;
    for (const JobResults& job : results.done) known.insert(readable_parameter(job.scene, name));
    const auto given = words.find(name);
    if (given == words.end() && known.size() > 1)
      throw StudyError(fmt::format("{}: {} is swept, and a surface is of one; say --at {}=... with one of {}",
                                   study.name, name, name, listed(known)));
    if (given != words.end() && !known.contains(given->second))
      throw StudyError(
          fmt::format("--at: {}={}: no run has it; allowed: {}", name, given->second, listed(known)));
  }
}

/// Of sorted numbers, the one below which that share of them lies.
double quantile(const std::vector<double>& sorted, double share) {
  const double at = share * (static_cast<double>(sorted.size()) - 1);
  const auto below = static_cast<std::size_t>(at);
  const auto above = std::min(below + 1, sorted.size() - 1);
  return sorted[below] + (at - static_cast<double>(below)) * (sorted[above] - sorted[below]);
}

Estimate estimate(std::vector<double> draws) {
  std::ranges::sort(draws);
  return {quantile(draws, 0.5), quantile(draws, 0.025), quantile(draws, 0.975)};
}

/// An index is from 0 to 1.
Estimate widened(const Estimate& index, double by) {
  return {std::clamp(index.value, 0.0, 1.0), std::clamp(index.low - by, 0.0, 1.0),
          std::clamp(index.high + by, 0.0, 1.0)};
}

constexpr std::size_t levels = 9;

/// The value at a level of a main effect.
double level_of(const std::function<double(double)>& at, std::size_t level) {
  constexpr double first = 0.02, last = 0.98;  // a distribution may have no ends
  return at(first + (last - first) * static_cast<double>(level) / (levels - 1));
}

/// The mean of a surface over the rows, with one of their columns at a value.
double mean_with(const analysis::GaussianProcess::Path& path, const Eigen::MatrixXd& rows,
                 Eigen::Index column, double value) {
  double sum = 0;
  Eigen::VectorXd input;
  for (Eigen::Index i = 0; i < rows.rows(); ++i) {
    input = rows.row(i).transpose();
    input(column) = value;
    sum += path(input);
  }
  return sum / static_cast<double>(rows.rows());
}

}  // namespace

std::vector<std::string> swept_words(const Study& study) {
  std::vector<std::string> words;
  for (const std::string& name : study.swept)
    if (quantity_unit(study, name).empty()) words.push_back(name);
  return words;
}

std::vector<std::string> surface_inputs(const Study& study, const StudyResults& results) {
  std::vector<std::string> inputs;
  for (const std::string& name : study.swept) {
    std::set<double> values;
    for (const JobResults& job : results.done)
      if (const auto value = quantity_value(job.scene, name)) values.insert(*value);
    if (values.size() > 1) inputs.push_back(name);
  }
  return inputs;
}

ResultSurface surface_of(const Study& study, const StudyResults& results, const std::string& result,
                         const std::map<std::string, std::string>& words) {
  check_words(study, results, words);
  const auto inputs = surface_inputs(study, results);
  if (inputs.empty())
    throw StudyError(study.name +
                     ": no quantity has several values in its done jobs, so there is no surface");
  std::vector<double> values, errors;
  std::vector<const mpm::Scene*> scenes;
  for (const JobResults& job : results.done) {
    if (!has_words(job.scene, words)) continue;
    const auto value = result_of(results, job, result);
    if (!value) continue;
    scenes.push_back(&job.scene);
    values.push_back(value->value);
    errors.push_back(value->error.value_or(0));
  }
  if (values.size() > most_runs)
    throw StudyError(
        fmt::format("{}: {} runs, and a surface takes {} at most", study.name, values.size(), most_runs));
  Eigen::MatrixXd points(std::ssize(scenes), std::ssize(inputs));
  for (std::size_t i = 0; i < scenes.size(); ++i)
    for (std::size_t k = 0; k < inputs.size(); ++k)
      points(static_cast<Eigen::Index>(i), static_cast<Eigen::Index>(k)) =
          *quantity_value(*scenes[i], inputs[k]);
  analysis::GaussianProcess process(points, values, errors);
  if (!process.ok())
    throw StudyError(fmt::format("{}: no surface of {} over {}: {}", study.name, result, listed(inputs),
                                 process.failure()));
  ResultSurface surface{result,
                        unit_of(results, result),
                        inputs,
                        {},
                        {},
                        std::move(values),
                        std::move(points),
                        std::move(process)};
  for (Eigen::Index k = 0; k < surface.points.cols(); ++k) {
    surface.low.push_back(surface.points.col(k).minCoeff());
    surface.high.push_back(surface.points.col(k).maxCoeff());
  }
  return surface;
}

Sensitivity sensitivity_of(const analysis::GaussianProcess& process,
                           const std::vector<std::function<double(double)>>& at) {
  constexpr std::uint64_t samples = 1024, paths = 40;
  const std::size_t inputs = at.size();
  const auto columns = static_cast<Eigen::Index>(inputs);
  std::vector<std::vector<double>> first(inputs), total(inputs);
  std::vector<double> means, deviations;
  constexpr Eigen::Index effect_samples = 64;
  std::vector<std::vector<std::vector<double>>> effects(inputs, std::vector<std::vector<double>>(levels));
  SplitMix64 random(1);
  for (std::uint64_t k = 0; k < paths; ++k) {
    const auto path =
        process.path([&] { return normal_quantile(random.uniform()); }, [&] { return random.uniform(); });
    const UnitSamples shares = sobol_points(samples, 2 * inputs, k);
    Eigen::MatrixXd a(samples, columns), b(samples, columns);
    for (std::size_t i = 0; i < samples; ++i)
      for (std::size_t m = 0; m < inputs; ++m) {
        a(static_cast<Eigen::Index>(i), static_cast<Eigen::Index>(m)) = at[m](shares[i][m]);
        b(static_cast<Eigen::Index>(i), static_cast<Eigen::Index>(m)) = at[m](shares[i][inputs + m]);
      }
    const auto indices = analysis::sobol_indices(path, a, b);
    for (std::size_t m = 0; m < inputs; ++m)
      for (std::size_t level = 0; level < levels; ++level)
        effects[m][level].push_back(
            mean_with(path, a.topRows(effect_samples), static_cast<Eigen::Index>(m), level_of(at[m], level)));
    means.push_back(indices.mean);
    deviations.push_back(indices.deviation);
    for (std::size_t m = 0; m < inputs && !indices.first.empty(); ++m) {
      first[m].push_back(indices.first[m]);
      total[m].push_back(indices.total[m]);
    }
  }
  const double unexplained = std::max(0.0, 1 - process.cross_validation().q2.value_or(1));
  Sensitivity sensitivity{{}, {}, {}, estimate(means), estimate(deviations)};
  for (std::size_t m = 0; m < inputs; ++m) {
    MainEffect& effect = sensitivity.effects.emplace_back();
    for (std::size_t level = 0; level < levels; ++level) {
      effect.inputs.push_back(level_of(at[m], level));
      effect.results.push_back(estimate(effects[m][level]));
    }
  }
  for (std::size_t m = 0; m < inputs; ++m) {
    sensitivity.first.push_back(first[m].empty() ? Estimate{} : widened(estimate(first[m]), unexplained));
    sensitivity.total.push_back(total[m].empty() ? Estimate{} : widened(estimate(total[m]), unexplained));
  }
  return sensitivity;
}

}  // namespace mpmstudy
