#include "libmpm/scene/report.hpp"

#include <charconv>
#include <utility>

#include "libmpm/scene/parameters.hpp"

namespace mpm {

std::string text_of(double value) {
  char text[32];
  const auto end = std::to_chars(text, text + sizeof text, value).ptr;
  return {text, end};
}

void Report::add(std::string_view name, std::string allowed) {
  const Quantity* q = find_quantity(name);
  std::string value = text_of(q->get(scene_));
  if (q->unit != "1") value.append(" ").append(q->unit);
  problems_.push_back({std::string(name), std::move(value), std::move(allowed)});
}

void Report::add_choice(std::string_view name, std::string allowed) {
  const Choice* c = find_choice(name);
  problems_.push_back({std::string(name), std::string(c->allowed[c->get(scene_)]), std::move(allowed)});
}

void Report::add_other(std::string what, std::string value, std::string allowed) {
  problems_.push_back({std::move(what), std::move(value), std::move(allowed)});
}

void Report::require(bool fine, std::string_view name, std::string allowed) {
  if (!fine) add(name, std::move(allowed));
}

}  // namespace mpm
