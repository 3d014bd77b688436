#include "runner/plan/gauge_text.hpp"

#include <algorithm>
#include <array>
#include <nlohmann/json.hpp>
#include <stdexcept>

namespace mpmstudy {
namespace {

using mpm::GaugeTarget;
using mpm::Window;

constexpr std::array targets = {GaugeTarget::point, GaugeTarget::place, GaugeTarget::beam,
                                GaugeTarget::body,  GaugeTarget::wall,  GaugeTarget::contact};

}  // namespace

std::string gauges_text(const std::vector<mpm::Gauge>& gauges) {
  nlohmann::ordered_json all = nlohmann::ordered_json::array();
  for (const mpm::Gauge& gauge : gauges) {
    nlohmann::ordered_json one = {{"name", gauge.name}, {"of", gauge.of}};
    auto& target = one[std::string(mpm::to_string(gauge.target))];
    if (gauge.target == GaugeTarget::body)
      target = gauge.body;
    else if (gauge.target == GaugeTarget::wall)
      target = gauge.wall;
    else if (gauge.target == GaugeTarget::contact)
      target = {gauge.first, gauge.second};
    else
      target = gauge.place;
    if (gauge.target == GaugeTarget::beam) one["direction"] = gauge.direction;
    for (const mpm::Reduction& r : gauge.reductions)
      one["reduce"].push_back({{"name", r.name},
                               {"window", std::string(mpm::to_string(r.window))},
                               {"from_s", r.from},
                               {"to_s", r.to}});
    for (const mpm::Threshold& t : gauge.stops)
      one["stop"].push_back(
          {{"when", t.below ? "below" : "above"}, {"value", t.value}, {"after_s", t.after}});
    all.push_back(std::move(one));
  }
  return all.dump();
}

std::vector<mpm::Gauge> gauges_from_text(const std::string& text) try {
  std::vector<mpm::Gauge> gauges;
  for (const auto& one : nlohmann::json::parse(text)) {
    mpm::Gauge& gauge = gauges.emplace_back();
    gauge.name = one.at("name"), gauge.of = one.at("of");
    const auto target = std::ranges::find_if(
        targets, [&](GaugeTarget t) { return one.contains(std::string(mpm::to_string(t))); });
    if (target == targets.end()) throw std::invalid_argument("it looks at nothing");
    gauge.target = *target;
    const auto& what = one.at(std::string(mpm::to_string(gauge.target)));
    if (gauge.target == GaugeTarget::body)
      gauge.body = what;
    else if (gauge.target == GaugeTarget::wall)
      gauge.wall = what;
    else if (gauge.target == GaugeTarget::contact)
      gauge.first = what.at(0), gauge.second = what.at(1);
    else
      gauge.place = what.get<std::vector<double>>();
    gauge.direction = one.value("direction", gauge.direction);
    for (const auto& r : one.value("reduce", nlohmann::json::array())) {
      const auto window = mpm::window_from(r.at("window").get<std::string>());
      if (!window) throw std::invalid_argument("it has a window of another kind");
      gauge.reductions.push_back({r.at("name"), *window, r.at("from_s"), r.at("to_s")});
    }
    for (const auto& t : one.value("stop", nlohmann::json::array()))
      gauge.stops.push_back({t.at("when") == "below", t.at("value"), t.at("after_s")});
  }
  return gauges;
} catch (const std::exception& error) {
  throw std::invalid_argument("gauges of a job cannot be read (" + std::string(error.what()) + "): " + text);
}

}  // namespace mpmstudy
