#include "runner/cli/surface_text.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "analysis/units.hpp"
#include "libmpm/measure/results.hpp"
#include "runner/cli/print_results.hpp"
#include "runner/study/schema.hpp"
#include "runner/study/searched.hpp"
#include "runner/surface/surface_state.hpp"

namespace mpmstudy {
namespace {

std::string number_text(double value, const std::string& si_unit) {
  const auto unit = analysis::display_unit(si_unit, std::abs(value));
  return fmt::format("{:.3g}{}{}", value * unit.factor, unit.text.empty() ? "" : " ", unit.text);
}

}  // namespace

std::vector<std::string> results_to_show(const Study& study, const std::vector<std::string>& named) {
  for (const std::string& name : named) {
    if (mpm::find_result(name) || mpm::is_of_gauge(name) || critical_result(name)) continue;
    std::vector<std::string_view> known;
    for (const mpm::ResultRow& row : mpm::results())
      if (row.belongs_to(study.kind)) known.push_back(row.name);
    const Refusal refusal = unknown_word(name, "result", known);
    throw StudyError("--of: " + name + ": " + refusal.wrong + "; " + refusal.allowed);
  }
  if (!named.empty()) return named;
  constexpr std::size_t most = 3;
  const auto names = results_of_interest(study, most);
  if (names.empty())
    throw StudyError(study.name + ": say --of RESULT; its file has no fit, no figure of one and no gauge");
  return names;
}

std::string interval_text(const Estimate& estimate, const std::string& si_unit, const char* between) {
  const double largest =
      std::max({std::abs(estimate.value), std::abs(estimate.low), std::abs(estimate.high)});
  const auto unit = analysis::display_unit(si_unit, largest);
  return fmt::format("{:.4g}{}{}{}{:.4g} to {:.4g}", estimate.value * unit.factor,
                     unit.text.empty() ? "" : " ", unit.text, between, estimate.low * unit.factor,
                     estimate.high * unit.factor);
}

std::string quality_text(const ResultSurface& surface) {
  const auto& cross = surface.process.cross_validation();
  const auto runs = surface.values.size();
  return fmt::format(
      "    from {} runs; each left out in turn: error {} (rms){}, {:.0f} of {} within the 95 % interval\n",
      runs, number_text(cross.rms, surface.unit), cross.q2 ? fmt::format(", Q2 = {:.3f}", *cross.q2) : "",
      std::round(cross.covered * static_cast<double>(runs)), runs);
}

namespace {

/// By the done jobs of the study.
SurfaceState state_of(const Study& study, const StudyResults& results) {
  std::vector<SurfaceRun> runs;
  for (const JobResults& job : results.done) {
    runs.push_back({&job.scene, {}, 0});
    if (const auto value = result_of(results, job, study.surface->of)) {
      runs.back().value = value->value;
      runs.back().error = value->error.value_or(0);
    }
  }
  return surface_state(study, runs);
}

}  // namespace

std::string tolerance_text(const Study& study, const std::filesystem::path& results) {
  if (!study.surface) return "";
  const StudyResults read = read_results(study, results);
  const SurfaceState state = state_of(study, read);
  return fmt::format("  surface of {}, tolerance {}: {} runs of at most {}; {}\n", study.surface->of,
                     state.holds() ? "holds" : "does not hold", read.done.size(), study.surface->budget,
                     readable_state(study, state));
}

nlohmann::ordered_json tolerance_json(const Study& study, const std::filesystem::path& results) {
  if (!study.surface) return nullptr;
  const StudyResults read = read_results(study, results);
  const SurfaceState state = state_of(study, read);
  return {{"of", study.surface->of},      {"runs", read.done.size()}, {"budget", study.surface->budget},
          {"tolerance", state.tolerance}, {"share", state.share},     {"holds", state.holds()},
          {"failure", state.failure}};
}

nlohmann::ordered_json quality_json(const ResultSurface& surface) {
  const auto& cross = surface.process.cross_validation();
  return {{"runs", surface.values.size()},
          {"left_out_rms", cross.rms},
          {"left_out_q2", cross.q2 ? nlohmann::ordered_json(*cross.q2) : nlohmann::ordered_json(nullptr)},
          {"left_out_covered", cross.covered}};
}

}  // namespace mpmstudy
