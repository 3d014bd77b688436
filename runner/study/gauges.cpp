#include "runner/study/gauges.hpp"

#include <algorithm>
#include <array>
#include <optional>
#include <tuple>

#include "runner/study/contact_rules.hpp"
#include "runner/study/each_table.hpp"
#include "runner/study/quantity_text.hpp"
#include "runner/study/read_word.hpp"
#include "runner/study/requests.hpp"

namespace mpmstudy {
namespace {

using mpm::GaugeTarget;

constexpr std::array targets = {GaugeTarget::point, GaugeTarget::place, GaugeTarget::beam,
                                GaugeTarget::body,  GaugeTarget::wall,  GaugeTarget::contact};
constexpr const char* one_target =
    "give one of point, place, beam (each a place such as [\"1 um\", \"2 um\"]), body = \"all\", wall = "
    "\"bottom\", contact = [\"ball\", \"plate\"]";
constexpr const char* allowed_name = "allowed: up to 60 letters, digits, '-' and '_'";
constexpr const char* allowed_reduction =
    "allowed: \"at 2 ns\", \"mean 1 ns to 3 ns\", \"max 1 ns to 3 ns\", \"min 1 ns to 3 ns\"";

class GaugeReader {
 public:
  GaugeReader(const Entry& entry, const Table& table, const Units& units, const KnownParameters& known,
              Mistakes& mistakes)
      : entry_(entry), table_(table), units_(units), known_(known), mistakes_(mistakes) {
    request_.place = entry.place;
  }

  GaugeRequest read() {
    mpm::Gauge& gauge = request_.gauge;
    gauge.name =
        required_string(table_, entry_.place, "name", "the name of its history", mistakes_).value_or("");
    if (!gauge.name.empty() && !mpm::is_gauge_name(gauge.name))
      mistakes_.add("name", value("name"), {"cannot be a gauge's name", allowed_name});
    if (!read_target()) return std::move(request_);
    std::vector<std::string_view> names;
    for (const mpm::GaugeQuantity& one : mpm::gauge_quantities(gauge.target)) names.push_back(one.name);
    gauge.of = read_word(entry_, table_, "of", "quantity of a " + std::string(mpm::to_string(gauge.target)),
                         names, mistakes_);
    remember("of");
    if (const Entry* direction = table_.find("direction")) {
      if (gauge.target != GaugeTarget::beam)
        mistakes_.add("direction", direction->value, {"only a beam has one", "remove it"});
      else
        gauge.direction =
            read_word(entry_, table_, "direction", "direction", mpm::beam_directions(3), mistakes_);
      remember("direction");
    }
    if (const Entry* reduce = table_.find("reduce")) read_reductions(*reduce);
    return std::move(request_);
  }

 private:
  const Value& value(std::string_view key) const { return table_.find(key)->value; }
  void remember(const std::string& key) {
    if (const Entry* entry = table_.find(key)) remember(key, entry->value);
  }
  void remember(const std::string& key, const Value& value) {
    request_.keys[key] = {value.place, value.written()};
  }

  /// False after a mistake about which one it is.
  bool read_target() {
    std::optional<GaugeTarget> target;
    for (const GaugeTarget one : targets) {
      const Entry* entry = table_.find(mpm::to_string(one));
      if (!entry) continue;
      if (target) {
        mistakes_.add(
            mpm::to_string(one), entry->value,
            {"a gauge looks at one thing, and this one has a " + std::string(mpm::to_string(*target)),
             "remove one, or write two gauges"});
        return false;
      }
      target = one;
    }
    if (!target) {
      mistakes_.add(entry_.place, "gauge", {"it looks at nothing", one_target});
      return false;
    }
    mpm::Gauge& gauge = request_.gauge;
    gauge.target = *target;
    const std::string key(mpm::to_string(*target));
    remember(key);
    if (*target == GaugeTarget::body)
      gauge.body = required_string(table_, entry_.place, key, "the name of a body, or \"all\"", mistakes_)
                       .value_or("all");
    else if (*target == GaugeTarget::wall)
      gauge.wall = required_string(table_, entry_.place, key, "\"bottom\"", mistakes_).value_or("bottom");
    else if (*target == GaugeTarget::contact) {
      const std::vector<std::string> pair = read_pair(key, value(key), mistakes_);
      if (!pair.empty()) gauge.first = pair[0], gauge.second = pair[1];
    } else
      read_place(value(key), key);
    return true;
  }

