#include "runner/study/requirement.hpp"

#include <algorithm>

namespace mpmstudy {
namespace {

List texts_of(const Table* sweep) {
  const Entry* entry = sweep ? sweep->find("require") : nullptr;
  if (!entry) return {};
  return entry->value.list() ? *entry->value.list() : List{entry->value};
}

}  // namespace

std::vector<Requirement> read_requirements(const Table* sweep, const std::string& searched,
                                           const Units& units, const KnownParameters& known,
                                           Mistakes& mistakes) {
  std::vector<Requirement> requirements;
  for (const Value& value : texts_of(sweep)) {
    if (!value.string()) {
      mistakes.add("require", value,
                   {"not a comparison",
                    "allowed: text such as \"wall_thickness > cavity_radius + 0.2 um\", or a list of them"});
      continue;
    }
    auto expression = parse_expression("require", value, units, known, mistakes, Comparison::to_12_digits);
    if (!expression) continue;
    if (!expression->has(Dimension{})) {
      mistakes.add("require", value,
                   {"is a quantity in " + expression->dimension().text() + ", neither true nor false",
                    "allowed: a comparison, such as \"wall_thickness > 0.2 um\""});
    } else if (!searched.empty() &&
               std::ranges::find(expression->names(), searched) != expression->names().end()) {
      mistakes.add("require", value,
                   {searched + " is looked for by [search]", "allowed: parameters that have a value"});
    } else {
      requirements.push_back({std::move(*expression), value.place, value.written()});
    }
  }
  return requirements;
}

std::vector<std::string> names_in_requirements(const Table* sweep) {
  std::vector<std::string> names;
  for (const Value& value : texts_of(sweep))
    if (const std::string* text = value.string())
      for (std::string& name : names_in(*text)) names.push_back(std::move(name));
  return names;
}

}  // namespace mpmstudy
