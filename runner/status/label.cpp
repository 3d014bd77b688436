#include "runner/status/label.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "runner/study/characters.hpp"
#include "runner/study/parameter_value.hpp"

namespace mpmstudy {
std::string label_of(const mpm::Scene& scene, std::span<const std::string> swept) {
  std::string text;
  for (const auto& name : swept) {
    const std::string value = readable_parameter(scene, name);
    if (value.empty()) continue;
    text += (text.empty() ? "" : ", ") + name + " = " + value;
  }
  return text;
}

std::string short_key(const std::string& key) { return key.substr(0, shown_key_digits); }

std::string text_start(std::string_view text, std::size_t columns) {
  std::size_t end = 0;
  for (std::size_t seen = 0; end < text.size(); ++end)
    if ((text[end] & 0xC0) != 0x80 && ++seen > columns) break;
  return std::string(text.substr(0, end));
}

std::string cut_text(std::string_view text, std::size_t columns) {
  constexpr std::string_view dots = "...";
  if (characters_in(text) <= columns) return std::string(text);
  if (columns <= dots.size()) return text_start(dots, columns);
  return text_start(text, columns - dots.size()) + std::string(dots);
}

std::string first_line(std::string_view text) { return std::string(text.substr(0, text.find('\n'))); }

std::string counted(std::int64_t number, const std::string& noun) {
  return fmt::format("{} {}{}", number, noun, number == 1 ? "" : "s");
}

std::string readable_duration(double seconds) {
  if (!(seconds >= 0)) return "?";
  if (seconds > 1e12) return fmt::format("{:.1g} h", seconds / 3600);
  if (seconds < 9.95) return fmt::format("{:.1f} s", seconds);
  const auto whole = static_cast<long long>(std::llround(seconds));
  if (whole < 60) return fmt::format("{} s", whole);
  if (whole < 3600) return fmt::format("{} min {:02} s", whole / 60, whole % 60);
  return fmt::format("{} h {:02} min", whole / 3600, whole % 3600 / 60);
}

std::string readable_prediction(double seconds, double factor) {
  const std::string text = readable_duration(seconds);
  if (factor <= 1) return text;
  return fmt::format("{} ({} to {})", text, readable_duration(seconds / factor),
                     readable_duration(seconds * factor));
}

std::string readable_rate(double updates_per_second) {
  return fmt::format("{:.2f} M/s", updates_per_second * 1e-6);
}

}  // namespace mpmstudy
