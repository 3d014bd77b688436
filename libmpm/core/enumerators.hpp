#pragma once
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

}  // namespace mpm
