#include <algorithm>

#include "runner/study/each_table.hpp"
#include "runner/study/gauges.hpp"
#include "runner/study/quantity_text.hpp"
#include "runner/study/read_word.hpp"
#include "runner/study/requests.hpp"

namespace mpmstudy {
namespace {

/// Reads [[stop]] into the gauges.
class StopReader {
 public:
  StopReader(const std::vector<mpm::Space>& spaces, const Units& units, const KnownParameters& known,
             std::vector<GaugeRequest>& gauges, Mistakes& mistakes)
      : spaces_(spaces), units_(units), known_(known), gauges_(gauges), mistakes_(mistakes) {}

  void read(const Entry& entry, const Table& table) {
    const auto when = required_string(table, entry.place, "when", "\"rear < 0 m/s\"", mistakes_);
    if (!when) return;
    const Value& condition = table.find("when")->value;
    const std::string& text = *condition.string();
    const auto numbers = numbers_of_condition(text);
    if (numbers.empty())
      return mistakes_.add("when", condition,
                           {"not a condition", "allowed: a gauge, < or >, and a value: \"rear < 0 m/s\""});
    const auto sign = text.find_first_of("<>");
    GaugeRequest* gauge = find(std::string(trimmed(std::string_view(text).substr(0, sign))), condition);
    const auto* quantity = gauge ? mpm::find_gauge_quantity(gauge->gauge.target, gauge->gauge.of) : nullptr;
    if (!quantity) return;  // said already
    const std::string_view unit = quantity->unit_in(spaces_.front());
    if (std::ranges::any_of(spaces_, [&](mpm::Space s) { return quantity->unit_in(s) != unit; }))
      return mistakes_.add(
          "when", condition,
          {"is of another unit in each space of the study", "allowed: a study of one space"});
    const std::size_t at = gauge->gauge.stops.size();
    gauge->gauge.stops.push_back({.below = text[sign] == '<'});
    if (auto value =
            JobQuantity::read_part("when", condition, numbers.front(), {unit}, units_, known_, mistakes_))
      gauge->take(std::move(*value), [at](mpm::Gauge& g, double si) { g.stops[at].value = si; });
    if (const Entry* after = table.find("after")) {
      if (auto time = JobQuantity::read("after", after->value, {"s", mpm::Range::non_negative}, units_,
                                        known_, mistakes_))
        gauge->take(std::move(*time), [at](mpm::Gauge& g, double si) { g.stops[at].after = si; });
      gauge->keys["after"] = {after->value.place, after->value.written()};
    }
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

  const std::vector<mpm::Space>& spaces_;
  const Units& units_;
  const KnownParameters& known_;
  std::vector<GaugeRequest>& gauges_;
  Mistakes& mistakes_;
};

}  // namespace

std::vector<std::string_view> numbers_of_condition(std::string_view text) {
  const auto sign = text.find_first_of("<>");
  if (sign == text.npos || text.substr(sign + 1).starts_with('=')) return {};
  return {trimmed(text.substr(sign + 1))};
}

void read_stops(const Table& document, const std::vector<mpm::Space>& spaces, const Units& units,
                const KnownParameters& known, std::vector<GaugeRequest>& gauges, Mistakes& mistakes) {
  StopReader reader(spaces, units, known, gauges, mistakes);
  for_each_table(document, "stop", mistakes,
                 [&](const Entry& entry, const Table& table) { reader.read(entry, table); });
}

}  // namespace mpmstudy
