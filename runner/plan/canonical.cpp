#include <charconv>

#include <fmt/format.h>
#include <xxhash.h>

#include "libmpm/scene/effect.hpp"
#include "libmpm/scene/parameters.hpp"
#include "libmpm/scene/physics_version.hpp"
#include "libmpm/simulation.hpp"
#include "runner/plan/composition_text.hpp"
#include "runner/plan/plan.hpp"

namespace mpmstudy {
namespace {

/// Hexadecimal float: exact, short, the same text for the same bits. -0 is 0.
void append_number(std::string& text, double value) {
  char buffer[40];
  const auto result = std::to_chars(buffer, buffer + sizeof buffer, value + 0.0, std::chars_format::hex);
  text.append(buffer, result.ptr);
}

/// What a gauge reads, where, and what is made of it. A scene without gauges has no such line.
void append_gauge(std::string& text, const mpm::Gauge& gauge) {
  text.append("gauge=").append(gauge.name).append(" ").append(gauge.of).append(" ");
  text.append(mpm::to_string(gauge.target));
  if (gauge.target == mpm::GaugeTarget::body) text.append(" ").append(gauge.body);
  if (gauge.target == mpm::GaugeTarget::wall) text.append(" ").append(gauge.wall);
  if (gauge.target == mpm::GaugeTarget::contact)
    text.append(" ").append(gauge.first).append(" ").append(gauge.second);
  if (gauge.target == mpm::GaugeTarget::beam) text.append(" ").append(gauge.direction);
  const auto add_number = [&](double value) { text.append(" "), append_number(text, value); };
  for (const double x : gauge.place) add_number(x);
  for (const mpm::Reduction& one : gauge.reductions) {
    text.append(" ").append(one.name).append(" ").append(mpm::to_string(one.window));
    add_number(one.from), add_number(one.to);
  }
  for (const mpm::Threshold& one : gauge.stops) {
    text.append(one.below ? " stop below" : " stop above");
    add_number(one.value), add_number(one.after);
  }
  text.append("\n");
}

/// The value of a row in a job's key: where it has no effect, the one that stands for all.
template <class Row>
double value_for_key(const Row& row, const mpm::Scene& scene, bool with_inert) {
  const mpm::Condition* condition = mpm::condition_of(row.name);
  if (condition && !with_inert && !condition->holds(scene)) return condition->inert(scene);
  return static_cast<double>(row.get(scene));
}

std::string text_of(const mpm::Scene& scene, bool with_inert, std::span<const mpm::Quantity> rows) {
  std::string text = "physics_version=" + std::to_string(mpm::physics_version_of(scene)) + "\n";
  text.append("scene=").append(mpm::to_string(scene.kind)).append("\n");
  for (const mpm::Quantity& row : rows) {
    if (row.derived || !row.belongs_to(scene.kind) || value_for_key(row, scene, with_inert) == row.implied)
      continue;
    text.append(row.name).append("=");
    append_number(text, value_for_key(row, scene, with_inert));
    text.append("\n");
  }
  for (const mpm::Choice& row : mpm::choices()) {
    const std::string_view word =
        row.allowed[static_cast<std::size_t>(value_for_key(row, scene, with_inert))];
    if (!row.belongs_to(scene.kind) || word == row.implied) continue;
    text.append(row.name).append("=").append(word).append("\n");
  }
  if (const std::string composition = with_inert ? composition_text(scene) : composition_key(scene);
      !composition.empty())
    text.append("composition=").append(composition).append("\n");
  text.append("snapshots=");
  for (const double time : scene.measures.snapshots) {
    append_number(text, time);
    text.append(" ");
  }
  text.append("\n");
  for (const mpm::Gauge& gauge : scene.measures.gauges) append_gauge(text, gauge);
  return text;
}

std::string hash_of(const std::string& text) {
  const XXH128_hash_t hash = XXH3_128bits(text.data(), text.size());
  return fmt::format("{:016x}{:016x}", hash.high64, hash.low64);
}

}  // namespace

std::string canonical_text(const mpm::Scene& scene, std::span<const mpm::Quantity> rows) {
  return text_of(scene, false, rows);
}

std::string scene_text(const mpm::Scene& scene) { return text_of(scene, true, mpm::quantities()); }

std::string job_key(const mpm::Scene& scene) { return hash_of(canonical_text(scene)); }

std::string former_key(const mpm::Scene& scene) { return hash_of(scene_text(scene)); }

}  // namespace mpmstudy
