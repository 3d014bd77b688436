#pragma once
/// What a study file may say and where: the parameter table of libmpm, and the few keys beside it.
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "libmpm/scene/parameters.hpp"
#include "runner/study/mistakes.hpp"

namespace mpmstudy {

inline constexpr int schema_version = 1;

/// "parameters", "material", ...: the table of a study file that a section is.
std::string_view table_name(mpm::Section);

/// Tables of a study file; "" is its top.
std::vector<std::string_view> table_names();
/// [[fit]], [[figure]], [[gauge]] and [[stop]] are arrays of tables.
bool is_array_table(std::string_view table);

/// The keys of a table. With a kind: those that this kind of scene has.
std::vector<std::string_view> keys_of(std::string_view table, std::optional<mpm::SceneKind> = {});

/// The table that a key can be written in, for keys that only one of the plain tables has; empty otherwise.
std::optional<std::string_view> table_of(std::string_view key);

/// What to say of a key that `table` does not have: the nearest one, or the table that it belongs to.
Refusal unknown_key(std::string_view key, std::string_view table, std::optional<mpm::SceneKind>);

/// Adds a mistake for every entry that `table` does not have.
void check_keys(const Table&, std::string_view table, std::optional<mpm::SceneKind>, Mistakes&);

/// The candidate with the smallest edit distance, if that is small; otherwise empty.
std::string_view nearest(std::string_view word, const std::vector<std::string_view>& candidates);

/// "a, b, c".
template <class Words>
std::string listed(const Words& words) {
  std::string text;
  for (const auto& word : words) text += (text.empty() ? "" : ", ") + std::string(word);
  return text;
}

/// For a word that is none of the allowed ones: "did you mean ...? allowed: ..."; a long list is not shown
/// where the nearest word is.
template <class Words>
Refusal unknown_word(std::string_view word, std::string_view what, const Words& words) {
  constexpr std::size_t long_list = 8;
  const std::string_view near = nearest(word, std::vector<std::string_view>(words.begin(), words.end()));
  std::string allowed = near.empty() ? "" : "did you mean \"" + std::string(near) + "\"?";
  if (near.empty() || words.size() < long_list)
    allowed += (near.empty() ? "" : " ") + ("allowed: " + listed(words));
  return {"no such " + std::string(what), allowed};
}

/// Which of the words a value is. Empty after adding a mistake under `key`.
template <class Words>
std::optional<std::size_t> find_word(std::string_view key, const Value& value, std::string_view what,
                                     const Words& words, Mistakes& mistakes) {
  const std::string* word = value.string();
  for (std::size_t k = 0; word && k < words.size(); ++k)
    if (words[k] == *word) return k;
  mistakes.add(key, value, unknown_word(word ? *word : "", what, words));
  return std::nullopt;
}

}  // namespace mpmstudy
