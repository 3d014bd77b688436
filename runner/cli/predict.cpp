#include "runner/cli/predict.hpp"

#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <algorithm>
#include <cmath>
#include <iostream>
#include <map>
#include <memory>
#include <nlohmann/json.hpp>

#include "runner/catalog/row_format.hpp"
#include "runner/cli/last_run.hpp"
#include "runner/cli/surface_text.hpp"
#include "runner/finish/surface.hpp"
#include "runner/study/parameter_value.hpp"
#include "runner/study/points_file.hpp"
#include "runner/study/quantity_text.hpp"
#include "runner/study/schema.hpp"
#include "runner/study/units.hpp"
#include "runner/study/written_unit.hpp"

namespace mpmstudy {
namespace {

using Json = nlohmann::ordered_json;

/// Where a surface is asked.
struct Asked {
  std::map<std::string, double> quantities;  ///< SI
  std::map<std::string, std::string> words;
};

double quantity_of(const Study& study, const std::string& name, const Value& value, const Units& units,
                   Mistakes& mistakes) {
  const std::string unit = quantity_unit(study, name);
  const Number number = read_quantity(value, {unit, mpm::Range::any}, units);
  if (const auto* si = std::get_if<double>(&number)) return *si;
  mistakes.add(name, value, std::get<Refusal>(number));
  return 0;
}

/// Adds a mistake for a name that is no input of the surface.
bool is_input(const Study& study, const std::vector<std::string>& inputs, const std::string& name,
              const Place& place, const std::string& written, Mistakes& mistakes) {
  auto allowed = inputs;
  for (const std::string& word : swept_words(study)) allowed.push_back(word);
  if (std::ranges::find(allowed, name) != allowed.end()) return true;
  mistakes.add(place, name, written, unknown_word(name, "swept parameter of " + study.name, allowed));
  return false;
}

/// --at KEY=VALUE ...
Asked read_place(const Study& study, const std::vector<std::string>& inputs,
                 const std::vector<std::string>& at, const Units& units, Mistakes& mistakes) {
  Asked place;
  for (const std::string& text : at) {
    const auto equals = text.find('=');
    if (equals == std::string::npos || equals == 0)
      throw StudyError("--at: " + text + ": not KEY=VALUE; write for example --at impact_speed=\"250 m/s\"");
    const std::string name = text.substr(0, equals);
    Value value = read_value(name, text.substr(equals + 1));
    value.place.file = "--at";
    if (!is_input(study, inputs, name, value.place, value.written(), mistakes)) continue;
    if (quantity_unit(study, name).empty())
      place.words[name] = text.substr(equals + 1);
    else
      place.quantities[name] = quantity_of(study, name, value, units, mistakes);
  }
  return place;
}

/// The lines of a CSV file, on top of what --at says of all of them.
std::vector<Asked> read_places(const Study& study, const std::vector<std::string>& inputs,
                               const std::string& file, const Asked& of_all, const Units& units,
                               Mistakes& mistakes) {
  const auto columns = read_point_columns(file, mistakes);
  if (!columns) throw StudyError("--points: " + file + ": cannot be read; allowed: a CSV file");
  mistakes.throw_if_any();
  std::vector<Asked> places(columns->empty() ? 0 : columns->front().values.size(), of_all);
  for (const PointColumn& column : *columns) {
    if (!is_input(study, inputs, column.name, column.place, "\"" + column.name + "\"", mistakes)) continue;
    const std::string si = quantity_unit(study, column.name);
    std::optional<Conversion> conversion;
    if (column.unit) {
      const auto found = units.conversion(*column.unit, si);
      if (const auto* wrong = std::get_if<std::string>(&found)) {
        mistakes.add(column.place, column.name, {*wrong, "allowed: a unit that converts to " + si});
        continue;
      }
      conversion = std::get<Conversion>(found);
    }
    for (std::size_t i = 0; i < places.size(); ++i) {
      const Value& value = column.values[i];
      if (si.empty()) {
        places[i].words[column.name] = value.string() ? *value.string() : value.number_text();
      } else if (conversion) {
        const Number number = read_number(value, *conversion, {si, mpm::Range::any});
        if (const auto* number_si = std::get_if<double>(&number))
          places[i].quantities[column.name] = *number_si;
        else
          mistakes.add(column.name, value, std::get<Refusal>(number));
      } else {
        places[i].quantities[column.name] = quantity_of(study, column.name, value, units, mistakes);
      }
    }
  }
  return places;
}

/// Surfaces by result and words, each made once.
class Surfaces {
 public:
  Surfaces(const Study& study, const StudyResults& results) : study_(study), results_(results) {}
  const ResultSurface& of(const std::string& result, const std::map<std::string, std::string>& words) {
    const auto known = made_.find({result, words});
    if (known != made_.end()) return known->second;
    return made_.emplace(std::pair(result, words), surface_of(study_, results_, result, words)).first->second;
  }

