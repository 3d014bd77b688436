#pragma once
#include <algorithm>
#include <string>
#include <string_view>

#include "runner/study/schema.hpp"

namespace mpmstudy {

/// Adds a mistake for each key of a table that is none of those; whether there is none.
template <class Keys>
bool check_words(const Table& table, std::string_view what, const Keys& keys, Mistakes& mistakes) {
  bool good = true;
  for (const Entry& entry : table.entries)
    if (std::ranges::find(keys, entry.key) == std::end(keys)) {
      mistakes.add(entry.place, std::string(what) + "." + entry.key, entry.value.written(),
                   unknown_word(entry.key, "key of " + std::string(what), keys));
      good = false;
    }
  return good;
}

}  // namespace mpmstudy
