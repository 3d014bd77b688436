#include "runner/surface/surface_state.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numbers>

#include "analysis/units.hpp"
#include "libmpm/measure/results.hpp"
#include "runner/study/parameter_value.hpp"

namespace mpmstudy {
namespace {

constexpr double wanted_share = 0.9;
constexpr std::size_t least_of_each = 10;
constexpr double half_width_90 = 1.6448536269514722;  // over the standard deviation

/// How much larger than the surface says deviations are, by the runs left out; 1 or more.
double widening(const analysis::GaussianProcess& process) {
  std::vector<double> errors = process.left_out_scores();
  for (double& error : errors) error = std::abs(error);
  const auto nine_of_ten =
      static_cast<std::size_t>(std::ceil(wanted_share * static_cast<double>(errors.size())));
  std::ranges::nth_element(errors, errors.begin() + static_cast<std::ptrdiff_t>(nine_of_ten - 1));
  return std::max(1.0, errors[nine_of_ten - 1] / half_width_90);
}

/// Of a normal distribution: of being within a number of standard deviations.
double probability_within(double deviations) { return std::erf(deviations / std::numbers::sqrt2); }

}  // namespace

Eigen::MatrixXd places_of(const Study& study, const std::vector<const mpm::Scene*>& scenes) {
  Eigen::MatrixXd places(std::ssize(scenes), std::ssize(study.swept));
  for (std::size_t i = 0; i < scenes.size(); ++i)
    for (std::size_t k = 0; k < study.swept.size(); ++k)
      places(static_cast<Eigen::Index>(i), static_cast<Eigen::Index>(k)) =
          quantity_value(*scenes[i], study.swept[k]).value_or(0);
  return places;
}

SurfaceState surface_state(const Study& study, const std::vector<SurfaceRun>& runs) {
  const SurfaceRequest& request = *study.surface;
  SurfaceState state;
  state.runs = runs.size();
  state.least = least_of_each * study.swept.size();
  std::vector<const mpm::Scene*> scenes;
  std::vector<double> values, errors;
  for (const SurfaceRun& run : runs) {
    if (!run.value) continue;
    scenes.push_back(run.scene);
    values.push_back(*run.value);
    errors.push_back(run.error);
  }
  state.shown = values.size();
  analysis::GaussianProcess process(places_of(study, scenes), values, errors);
  state.failure = process.failure();
  if (!process.ok()) return state;
  const auto [least, most] = std::ranges::minmax(values);
  state.tolerance = request.is_share ? request.tolerance * (most - least) : request.tolerance;
  std::vector<const mpm::Scene*> candidates;
  for (const mpm::Scene& scene : request.candidates) candidates.push_back(&scene);
  const Eigen::MatrixXd places = places_of(study, candidates);
  const double wider = widening(process);
  for (Eigen::Index i = 0; i < places.rows(); ++i) {
    const double deviation =
        wider * std::hypot(process.at(places.row(i).transpose()).deviation, process.run_deviation());
    state.share += (deviation > 0 ? probability_within(state.tolerance / deviation) : 1) /
                   static_cast<double>(places.rows());
  }
  state.process = std::move(process);
  return state;
}

std::string readable_state(const Study& study, const SurfaceState& state) {
  if (!state.failure.empty()) return state.failure;
  const mpm::ResultRow* row = mpm::find_result(study.surface->of);
  const std::string si = row ? analysis::with_powers(row->unit) : "1";
  const auto unit = analysis::display_unit(si, state.tolerance);
  return fmt::format(
      "a run would be within {:.3g}{}{} of it at {:.0f} % of the places, wanted are {:.0f} %{}",
      state.tolerance * unit.factor, unit.text.empty() ? "" : " ", unit.text, std::floor(100 * state.share),
      100 * wanted_share, state.shown < state.least ? fmt::format(" by {} runs or more", state.least) : "");
}

bool SurfaceState::holds() const { return failure.empty() && share >= wanted_share && shown >= least; }

}  // namespace mpmstudy
