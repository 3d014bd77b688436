#include "runner/study/contact_rules.hpp"

#include <array>

#include "runner/study/check_words.hpp"

namespace mpmstudy {
namespace {

constexpr std::array<std::string_view, 3> contact_keys = {"between", "law", "friction"};

/// Empty after adding mistakes.
std::optional<mpm::ContactRule> read_contact(const Value& one, const std::vector<std::string>& bodies,
                                             QuantityReader& quantities, const ValueOf& value,
                                             Mistakes& mistakes) {
  const Table* table = one.table();
  if (!table || !check_words(*table, contact_table, contact_keys, mistakes)) return std::nullopt;
  mpm::ContactRule rule;
  if (const Entry* between = table->find("between")) {
    const std::vector<std::string> pair = read_pair("contact.between", between->value, mistakes);
    if (pair.empty()) return std::nullopt;
    for (const std::string& name : pair)
      if (std::ranges::find(bodies, name) == bodies.end()) {
        mistakes.add("contact.between", between->value, unknown_word(name, "body", bodies));
        return std::nullopt;
      }
    rule.first = pair[0], rule.second = pair[1];
  }
  const Entry* law = table->find("law");
  if (!law) {
    mistakes.add(one.place, "contact.law", {"missing", "allowed: " + listed(mpm::contact_laws)});
    return std::nullopt;
  }
  const auto word = find_word("contact.law", law->value, "law of contact", mpm::contact_laws, mistakes);
  if (!word) return std::nullopt;
  rule.law = static_cast<mpm::ContactLaw>(*word);
  const Entry* friction = table->find("friction");
  if ((rule.law == mpm::ContactLaw::coulomb) != (friction != nullptr)) {
    mistakes.add(friction ? friction->value.place : one.place, "contact.friction",
                 friction ? Refusal{"only law = \"coulomb\" has one", "remove it"}
                          : Refusal{"missing", "law = \"coulomb\" needs friction, a number such as 0.3"});
    return std::nullopt;
  }
  if (friction) {
    const auto si = quantities.read("contact.friction", friction->value,
                                    {"1", mpm::Range::non_negative_or_infinite}, value, mistakes);
    if (!si) return std::nullopt;
    rule.friction = *si;
  }
  return rule;
}

}  // namespace

std::vector<std::string> read_pair(std::string_view key, const Value& value, Mistakes& mistakes) {
  const List* list = value.list();
  std::vector<std::string> names;
  for (std::size_t k = 0; list && k < list->size(); ++k)
    if (const std::string* name = (*list)[k].string()) names.push_back(*name);
  if (list && list->size() == 2 && names.size() == 2) return names;
  mistakes.add(key, value, {"not a pair of bodies", "allowed: two names, such as [\"ball\", \"plate\"]"});
  return {};
}

std::vector<mpm::ContactRule> read_contacts(const Table& document, const std::vector<std::string>& bodies,
                                            QuantityReader& quantities, const ValueOf& value,
                                            Mistakes& mistakes) {
  std::vector<mpm::ContactRule> rules;
  const Entry* entry = document.find(contact_table);
  if (!entry) return rules;
  const List* list = entry->value.list();
  if (!list) {
    mistakes.add(contact_table, entry->value, {"not an array of tables", "write [[contact]]"});
    return rules;
  }
  for (const Value& one : *list)
    if (auto rule = read_contact(one, bodies, quantities, value, mistakes)) rules.push_back(std::move(*rule));
  return rules;
}

}  // namespace mpmstudy
