#include "runner/cli/sensitivity.hpp"

#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <cmath>
#include <functional>
#include <map>
#include <memory>
#include <nlohmann/json.hpp>

#include "analysis/sobol_indices.hpp"
#include "analysis/units.hpp"
#include "runner/cli/last_run.hpp"
#include "runner/cli/surface_text.hpp"
#include "runner/cli/text_table.hpp"
#include "runner/finish/surface.hpp"
#include "runner/study/parameter_value.hpp"
#include "runner/study/written_unit.hpp"

namespace mpmstudy {
namespace {

using Json = nlohmann::ordered_json;

/// As the study draws its values, else evenly between the ends of the runs.
std::vector<std::function<double(double)>> values_of_inputs(const Study& study,
                                                            const ResultSurface& surface) {
  std::vector<std::function<double(double)>> at;
  for (std::size_t k = 0; k < surface.inputs.size(); ++k) {
    const auto drawn = study.distributions.find(surface.inputs[k]);
    if (drawn != study.distributions.end())
      at.push_back(drawn->second);
    else
      at.push_back([low = surface.low[k], high = surface.high[k]](double share) {
        return low + (high - low) * share;
      });
  }
  return at;
}

double rank_of(const ResultSurface& surface, std::size_t input) {
  const auto column = surface.points.col(static_cast<Eigen::Index>(input));
  return analysis::rank_correlation({column.begin(), column.end()}, surface.values);
}

/// "0.42 at 102 m/s, 0.97 at 394 m/s": the ends of a main effect.
std::string effect_text(const Study& study, const ResultSurface& surface, std::size_t input,
                        const MainEffect& effect) {
  const std::string& name = surface.inputs[input];
  const auto end = [&](std::size_t level) {
    const double result = effect.results[level].value;
    const auto unit = analysis::display_unit(surface.unit, std::abs(result));
    return fmt::format("{:.3g}{}{} at {}", result * unit.factor, unit.text.empty() ? "" : " ", unit.text,
                       in_written_unit(std::stod(fmt::format("{:.3g}", effect.inputs[level])),
                                       quantity_unit(study, name), name, study.units));
  };
  return end(0) + ", " + end(effect.inputs.size() - 1);
}

void print_text(const Study& study, const ResultSurface& surface, const Sensitivity& s) {
  const auto interval = [](const Estimate& e) { return fmt::format("{:.2f} to {:.2f}", e.low, e.high); };
  std::vector<TextColumn> columns = {{"parameter", "", {}, true},
                                     {"first", "", {}},
                                     {"(95 %)", "", {}, true},
                                     {"total", "", {}},
                                     {"(95 %)", "", {}, true},
                                     {"rank", "", {}},
                                     {"mean of the result", "", {}, true}};
  for (std::size_t k = 0; k < surface.inputs.size(); ++k) {
    columns[0].cells.push_back(surface.inputs[k]);
    columns[1].cells.push_back(fmt::format("{:.3f}", s.first[k].value));
    columns[2].cells.push_back(interval(s.first[k]));
    columns[3].cells.push_back(fmt::format("{:.3f}", s.total[k].value));
    columns[4].cells.push_back(interval(s.total[k]));
    columns[5].cells.push_back(fmt::format("{:+.2f}", rank_of(surface, k)));
    columns[6].cells.push_back(effect_text(study, surface, k, s.effects[k]));
  }
  fmt::print("\n{}: {}\n{}", study.name, surface.result, text_table(columns));
  fmt::print("  mean {}), standard deviation {}); inputs {}\n{}", interval_text(s.mean, surface.unit, " ("),
             interval_text(s.deviation, surface.unit, " ("),
             study.distributions.empty() ? "even between the ends of the runs" : "as the study draws them",
             quality_text(surface));
}

/// Of each value of an input, SI: the mean of the result and its interval.
Json effect_json(const MainEffect& effect) {
  Json json = Json::array();
  for (std::size_t i = 0; i < effect.inputs.size(); ++i)
    json.push_back({{"at", effect.inputs[i]},
                    {"value", effect.results[i].value},
                    {"low", effect.results[i].low},
                    {"high", effect.results[i].high}});
  return json;
}

Json to_json(const ResultSurface& surface, const Sensitivity& s) {
  const auto estimate = [](const Estimate& e) {
    return Json{{"value", e.value}, {"low", e.low}, {"high", e.high}};
  };
  Json parameters = Json::object();
  for (std::size_t k = 0; k < surface.inputs.size(); ++k)
    parameters[surface.inputs[k]] = {{"first", estimate(s.first[k])},
                                     {"total", estimate(s.total[k])},
                                     {"rank_correlation", rank_of(surface, k)},
                                     {"main_effect", effect_json(s.effects[k])}};
  Json json = {{"result", surface.result},
               {"unit", surface.unit},
               {"parameters", std::move(parameters)},
               {"mean", estimate(s.mean)},
               {"deviation", estimate(s.deviation)}};
  json.update(quality_json(surface));
  return json;
}

}  // namespace

void setup_sensitivity(CLI::App& app) {
  const auto options = std::make_shared<SensitivityOptions>();
  CLI::App& verb = *app.add_subcommand(
      "sensitivity",
      "Say how much each swept parameter does to a result: Sobol indices of a surface through the runs");
  verb.add_option("STUDY", options->name, "Name of a study, or its file")->required();
  verb.add_option("--of", options->of, "Which result [those of the study's fits and figures]")
      ->type_name("RESULT")
      ->allow_extra_args(false);
  verb.add_option("--at", options->at, "Of a study that sweeps words, which: --at material=copper")
      ->type_name("KEY=VALUE")
      ->allow_extra_args(false);
  verb.add_flag("--json", options->json, "One JSON object, SI units");
  add_study_options(verb, options->study);
  add_results_option(verb, options->results);
  verb.callback([options] { end_with(run_sensitivity(*options)); });
}

int run_sensitivity(const SensitivityOptions& options) {
  const StudyForm form = form_named(options.name, options.study, options.results);
  const Study study = read_study(form.path, form.options);
  const StudyResults results = read_results(study, options.results);
  std::map<std::string, std::string> words;
  for (const std::string& text : options.at) {
    const auto equals = text.find('=');
    if (equals == std::string::npos) throw StudyError("--at: " + text + ": not KEY=VALUE");
    words[text.substr(0, equals)] = text.substr(equals + 1);
  }
  Json all = Json::array();
  for (const std::string& name : results_to_show(study, options.of)) {
    const ResultSurface surface = surface_of(study, results, name, words);
    const Sensitivity sensitivity = sensitivity_of(surface.process, values_of_inputs(study, surface));
    if (options.json)
      all.push_back(to_json(surface, sensitivity));
    else
      print_text(study, surface, sensitivity);
  }
  if (options.json) fmt::print("{}\n", Json{{"study", study.name}, {"results", std::move(all)}}.dump(2));
  return exit_ok;
}

}  // namespace mpmstudy
