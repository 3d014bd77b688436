#pragma once
#include <array>
#include <cstddef>
#include <string_view>

namespace mpm {

/// Whether a value of an enum has a name. By the text that the compiler makes of a template argument:
/// "E::name", or "(E)4" for a value without one (GCC and Clang).
template <class E, E value>
constexpr bool has_name() {
  const std::string_view text = __PRETTY_FUNCTION__;
  const std::size_t at = text.find("value = ");
  return at != std::string_view::npos && text[at + 8] != '(';
}

/// How many values an enum has that counts from 0 without gaps.
template <class E, std::size_t first = 0>
constexpr std::size_t enumerators() {
  if constexpr (has_name<E, static_cast<E>(first)>())
    return enumerators<E, first + 1>();
  else
    return first;
}

/// An enumerator and its word.
template <class E>
struct Word {
  E value;
  std::string_view word;
};
/// The words of an enum, checked: each enumerator has one, in the order of the enum.
template <class E, std::size_t count>
constexpr std::array<std::string_view, count> words(const Word<E> (&list)[count]) {
  static_assert(count == enumerators<E>(), "each enumerator has one word");
  std::array<std::string_view, count> names;
  for (std::size_t i = 0; i < count; ++i) {
    if (list[i].value != static_cast<E>(i)) throw "words must be in the order of their enum";
    names[i] = list[i].word;
  }
  return names;
}

}  // namespace mpm
