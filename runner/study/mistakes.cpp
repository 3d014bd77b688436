#include "runner/study/mistakes.hpp"

#include <algorithm>
#include <utility>

#include "runner/study/characters.hpp"
#include "runner/study/study.hpp"

namespace mpmstudy {

void Mistakes::add(const Place& place, std::string_view key, std::string_view value, const Refusal& refusal) {
  std::string odd = odd_character(value);
  if (odd.empty()) odd = odd_character(key);
  keep(place, key,
       std::string(key) + " = " + std::string(value) + ": " + refusal.wrong +
           (odd.empty() ? "" : " (it " + odd + ")") + "; " + refusal.allowed);
}

void Mistakes::add(const Place& place, std::string_view key, const Refusal& refusal) {
  const std::string odd = odd_character(key);
  keep(place, key,
       std::string(key) + ": " + refusal.wrong + (odd.empty() ? "" : " (it " + odd + ")") + "; " +
           refusal.allowed);
}

void Mistakes::add(const Mistakes& other) {
  for (const Line& line : other.lines_)
    if (std::ranges::find(lines_, line.text, &Line::text) == lines_.end()) lines_.push_back(line);
}

void Mistakes::keep(const Place& place, std::string_view key, std::string text) {
  text = printable(place.text() + ": " + text);
  const auto same = [&](const Line& line) { return line.text == text; };
  if (std::none_of(lines_.begin(), lines_.end(), same))
    lines_.push_back({place, std::string(key), std::move(text)});
}

void Mistakes::throw_if_any() const {
  if (lines_.empty()) return;
  std::vector<Line> sorted = lines_;
  std::stable_sort(sorted.begin(), sorted.end(), [](const Line& a, const Line& b) {
    return std::pair(a.place.line, a.place.column) < std::pair(b.place.line, b.place.column);
  });
  std::string text;
  for (const Line& line : sorted) text += (text.empty() ? "" : "\n") + line.text;
  throw StudyError(text);
}

}  // namespace mpmstudy