  void read_place(const Value& value, const std::string& key) {
    const List* list = value.list();
    if (!list || list->size() < 2 || list->size() > 3) {
      mistakes_.add(key, value,
                    {"not a place", "allowed: [\"1 um\", \"2 um\"]: x and y, in three dimensions z as well"});
      return;
    }
    for (const Value& coordinate : *list) {
      const Number number = read_quantity(coordinate, {"m"}, units_);
      std::vector<double>& place = request_.gauge.place;
      if (const double* si = std::get_if<double>(&number)) {
        place.push_back(*si + 0.0);  // -0 is 0
      } else if (const std::string* text = coordinate.string(); text && !names_in(*text).empty()) {
        if (auto expression = read_expression(key, coordinate, {"m"}, units_, known_, mistakes_))
          request_.coordinates.emplace(place.size(), std::move(*expression));
        place.push_back(0);
      } else {
        mistakes_.add(key, coordinate, std::get<Refusal>(number));
      }
    }
  }

  void read_reductions(const Entry& reduce) {
    const Table* entries = reduce.value.table();
    if (!entries) {
      mistakes_.add("reduce", reduce.value,
                    {"not a table of names",
                     "allowed: { plateau = \"mean 1 ns to 3 ns\" }; max, min and end "
                     "every gauge has"});
      return;
    }
    for (const Entry& entry : entries->entries) {
      remember("reduce." + entry.key, entry.value);
      if (mpm::is_kept_name(entry.key))
        mistakes_.add(entry.key, entry.value,
                      {"a gauge has its max, min, end and stop by itself", "allowed: another name"});
      else if (!mpm::is_gauge_name(entry.key))
        mistakes_.add(entry.key, entry.value, {"cannot be a metric's name", allowed_name});
      else if (auto reduction = read_reduction(entry))
        request_.gauge.reductions.push_back(std::move(*reduction));
    }
    std::ranges::sort(request_.gauge.reductions, {}, &mpm::Reduction::name);
  }

  std::optional<mpm::Reduction> read_reduction(const Entry& entry) {
    const auto refuse = [&](Refusal refusal) -> std::optional<mpm::Reduction> {
      mistakes_.add(entry.key, entry.value, std::move(refusal));
      return std::nullopt;
    };
    const std::string* text = entry.value.string();
    const auto space = text ? text->find(' ') : std::string::npos;
    if (space == std::string::npos) return refuse({"not a reduction", allowed_reduction});
    const std::string word = text->substr(0, space);
    const bool at = word == "at";
    const auto window = at ? mpm::Window::mean : mpm::window_from(word);
    if (!window)
      return refuse(
          unknown_word(word, "reduction", std::array<std::string_view, 4>{"at", "mean", "max", "min"}));
    const std::string times = text->substr(space + 1);
    const auto to = times.find(" to ");
    if (at != (to == std::string::npos)) return refuse({"not a reduction", allowed_reduction});
    mpm::Reduction reduction{entry.key, *window, 0, 0};
    const auto read_time = [&](const std::string& written, double& time) {
      const Number number =
          read_quantity({entry.value.place, written}, {"s", mpm::Range::non_negative}, units_);
      if (const auto* refusal = std::get_if<Refusal>(&number)) {
        refuse(*refusal);
        return false;
      }
      time = std::get<double>(number) + 0.0;
      return true;
    };
    if (!read_time(times.substr(0, to), reduction.from)) return std::nullopt;
    reduction.to = reduction.from;
    if (!at && !read_time(times.substr(to + 4), reduction.to)) return std::nullopt;
    if (reduction.to < reduction.from)
      return refuse({"ends before it begins", "allowed: the earlier time first"});
    return reduction;
  }

  const Entry& entry_;
  const Table& table_;
  const Units& units_;
  const KnownParameters& known_;
  Mistakes& mistakes_;
  GaugeRequest request_;
};

/// Without the spaces around it.
std::string trimmed(const std::string& text) {
  const auto first = text.find_first_not_of(' ');
  return first == std::string::npos ? "" : text.substr(first, text.find_last_not_of(' ') - first + 1);
}

/// Reads [[stop]] into the gauges.
class StopReader {
 public:
  StopReader(const std::vector<mpm::Space>& spaces, const Units& units, std::vector<GaugeRequest>& gauges,
             Mistakes& mistakes)
      : spaces_(spaces), units_(units), gauges_(gauges), mistakes_(mistakes) {}

