#include "runner/study/overrides.hpp"

#include <algorithm>
#include <optional>

#include "runner/study/schema.hpp"

namespace mpmstudy {
namespace {

/// [table] of the document, made if it is not there; the document itself for "". Null: it is no table.
Table* open_table(Table& document, std::string_view name, const Place& place) {
  if (name.empty()) return &document;
  Entry* entry = document.find(name);
  if (!entry) {
    document.entries.push_back({std::string(name), place, {place, Table{}}});
    entry = &document.entries.back();
  }
  return std::get_if<Table>(&entry->value.data);
}

/// Tables of which one has the key; arrays of tables are none.
std::vector<std::string_view> homes_of(std::string_view key) {
  std::vector<std::string_view> homes;
  for (const std::string_view table : table_names()) {
    const auto keys = keys_of(table);
    if (!is_array_table(table) && std::ranges::find(keys, key) != keys.end()) homes.push_back(table);
  }
  return homes;
}

/// "material.hardening_modulus" -> ("material", "hardening_modulus"); a bare key finds its table by itself:
/// of several that have it ([search] and [surface] have a tolerance) the one that is in the file.
std::pair<std::optional<std::string_view>, std::string_view> locate(const Table& document,
                                                                    std::string_view key) {
  const auto dot = key.find('.');
  const std::string_view name = dot == std::string_view::npos ? key : key.substr(dot + 1);
  const auto homes = homes_of(name);
  if (dot != std::string_view::npos) {
    const auto named = std::ranges::find(homes, key.substr(0, dot));
    if (named != homes.end()) return {*named, name};
    return {std::nullopt, key};
  }
  for (const std::string_view table : homes)
    if (document.find(table)) return {table, key};
  return {homes.empty() ? std::nullopt : std::optional(homes.front()), key};
}

/// Whether the file has a parameter of that name, be it in no table of ours.
bool is_own(const Table& document, std::string_view name) {
  const Table* parameters = document.find_table("parameters");
  return parameters && parameters->find(name);
}

/// name and title are text: what the shell left of name="2026" is no number.
Value value_of(std::string_view key, std::string_view name, std::string_view text) {
  if ((name == "name" || name == "title") && !text.starts_with('"'))
    return {{"--set", 0, 0}, std::string(text)};
  return read_value(key, text);
}

Refusal unknown(std::string_view key) {
  const std::string_view name = key.substr(key.find('.') == key.npos ? 0 : key.find('.') + 1);
  std::vector<std::string_view> all;
  for (const std::string_view table : table_names())
    for (const std::string_view known : keys_of(table)) {
      if (!is_array_table(table))
        all.push_back(known);
      else if (known == name)
        return {"is a key of [[" + std::string(table) + "]], of which a file may have several",
                "change it in the file"};
    }
  const std::string_view near = nearest(name, all);
  if (near.empty()) return {"unknown key", "allowed: " + listed(all)};
  return {"unknown key", "did you mean " + std::string(near) + "?"};
}

}  // namespace

void apply_overrides(Table& document, const std::vector<std::pair<std::string, std::string>>& set,
                     Mistakes& mistakes) {
  for (const auto& [key, text] : set) {
    auto [table_name, name] = locate(document, key);
    if (!table_name && is_own(document, key)) table_name = "parameters";
    const Value value = value_of(key, name, text);
    if (!table_name) {
      mistakes.add(value.place, key, text, unknown(key));
      continue;
    }
    Table* table = open_table(document, *table_name, value.place);
    if (!table) continue;  // said where tables are read
    if (const mpm::Quantity* row = mpm::find_quantity(name); row && !row->alternative.empty())
      std::erase_if(table->entries, [&](const Entry& entry) { return entry.key == row->alternative; });
    // A cell is given, or looked for; what the file says of the other, and of its ladder, was not meant for
    // it.
    if (name == "accuracy" || name == "cell_size")
      std::erase_if(table->entries, [&, name = name](const Entry& entry) {
        return entry.place.line > 0 &&
               (name == "accuracy" ? entry.key == "cell_size" || entry.key == "ladder"
                                   : entry.key == "accuracy" || entry.key == "accuracy_of");
      });
    if (Entry* entry = table->find(name))
      *entry = {entry->key, value.place, value};
    else
      table->entries.push_back({std::string(name), value.place, value});
  }
}

}  // namespace mpmstudy
