#include "runner/plan/warnings.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <limits>
#include <map>
#include <set>

#include "libmpm/scene/effect.hpp"
#include "libmpm/scene/kinds/kind.hpp"
#include "libmpm/scene/parameters.hpp"
#include "libmpm/scene/resolution.hpp"
#include "runner/study/parameter_value.hpp"
#include "runner/study/readable.hpp"

namespace mpmstudy {
namespace {

constexpr double infinity = std::numeric_limits<double>::infinity();

/// What values of a quantity are usual. Outside, a prefix is likely to be wrong: "120 mPa" is 0.12 Pa.
struct Usual {
  std::string_view quantity;
  double low, high;  ///< SI; 0 and infinity are always fine where the quantity may be so
};
constexpr Usual usual_values[] = {
    {"impact_speed", 0.1, 2e4},     {"inner_speed", 0.1, 2e4},     {"yield_stress", 1e5, 1e11},
    {"reference_density", 10, 3e4}, {"youngs_modulus", 1e6, 2e12}, {"hardening_modulus", 1e5, 1e12},
    {"bulk_sound_speed", 100, 2e4}, {"hugoniot_slope", 0.1, 5},    {"gruneisen_gamma", 0.05, 10},
    {"pressure_limit", 1e8, 1e13},  {"specific_heat", 50, 1e4},    {"initial_temperature", 1, 1e4},
    {"spall_strength", 1e5, 1e11},
};

std::string place_of(const Study& study, std::string_view name) {
  const auto find = [&](std::string_view wanted) -> std::string {
    const auto found = std::ranges::find(study.given, wanted);
    if (found == study.given.end()) return {};
    return study.places[static_cast<std::size_t>(found - study.given.begin())];
  };
  std::string place = find(name);
  if (const mpm::Quantity* row = mpm::find_quantity(name); place.empty() && row)
    place = find(row->alternative);
  return place.empty() ? study.path.string() : place;
}

/// "283 nm": a thickness and a cell say enough in three digits.
std::string short_length(double metres) { return readable(std::stod(fmt::format("{:.3g}", metres)), "m"); }

/// The begin of a warning about some of the jobs.
std::string jobs_text(std::size_t some, std::size_t all) {
  return some == all ? "" : fmt::format("{} of {} jobs: ", some, all);
}

class Warnings {
 public:
  Warnings(const Study& study, const Plan& plan)
      : study_(study), plan_(plan), kind_(mpm::kind_of(study.kind)) {}

  std::vector<std::string> all() {
    lines_ = study_.warnings;
    if (study_.scenes.empty()) return lines_;
    without_effect();
    same_runs();
    unusual_values();
    thin_parts();
    bodies_that_hold_together();
    beyond_the_equation_of_state();
    short_windows();
    return std::move(lines_);
  }

 private:
  void say(std::string_view parameter, const std::string& text) {
    lines_.push_back(fmt::format("{}: {}: {}", place_of(study_, parameter), parameter, text));
  }

  void without_effect() {
    for (const std::string& name : study_.given) {
      const mpm::Condition* condition = mpm::condition_of(name);
      if (!condition || std::ranges::any_of(study_.scenes, condition->holds)) continue;
      say(name, fmt::format("has no effect: it needs {}; add that, or remove {}", condition->when, name));
    }
  }

  /// Values of what is swept that lead to one and the same run.
  void same_runs() {
    if (plan_.jobs.size() == study_.scenes.size()) return;
    std::map<std::string, const mpm::Scene*> first;
    std::map<std::string, std::size_t> same;  // by the names in which they differ
    for (const mpm::Scene& scene : study_.scenes) {
      const auto [other, is_new] = first.emplace(job_key(scene), &scene);
      if (is_new) continue;
      std::string names;
      for (const std::string& name : study_.swept)
        if (parameter_number(scene, name) != parameter_number(*other->second, name))
          names += (names.empty() ? "" : ", ") + name;
      ++same[names];
    }
    for (const auto& [names, count] : same) {
      const std::string many = count == 1 ? "1 combination is" : fmt::format("{} combinations are", count);
      lines_.push_back(fmt::format(
          "{}: {} the same run as another one: {}", study_.path.string(), many,
          names.empty() ? "a value is given twice" : "values of " + names + " have no effect there"));
    }
  }

