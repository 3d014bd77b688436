#pragma once
#include <algorithm>
#include <string>
#include <string_view>

#include "runner/study/requests.hpp"
#include "runner/study/schema.hpp"

namespace mpmstudy {

/// One word out of a list, required.
template <class Words>
std::string read_word(const Entry& parent, const Table& table, std::string_view key, std::string_view what,
                      const Words& words, Mistakes& mistakes) {
  const auto text = required_string(table, parent.place, key, what, mistakes);
  if (!text) return {};
  if (std::find(words.begin(), words.end(), *text) == words.end())
    mistakes.add(key, table.find(key)->value, unknown_word(*text, what, words));
  return *text;
}

}  // namespace mpmstudy
