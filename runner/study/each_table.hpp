#pragma once
#include <algorithm>
#include <string>
#include <string_view>

#include "runner/study/mistakes.hpp"
#include "runner/study/schema.hpp"

namespace mpmstudy {

/// Calls read(entry, table) for every [[name]], whose keys are checked.
template <class Read>
void for_each_table(const Table& document, std::string_view name, Mistakes& mistakes, Read read) {
  const Entry* entry = document.find(name);
  if (!entry) return;
  const List* list = entry->value.list();
  const bool tables =
      list && std::all_of(list->begin(), list->end(), [](const Value& v) { return v.table() != nullptr; });
  if (!tables) {
    std::string instead = "write [[" + std::string(name) + "]]";
    if (const auto home = table_of(name)) instead += ", or move it into [" + std::string(*home) + "]";
    mistakes.add(entry->place, name, {"not an array of tables", instead});
    return;
  }
  for (const Value& value : *list) {
    const Entry one{entry->key, value.place, value};
    check_keys(*value.table(), name, std::nullopt, mistakes);
    read(one, *value.table());
  }
}

}  // namespace mpmstudy
