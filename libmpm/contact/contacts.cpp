#include "libmpm/contact/contacts.hpp"

#include <algorithm>
#include <numeric>

#include "libmpm/scene/kinds/kind.hpp"
#include "libmpm/scene/report.hpp"

namespace mpm {
namespace {

bool names(const ContactRule& rule, const std::string& one, const std::string& other) {
  return (rule.first == one && rule.second == other) || (rule.first == other && rule.second == one);
}

/// Of two bodies: the rule that names them, or that of all others.
class Rules {
 public:
  explicit Rules(const Composition& all) : all_(all) {
    for (const ContactRule& rule : all.contacts) {
      if (rule.first.empty())
        other_ = rule;
      else
        named_[{rule.first, rule.second}] = named_[{rule.second, rule.first}] = rule;
    }
  }
  const ContactRule& operator()(std::size_t a, std::size_t b) const {
    const auto found = named_.find({all_.bodies[a].name, all_.bodies[b].name});
    return found == named_.end() ? other_ : found->second;
  }
  const ContactRule& other() const { return other_; }

 private:
  const Composition& all_;
  std::map<std::pair<std::string, std::string>, ContactRule> named_;
  ContactRule other_;
};

/// Numbers of the fields that bodies are of.
std::vector<int> fields_of(const Composition& all) {
  const std::size_t n = all.bodies.size();
  if (all.contacts.empty() && std::ranges::none_of(all.bodies, &ComposedBody::rigid))
    return std::vector<int>(n, 0);
  const Rules rule(all);
  std::vector<std::size_t> root(n);
  std::iota(root.begin(), root.end(), 0u);
  const auto top = [&](std::size_t k) {
    while (root[k] != k) k = root[k];
    return k;
  };
  for (std::size_t a = 0; a < n; ++a)
    for (std::size_t b = a + 1; b < n; ++b) {
      if (all.bodies[a].rigid || all.bodies[b].rigid || rule(a, b).law != ContactLaw::welded) continue;
      const std::size_t one = top(a), other = top(b);
      root[std::max(one, other)] = std::min(one, other);
    }
  std::vector<int> numbers(n, -1);
  int next = 0;
  for (std::size_t k = 0; k < n; ++k) numbers[k] = top(k) == k ? next++ : numbers[top(k)];
  return numbers;
}

std::string pair_text(const Composition& all, std::size_t a, std::size_t b) {
  return all.bodies[a].name + " and " + all.bodies[b].name;
}

}  // namespace

Contacts::Contacts(const Scene& s) : field_of_(mpm::fields_of(s.composition)) {
  const Composition& all = s.composition;
  const Rules rule(all);
  other_ = rule.other();
  for (const int field : field_of_) fields_ = std::max(fields_, static_cast<std::size_t>(field) + 1);
  for (std::size_t b = 0; b < all.bodies.size(); ++b) {
    if (!all.bodies[b].rigid) continue;
    rigid_.emplace_back(all.bodies[b], axes_of(s.space));
    rigid_field_.push_back(field_of_[b]);
  }
  for (const ContactRule& one : all.contacts)
    for (std::size_t a = 0; a < all.bodies.size(); ++a)
      for (std::size_t b = 0; b < a; ++b)
        if (names(one, all.bodies[a].name, all.bodies[b].name)) {
          const auto [low, high] = std::minmax(field_of_[a], field_of_[b]);
          of_pairs_[{low, high}] = one;
        }
}

const ContactRule& Contacts::rule(int first, int second) const {
  if (of_pairs_.empty()) return other_;
  const auto found = of_pairs_.find(std::minmax(first, second));
  return found == of_pairs_.end() ? other_ : found->second;
}

bool has_contact(const Scene& s) {
  const auto& bodies = s.composition.bodies;
  return std::ranges::any_of(bodies, &ComposedBody::rigid) ||
         std::ranges::any_of(s.composition.contacts,
                             [](const ContactRule& rule) { return rule.law != ContactLaw::welded; });
}

namespace {

void check_rules(const Composition& all, Report& report) {
  const auto known = [&](const std::string& name) { return all.index_of(name) < all.bodies.size(); };
  for (std::size_t k = 0; k < all.contacts.size(); ++k) {
    const ContactRule& rule = all.contacts[k];
    const std::string what = "contact " + std::to_string(k + 1);
    for (const std::string& name : {rule.first, rule.second})
      if (!rule.first.empty() && !known(name)) report.add_other(what + ", between", name, "names of bodies");
    if (!rule.first.empty() && rule.first == rule.second)
      report.add_other(what + ", between", rule.first + " and itself", "two bodies");
    if (!(rule.friction >= 0)) report.add_other(what + ", friction", text_of(rule.friction), "0 or more");
    for (std::size_t other = 0; other < k; ++other)
      if (names(all.contacts[other], rule.first, rule.second))
        report.add_other(what + ", between",
                         rule.first.empty() ? "all others" : rule.first + ", " + rule.second,
                         "a pair that no other [[contact]] has");
  }
}

/// Bodies that are welded hold the same against all others, and no rule sets apart what others weld.
void check_fields(const Composition& all, Report& report) {
  const std::vector<int> fields = fields_of(all);
  const Rules rule(all);
  std::map<std::pair<int, int>, std::pair<std::size_t, std::size_t>> seen;
  for (std::size_t a = 0; a < all.bodies.size(); ++a)
    for (std::size_t b = 0; b < a; ++b) {
      if (all.bodies[a].rigid && all.bodies[b].rigid) continue;
      const ContactRule& one = rule(a, b);
      if (fields[a] == fields[b]) {
        if (one.law == ContactLaw::welded) continue;
        report.add_other("contact", pair_text(all, b, a) + " are welded to the same body",
                         "a law for that body, too: pairs that no [[contact]] is about are welded");
        return;
      }
      if (one.law == ContactLaw::welded) {
        report.add_other(
            "contact", pair_text(all, b, a) + " have none",
            "a [[contact]] of that pair, or one without `between`: nothing is welded to a rigid body");
        return;
      }
      const auto [low, high] = std::minmax(fields[a], fields[b]);
      const auto [first, is_new] = seen.try_emplace({low, high}, b, a);
      if (is_new) continue;
      const ContactRule& before = rule(first->second.first, first->second.second);
      if (before.law == one.law && before.friction == one.friction) continue;
      report.add_other("contact",
                       pair_text(all, b, a) + " have another law than " +
                           pair_text(all, first->second.first, first->second.second),
                       "the same for bodies that are welded to each other");
      return;
    }
}

void check_rigid(const Composition& all, Report& report) {
  bool deforms = all.bodies.empty();
  for (const ComposedBody& b : all.bodies) {
    if (!b.rigid)
      deforms = true;
    else if (!RigidBody::has_form(b.shape.form))
      report.add_other("body " + b.name + ", shape",
                       std::string(shape_forms[static_cast<std::size_t>(b.shape.form)]),
                       "a half_space, a block, a disc or a sphere, where a body is rigid");
  }
  if (!deforms) report.add_other("body", "rigid bodies alone", "a body that is not rigid");
}

}  // namespace

void check_contacts(const Scene& s, Report& report) {
  const Composition& all = s.composition;
  check_rules(all, report);
  check_rigid(all, report);
  if (report.empty() && has_contact(s)) check_fields(all, report);
}

}  // namespace mpm
