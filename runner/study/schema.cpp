#include "runner/study/schema.hpp"

#include "libmpm/scene/kinds/kind.hpp"
#include "runner/study/bodies.hpp"
#include "runner/study/contact_rules.hpp"

#include <algorithm>
#include <array>
#include <cctype>

namespace mpmstudy {
namespace {

/// Keys that are not rows of the parameter table. `material` is the name of one; [material] changes it.
struct Keys {
  std::string_view table;
  std::vector<std::string_view> keys;
};
const std::vector<Keys>& other_keys() {
  static const std::vector<Keys> keys = {
      {"", {"schema", "name", "title", "scene"}},
      {"parameters", {mpm::material_choice().name}},
      {"material", {}},
      {"sweep", {"mode", "samples", "seed", "points", "zip", "require", "invalid"}},
      {"numerics", {"accuracy", "accuracy_of", "ladder"}},
      {"measure", {"snapshots"}},
      {"search", {"critical", "outcome", "between", "tolerance"}},
      {"surface", {"of", "tolerance", "budget", "batch"}},
      {"expect", {"outcome", "energy_error", "reason", "why"}},
      {"fit", {"x", "y", "model"}},
      {"gauge", {"name", "of", "point", "place", "beam", "direction", "body", "wall", "contact", "reduce"}},
      {"stop", {"when", "after"}},
      {"figure", {"name", "title", "kind", "x", "y", "colour", "log", "slice", "projection"}},
  };
  return keys;
}

/// Of kinds whose scenes are composed in the file; runner/study/bodies.hpp reads them.
constexpr std::array composition_tables = {box_table, faces_table, body_table, materials_table,
                                           contact_table};

/// "in [parameters]".
std::string where(std::string_view table) {
  if (table.empty()) return "at the top of the file";
  return is_array_table(table) ? "in [[" + std::string(table) + "]]" : "in [" + std::string(table) + "]";
}

/// Edits (insert, delete, replace, swap of neighbours) that make b of a.
std::size_t edit_distance(std::string_view a, std::string_view b) {
  std::vector<std::vector<std::size_t>> d(a.size() + 1, std::vector<std::size_t>(b.size() + 1));
  for (std::size_t i = 0; i <= a.size(); ++i) d[i][0] = i;
  for (std::size_t j = 0; j <= b.size(); ++j) d[0][j] = j;
  for (std::size_t i = 1; i <= a.size(); ++i)
    for (std::size_t j = 1; j <= b.size(); ++j) {
      d[i][j] = std::min({d[i - 1][j] + 1, d[i][j - 1] + 1, d[i - 1][j - 1] + (a[i - 1] != b[j - 1])});
      if (i > 1 && j > 1 && a[i - 1] == b[j - 2] && a[i - 2] == b[j - 1])
        d[i][j] = std::min(d[i][j], d[i - 2][j - 2] + 1);
    }
  return d[a.size()][b.size()];
}

/// Kinds of scene that have a row of the parameter table.
std::string kinds_with(std::string_view key) {
  std::vector<std::string_view> kinds;
  for (const std::string_view name : mpm::scene_kind_names()) {
    const mpm::SceneKind kind = *mpm::scene_kind_from(name);
    const mpm::Quantity* quantity = mpm::find_quantity(key);
    const mpm::Choice* choice = mpm::find_choice(key);
    if ((quantity && quantity->belongs_to(kind)) || (choice && choice->belongs_to(kind)))
      kinds.push_back(name);
  }
  return listed(kinds);
}

}  // namespace

std::string_view table_name(mpm::Section section) {
  switch (section) {
    case mpm::Section::top:
      return "";
    case mpm::Section::parameters:
      return "parameters";
    case mpm::Section::material:
      return "material";
    case mpm::Section::numerics:
      return "numerics";
    case mpm::Section::measure:
      return "measure";
  }
  return "";
}

bool is_array_table(std::string_view table) {
  return table == "fit" || table == "figure" || table == "gauge" || table == "stop";
}

std::vector<std::string_view> table_names() {
  std::vector<std::string_view> names;
  for (const Keys& keys : other_keys()) names.push_back(keys.table);
  return names;
}

std::vector<std::string_view> keys_of(std::string_view table, std::optional<mpm::SceneKind> kind) {
  std::vector<std::string_view> keys;
  for (const Keys& other : other_keys())
    if (other.table == table) keys = other.keys;
  const auto add_rows = [&](const auto& rows) {
    for (const auto& row : rows)
      if (table_name(row.section) == table && (!kind || row.belongs_to(*kind))) keys.push_back(row.name);
  };
  add_rows(mpm::quantities());
  add_rows(mpm::choices());
  return keys;
}

std::optional<std::string_view> table_of(std::string_view key) {
  for (const std::string_view table : table_names()) {
    if (is_array_table(table)) continue;
    const auto keys = keys_of(table);
    if (std::find(keys.begin(), keys.end(), key) != keys.end()) return table;
  }
  return std::nullopt;
}

Refusal unknown_key(std::string_view key, std::string_view table, std::optional<mpm::SceneKind> kind) {
  const auto here = keys_of(table);
  if (kind && std::find(here.begin(), here.end(), key) != here.end())
    return {std::string(mpm::to_string(*kind)) + " has no such parameter",
            "it belongs to: " + kinds_with(key) + "; remove it, or change scene"};
  if (const auto home = table_of(key); home && *home != table)
    return {"does not belong " + where(table), "it is allowed " + where(*home)};

  auto candidates = keys_of(table, kind);
  if (table.empty())
    for (const std::string_view name : table_names())
      if (!name.empty()) candidates.push_back(name);
  if (const std::string_view near = nearest(key, candidates); !near.empty())
    return {"unknown key", "did you mean " + std::string(near) + "?"};
  for (const std::string_view other : table_names()) {
    const std::string_view near = nearest(key, keys_of(other, kind));
    if (!near.empty()) return {"unknown key", "did you mean " + std::string(near) + " " + where(other) + "?"};
  }
  return {"unknown key", "allowed " + where(table) + ": " + listed(candidates)};
}

void check_keys(const Table& entries, std::string_view table, std::optional<mpm::SceneKind> kind,
                Mistakes& mistakes) {
  auto known = keys_of(table, kind);
  if (table.empty()) {
    const auto tables = table_names();
    known.insert(known.end(), tables.begin(), tables.end());
    if (kind && mpm::kind_of(*kind).is_composed)
      known.insert(known.end(), composition_tables.begin(), composition_tables.end());
  }
  for (const Entry& entry : entries.entries) {
    if (std::find(known.begin(), known.end(), entry.key) != known.end()) continue;
    const Refusal refusal = unknown_key(entry.key, table, kind);
    if (entry.value.table())
      mistakes.add(entry.place, entry.key, refusal);
    else
      mistakes.add(entry.place, entry.key, entry.value.written(), refusal);
  }
}

namespace {

std::string lower(std::string_view text) {
  std::string small(text);
  std::ranges::transform(small, small.begin(), [](unsigned char c) { return std::tolower(c); });
  return small;
}

}  // namespace

std::string_view nearest(std::string_view word, const std::vector<std::string_view>& candidates) {
  std::string_view best;
  std::size_t smallest = std::max<std::size_t>(1, word.size() / 3) + 1;
  for (const std::string_view candidate : candidates) {
    // IMPACT_SPEED is one mistake, not twelve.
    const std::size_t distance =
        lower(word) == lower(candidate) ? word != candidate : edit_distance(word, candidate);
    if (distance < smallest) {
      smallest = distance;
      best = candidate;
    }
  }
  return best;
}

}  // namespace mpmstudy
