#pragma once
/// Which bodies of a scene share a velocity field, and what holds between those that do not.
#include <cstddef>
#include <map>
#include <string>
#include <utility>
#include <vector>

#include "libmpm/contact/rigid_body.hpp"
#include "libmpm/scene/scene.hpp"

namespace mpm {

class Report;

/// Bodies that are welded to each other, one through the other too, are a field: they have one velocity at
/// every node of the grid. Each rigid body is a field of its own, without nodes. Fields are numbered in the
/// order of their first bodies, so that scenes of one field are what they were before there was contact.
class Contacts {
 public:
  /// Of a scene without problems.
  explicit Contacts(const Scene&);

  std::size_t fields() const { return fields_; }
  int field_of(std::size_t body) const { return field_of_.at(body); }
  /// Between two fields, one of them deformable.
  const ContactRule& rule(int first, int second) const;
  /// Between a field and rigid_bodies()[k] the field number is rigid_field(k).
  const std::vector<RigidBody>& rigid_bodies() const { return rigid_; }
  int rigid_field(std::size_t k) const { return rigid_field_.at(k); }

 private:
  std::size_t fields_ = 0;
  std::vector<int> field_of_;  ///< of each body
  std::vector<RigidBody> rigid_;
  std::vector<int> rigid_field_;
  ContactRule other_;  ///< of pairs that no rule names
  std::map<std::pair<int, int>, ContactRule> of_pairs_;
};

/// Whether a scene has more than one field.
bool has_contact(const Scene&);
/// What is wrong with the rules of contact.
void check_contacts(const Scene&, Report&);

}  // namespace mpm