  void unusual_values() {
    for (const Usual& usual : usual_values) {
      const mpm::Quantity* row = mpm::find_quantity(usual.quantity);
      if (!row || !row->belongs_to(study_.kind) || !is_given(usual.quantity)) continue;
      std::size_t jobs = 0;
      double first = 0;
      for (const mpm::Scene& scene : study_.scenes) {
        const double v = row->get(scene);
        if (v == 0 || v == infinity || (v >= usual.low && v <= usual.high)) continue;
        if (jobs++ == 0) first = v;
      }
      if (jobs > 0)
        say(usual.quantity, fmt::format("{}{} is unusual: {} to {} are usual; m is milli, M is mega",
                                        jobs_text(jobs, study_.scenes.size()), readable(first, row->unit),
                                        readable(usual.low, row->unit), readable(usual.high, row->unit)));
    }
  }

  /// At the coarsest cell under each job, with which the others are compared.
  void thin_parts() {
    struct Thinnest {
      mpm::ThinPart part;
      double cell;
      std::size_t jobs;
    };
    std::map<std::string_view, Thinnest> thinnest;
    for (std::size_t i = 0; i < plan_.jobs.size(); ++i) {
      const mpm::Scene& scene = plan_.ladders.empty() ? plan_.jobs[i].scene : plan_.ladders[i][0].scene;
      for (const mpm::ThinPart& part : mpm::thin_parts(scene)) {
        const auto [known, is_new] = thinnest.emplace(part.part, Thinnest{part, scene.numerics.cell_size, 0});
        ++known->second.jobs;
        if (!is_new && part.cells < known->second.part.cells)
          known->second.part = part, known->second.cell = scene.numerics.cell_size;
      }
    }
    for (const auto& [name, worst] : thinnest)
      say(worst.part.parameter,
          fmt::format("{}{} is {:.2g} cells thick ({} at a cell of {}{}); the grid shows 2 or more",
                      jobs_text(worst.jobs, plan_.jobs.size()), name, worst.part.cells,
                      short_length(worst.part.size), short_length(worst.cell),
                      plan_.ladders.empty() ? "" : ", the ladder's coarsest"));
  }

  void bodies_that_hold_together() {
    std::size_t jobs = 0;
    double earliest = infinity, end = 0;
    for (const mpm::Scene& scene : study_.scenes)
      if (const double parting = kind_.parting_time(scene); scene.end_time > parting) {
        ++jobs;
        if (parting < earliest) earliest = parting, end = scene.end_time;
      }
    if (jobs > 0)
      say("end_time",
          fmt::format("{}{} is later than about {}, when real bodies part; these hold together once they "
                      "have met",
                      jobs_text(jobs, study_.scenes.size()), readable(end, "s"), readable(earliest, "s")));
  }

  void beyond_the_equation_of_state() {
    double highest = 0, limit = 0;
    std::size_t jobs = 0;
    for (const mpm::Scene& scene : study_.scenes) {
      const double pressure = kind_.shock_pressure(scene);
      if (pressure <= scene.material.pressure_limit) continue;
      ++jobs;
      if (pressure > highest) highest = pressure, limit = scene.material.pressure_limit;
    }
    if (jobs > 0)
      say("impact_speed",
          fmt::format("{}the planar shock has {}; the equation of state is valid to pressure_limit = {}",
                      jobs_text(jobs, study_.scenes.size()), readable(highest, "Pa"), readable(limit, "Pa")));
  }

  /// Windows of gauges in which there may be no sample.
  void short_windows() {
    const auto period = [](const mpm::Scene& s) { return s.measures.area_every; };
    const double longest = period(*std::ranges::max_element(study_.scenes, {}, period));
    std::set<std::string> said;  // a window that is an expression is another one in each job
    for (const mpm::Scene& scene : study_.scenes)
      for (const mpm::Gauge& gauge : scene.measures.gauges)
        for (const mpm::Reduction& one : gauge.reductions)
          if (one.from < one.to && one.to - one.from < longest * (1 - 1e-9) &&
              said.insert(gauge.name + "." + one.name).second)
            say("gauges",
                fmt::format("{}.{} is of {}, and samples are {} apart; write a smaller area_every in "
                            "[measure]",
                            gauge.name, one.name, readable(one.to - one.from, "s"), readable(longest, "s")));
  }

  bool is_given(std::string_view name) const {
    return std::ranges::find(study_.given, name) != study_.given.end() ||
           (study_.search && study_.search->critical == name);
  }

  const Study& study_;
  const Plan& plan_;
  const mpm::Kind& kind_;
  std::vector<std::string> lines_;
};

}  // namespace

std::vector<std::string> warnings_of(const Study& study, const Plan& plan) {
  return Warnings(study, plan).all();
}

}  // namespace mpmstudy