  void read(const Entry& entry, const Table& table) {
    mpm::Threshold threshold;
    if (const Entry* after = table.find("after"))
      read_number(*after, {"s", mpm::Range::non_negative}, after->value, threshold.after);
    const auto when = required_string(table, entry.place, "when", "\"rear < 0 m/s\"", mistakes_);
    if (!when) return;
    const Entry& condition = *table.find("when");
    const auto sign = when->find_first_of("<>");
    if (sign == std::string::npos)
      return mistakes_.add("when", condition.value,
                           {"not a condition", "allowed: a gauge, < or >, and a value: \"rear < 0 m/s\""});
    threshold.below = (*when)[sign] == '<';
    GaugeRequest* gauge = find(trimmed(when->substr(0, sign)), condition.value);
    const auto* quantity = gauge ? mpm::find_gauge_quantity(gauge->gauge.target, gauge->gauge.of) : nullptr;
    if (!quantity) return;  // said already
    const std::string_view unit = quantity->unit_in(spaces_.front());
    if (std::ranges::any_of(spaces_, [&](mpm::Space s) { return quantity->unit_in(s) != unit; }))
      return mistakes_.add(
          "when", condition.value,
          {"is of another unit in each space of the study", "allowed: a study of one space"});
    const Value value{condition.value.place, trimmed(when->substr(sign + 1))};
    if (!read_number(condition, {unit}, value, threshold.value)) return;
    gauge->gauge.stops.push_back(threshold);
    if (const Entry* after = table.find("after"))
      gauge->keys["after"] = {after->value.place, after->value.written()};
  }

 private:
  GaugeRequest* find(const std::string& name, const Value& where) {
    std::vector<std::string_view> names;
    for (GaugeRequest& one : gauges_) {
      if (one.gauge.name == name) return &one;
      names.push_back(one.gauge.name);
    }
    mistakes_.add("when", where,
                  names.empty() ? Refusal{"there is no [[gauge]]", "add one that it can look at"}
                                : unknown_word(name, "gauge", names));
    return nullptr;
  }
  bool read_number(const Entry& entry, const Expected& expected, const Value& value, double& number) {
    const Number read = read_quantity(value, expected, units_);
    if (const auto* refusal = std::get_if<Refusal>(&read)) {
      mistakes_.add(entry.key, entry.value, *refusal);
      return false;
    }
    number = std::get<double>(read) + 0.0;
    return true;
  }

  const std::vector<mpm::Space>& spaces_;
  const Units& units_;
  std::vector<GaugeRequest>& gauges_;
  Mistakes& mistakes_;
};

}  // namespace

void read_stops(const Table& document, const std::vector<mpm::Space>& spaces, const Units& units,
                std::vector<GaugeRequest>& gauges, Mistakes& mistakes) {
  StopReader reader(spaces, units, gauges, mistakes);
  for_each_table(document, "stop", mistakes,
                 [&](const Entry& entry, const Table& table) { reader.read(entry, table); });
  for (GaugeRequest& one : gauges)
    std::ranges::sort(one.gauge.stops, {},
                      [](const mpm::Threshold& t) { return std::tuple(t.below, t.value, t.after); });
}

std::vector<GaugeRequest> read_gauges(const Table& document, const Units& units, const KnownParameters& known,
                                      Mistakes& mistakes) {
  std::vector<GaugeRequest> gauges;
  for_each_table(document, "gauge", mistakes, [&](const Entry& entry, const Table& table) {
    GaugeRequest one = GaugeReader(entry, table, units, known, mistakes).read();
    for (const GaugeRequest& other : gauges)
      if (!one.gauge.name.empty() && other.gauge.name == one.gauge.name)
        mistakes.add("name", table.find("name")->value, {"two gauges of one name", "give each its own"});
    gauges.push_back(std::move(one));
  });
  std::ranges::stable_sort(gauges, {}, [](const GaugeRequest& one) { return one.gauge.name; });
  return gauges;
}

std::string unit_of_gauge(const std::vector<const mpm::Scene*>& scenes, const std::string& metric) {
  std::vector<std::string> units;
  for (const mpm::Scene* scene : scenes)
    for (const mpm::Gauge& gauge : scene->measures.gauges) {
      if (!metric.starts_with(gauge.name + ".")) continue;
      const std::string unit(mpm::unit_of_metric(gauge, metric, scene->space));
      if (std::ranges::find(units, unit) == units.end()) units.push_back(unit);
    }
  std::string text;
  for (const std::string& unit : units) text += (text.empty() ? "" : " or ") + unit;
  return text;
}

std::vector<std::string> metrics_of(const std::vector<mpm::Gauge>& gauges) {
  std::vector<std::string> names;
  for (const mpm::Gauge& gauge : gauges)
    for (std::string& name : mpm::metrics_of(gauge)) names.push_back(std::move(name));
  return names;
}

}  // namespace mpmstudy
