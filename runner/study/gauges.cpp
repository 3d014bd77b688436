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
    request_.gauge.place.resize(list->size());
    for (std::size_t axis = 0; axis < list->size(); ++axis)
      if (auto number = JobQuantity::read(key, (*list)[axis], {"m"}, units_, known_, mistakes_))
        request_.take(std::move(*number), [axis](mpm::Gauge& gauge, double si) { gauge.place[axis] = si; });
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
      else
        read_reduction(entry);
    }
    std::ranges::sort(request_.gauge.reductions, {}, &mpm::Reduction::name);
  }

  void read_reduction(const Entry& entry) {
    const std::string* text = entry.value.string();
    const auto times = text ? numbers_of_reduction(*text) : std::vector<std::string_view>{};
    if (times.empty()) return mistakes_.add(entry.key, entry.value, {"not a reduction", allowed_reduction});
    const std::string word = text->substr(0, text->find(' '));
    const bool at = word == "at";
    const auto window = at ? mpm::Window::mean : mpm::window_from(word);
    if (!window)
      return mistakes_.add(
          entry.key, entry.value,
          unknown_word(word, "reduction", std::array<std::string_view, 4>{"at", "mean", "max", "min"}));
    if (at != (times.size() == 1))
      return mistakes_.add(entry.key, entry.value, {"not a reduction", allowed_reduction});
    request_.gauge.reductions.push_back({entry.key, *window, 0, 0});
    const auto take = [&](std::string_view time, double mpm::Reduction::*of) {
      auto number = JobQuantity::read_part(entry.key, entry.value, time, {"s", mpm::Range::non_negative},
                                           units_, known_, mistakes_);
      if (number)
        request_.take(std::move(*number), [name = entry.key, of](mpm::Gauge& gauge, double si) {
          (*std::ranges::find(gauge.reductions, name, &mpm::Reduction::name)).*of = si;
        });
      return number.has_value();
    };
    const std::size_t of_job = request_.of_job.size();
    if (!take(times.front(), &mpm::Reduction::from) || !take(times.back(), &mpm::Reduction::to)) return;
    const mpm::Reduction& reduction = request_.gauge.reductions.back();
    // what is an expression is compared job by job
    if (request_.of_job.size() == of_job && reduction.to < reduction.from)
      mistakes_.add(entry.key, entry.value, {"ends before it begins", "allowed: the earlier time first"});
  }

  const Entry& entry_;
  const Table& table_;
  const Units& units_;
  const KnownParameters& known_;
  Mistakes& mistakes_;
  GaugeRequest request_;
};

}  // namespace

void GaugeRequest::take(JobQuantity number, std::function<void(mpm::Gauge&, double)> set) {
  if (const double* si = number.constant())
    set(gauge, *si);
  else
    of_job.push_back({std::move(number), std::move(set)});
}

void GaugeRequest::value_in(mpm::Gauge& of_job_gauge, const ValueOf& value, Mistakes& mistakes) const {
  for (const OfJob& one : of_job)
    if (const auto si = one.number.value(value, mistakes)) one.set(of_job_gauge, *si);
  std::ranges::sort(of_job_gauge.stops, {},
                    [](const mpm::Threshold& t) { return std::tuple(t.below, t.value, t.after); });
}

std::vector<std::string_view> numbers_of_reduction(std::string_view text) {
  const auto space = text.find(' ');
  if (space == text.npos) return {};
  const std::string_view times = text.substr(space + 1);
  const auto to = times.find(" to ");
  if (to == times.npos) return {times};
  return {times.substr(0, to), times.substr(to + 4)};
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