 private:
  const Study& study_;
  const StudyResults& results_;
  std::map<std::pair<std::string, std::map<std::string, std::string>>, ResultSurface> made_;
};

/// The inputs in the order of the surface; names in `outside` those beyond the runs.
Eigen::VectorXd input_of(const Study& study, const ResultSurface& surface, const Asked& place,
                         std::vector<std::string>& outside) {
  Eigen::VectorXd input(std::ssize(surface.inputs));
  std::string missing;
  for (std::size_t k = 0; k < surface.inputs.size(); ++k) {
    const std::string& name = surface.inputs[k];
    const auto found = place.quantities.find(name);
    const auto text = [&](double si) {
      // six digits: the runs of a sequence are at no round numbers
      return in_written_unit(std::stod(fmt::format("{:.6g}", si)), quantity_unit(study, name), name,
                             study.units);
    };
    const std::string range = fmt::format("{} ({} to {})", name, text(surface.low[k]), text(surface.high[k]));
    if (found == place.quantities.end()) {
      missing += (missing.empty() ? "" : ", ") + range;
      continue;
    }
    input(static_cast<Eigen::Index>(k)) = found->second;
    if (found->second < surface.low[k] || found->second > surface.high[k])
      outside.push_back(fmt::format("{} = {} is outside of the runs: {}", name, text(found->second), range));
  }
  if (!missing.empty()) throw StudyError("--at: the surface is over more; missing: " + missing);
  return input;
}

struct PredictedValue {
  const ResultSurface* surface;
  double value, low, high;
  std::vector<std::string> outside;
};

std::vector<PredictedValue> answers_of(const Study& study, Surfaces& surfaces,
                                       const std::vector<std::string>& names, const Asked& place) {
  std::vector<PredictedValue> answers;
  for (const std::string& name : names) {
    const ResultSurface& surface = surfaces.of(name, place.words);
    PredictedValue answer{&surface, 0, 0, 0, {}};
    const auto [value, deviation] = surface.process.at(input_of(study, surface, place, answer.outside));
    answer.value = value;
    answer.low = value - analysis::half_width_95 * deviation;
    answer.high = value + analysis::half_width_95 * deviation;
    answers.push_back(std::move(answer));
  }
  return answers;
}

Json to_json(const PredictedValue& a) {
  Json json = {{"value", a.value},
               {"low", a.low},
               {"high", a.high},
               {"unit", a.surface->unit},
               {"outside", a.outside}};
  json.update(quality_json(*a.surface));
  return json;
}

void print_text(const Study& study, const std::vector<PredictedValue>& answers,
                const std::vector<std::string>& at) {
  fmt::print("{} at {}\n", study.name, listed(at));
  for (const PredictedValue& a : answers)
    fmt::print("  {}  {} (95 %)\n{}", a.surface->result,
               interval_text({a.value, a.low, a.high}, a.surface->unit, ", "), quality_text(*a.surface));
}

void print_csv(const std::vector<std::string>& inputs, const std::vector<std::string>& words,
               const Study& study, const std::vector<Asked>& places,
               const std::vector<std::vector<PredictedValue>>& answers) {
  std::string head;
  for (const std::string& word : words) head += word + ",";
  for (const std::string& name : inputs) {
    const std::string unit = quantity_unit(study, name);
    head += name + (unit == "1" ? "" : " [" + unit + "]") + ",";
  }
  for (const PredictedValue& a : answers.front())
    head += fmt::format("{0},{0}_low,{0}_high,", a.surface->result);
  head += "outside";
  fmt::print("{}\n", head);
  for (std::size_t i = 0; i < places.size(); ++i) {
    std::string line;
    for (const std::string& word : words) {
      const auto given = places[i].words.find(word);
      line += (given == places[i].words.end() ? "" : given->second) + ",";
    }
    for (const std::string& name : inputs) line += shortest(places[i].quantities.at(name)) + ",";
    bool outside = false;
    for (const PredictedValue& a : answers[i]) {
      line += fmt::format("{},{},{},", shortest(a.value), shortest(a.low), shortest(a.high));
      outside = outside || !a.outside.empty();
    }
    fmt::print("{}{}\n", line, outside ? 1 : 0);
  }
}

}  // namespace

void setup_predict(CLI::App& app) {
  const auto options = std::make_shared<PredictOptions>();
  CLI::App& verb = *app.add_subcommand(
      "predict", "Say what a result is where there is no run, by a surface through the runs");
  verb.add_option("STUDY", options->name, "Name of a study, or its file")->required();
  verb.add_option("--at", options->at, "Where: --at impact_speed=\"250 m/s\", one for each swept parameter")
      ->type_name("KEY=VALUE")
      ->allow_extra_args(false);
  verb.add_option("--points", options->points,
                  "Many places: a CSV file as [sweep] points has them; prints CSV")
      ->type_name("FILE");
  verb.add_option("--of", options->of, "Which result [those of the study's fits and figures]")
      ->type_name("RESULT")
      ->allow_extra_args(false);
  verb.add_flag("--json", options->json, "One JSON object, SI units");
  add_study_options(verb, options->study);
  add_results_option(verb, options->results);
  verb.callback([options] { end_with(run_predict(*options)); });
}

int run_predict(const PredictOptions& options) {
  const StudyForm form = form_named(options.name, options.study, options.results);
  const Study study = read_study(form.path, form.options);
  const StudyResults results = read_results(study, options.results);
  const auto inputs = surface_inputs(study, results);
  const auto names = results_to_show(study, options.of);
  const Units units;
  Mistakes mistakes;
  const Asked place = read_place(study, inputs, options.at, units, mistakes);
  const auto places = options.points.empty()
                          ? std::vector{place}
                          : read_places(study, inputs, options.points, place, units, mistakes);
  mistakes.throw_if_any();
  if (places.empty()) throw StudyError("--points: " + options.points + ": has no points");
  Surfaces surfaces(study, results);
  std::vector<std::vector<PredictedValue>> answers;
  for (const Asked& one : places) answers.push_back(answers_of(study, surfaces, names, one));
  if (options.json) {
    Json json = Json::array();
    for (const auto& of_place : answers) {
      Json one;
      for (const PredictedValue& a : of_place) one[a.surface->result] = to_json(a);
      json.push_back(std::move(one));
    }
    fmt::print("{}\n", Json{{"study", study.name}, {"predictions", std::move(json)}}.dump(2));
    return exit_ok;
  }
  if (options.points.empty()) {
    print_text(study, answers.front(), options.at);
  } else {
    print_csv(inputs, swept_words(study), study, places, answers);
    for (const PredictedValue& a : answers.front())
      fmt::print(stderr, "{}\n{}", a.surface->result, quality_text(*a.surface));
  }
  constexpr std::size_t most = 5;
  std::vector<std::string> outside;
  for (const auto& of_place : answers)
    for (const std::string& one : of_place.front().outside) outside.push_back(one);
  for (std::size_t i = 0; i < std::min(most, outside.size()); ++i) fmt::print(stderr, "{}\n", outside[i]);
  if (outside.size() > most) fmt::print(stderr, "... {} more\n", outside.size() - most);
  return exit_ok;
}

}  // namespace mpmstudy
