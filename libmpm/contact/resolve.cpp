#include "libmpm/contact/resolve.hpp"

#include <algorithm>
#include <cmath>

#include "libmpm/boundary/grid_nodes.hpp"
#include "libmpm/contact/coulomb.hpp"
#include "libmpm/contact/frictionless.hpp"

namespace mpm {
namespace {

/// A field of less of the mass of a pair than this is left alone: its velocity is a quotient of roundings.
constexpr double least_share = 1e-5;
/// How much the mean over a node and its neighbours prefers those on the face, where each body fills half of
/// what a node sees, see resolve.hpp. With less, the sides of a corner that meets a plane are felt as faces:
/// tests/libmpm/contact_test.cpp has a block that slides.
constexpr double preference = 4;
/// Where more than two bodies meet.
constexpr int most_sweeps = 30;
constexpr double small_change = 1e-10;  // of an impulse, over what it is [1]

template <int axes>
Vec<axes> tangential(const ContactRule& rule, const Vec<axes>& holding, double normal) {
  if (rule.law == ContactLaw::coulomb) return Coulomb{rule.friction}.tangential<axes>(holding, normal);
  return Frictionless{}.tangential<axes>(holding, normal);
}

template <int axes>
BasicContactImpulse<axes>& of_pair(std::vector<BasicContactImpulse<axes>>& all, int first, int second) {
  for (BasicContactImpulse<axes>& one : all)
    if (one.first == first && one.second == second) return one;
  return all.emplace_back(BasicContactImpulse<axes>{first, second});
}

}  // namespace

template <int axes>
template <class Use>
void ContactResolver<axes>::around(const Place& middle, Use use) {
  const auto visit = [&](const Place& at, double weight) {
    if (const SharedNode<axes>* shared = fields_.shared_at(at)) use(*shared, weight);
  };
  constexpr double of[] = {0.5, 1, 0.5};
  for (int j = -1; j <= 1; ++j)
    for (int i = -1; i <= 1; ++i)
      if constexpr (axes == 2)
        visit({middle[0] + i, middle[1] + j}, of[i + 1] * of[j + 1]);
      else
        for (int k = -1; k <= 1; ++k)
          visit({middle[0] + i, middle[1] + j, middle[2] + k}, of[i + 1] * of[j + 1] * of[k + 1]);
}

/// The masses that particles gave to a node and its images, where the contact at the node counts for all.
template <int axes>
void ContactResolver<axes>::count_own() {
  for (const SharedNode<axes>& at : fields_.shared()) {
    const auto folded = fields_.folded(fields_.place(at));
    const SharedNode<axes>* to = folded.is_image ? fields_.shared_at(folded.place) : &at;
    if (!to) continue;
    for (std::uint32_t k = 0; k < at.count; ++k) {
      const double own = fields_.fields_of(at)[k].node.own_mass;
      FieldNode<axes>& f = fields_.fields_of(*to)[k];
      f.own += own;
      f.own_along += own * folded.signs;
    }
  }
}

/// What the node and its neighbours know of the face between two fields.
template <int axes>
void ContactResolver<axes>::find_pair(const SharedNode<axes>& node, const Place& place, FieldNode<axes>& a,
                                      FieldNode<axes>& b) {
  const double share_of_a = a.node.mass / (a.node.mass + b.node.mass);
  if (!(share_of_a > least_share && share_of_a < 1 - least_share)) return;
  const auto each = [&](auto use) {
    around(place, [&](const SharedNode<axes>& at, double weight) {
      const FieldNode<axes>*here_a = fields_.field_at(at, a.field), *here_b = fields_.field_at(at, b.field);
      if (!here_a || !here_b || !(here_a->size > 0) || !(here_b->size > 0)) return;
      use(*here_a, *here_b, weight * std::pow(share(*here_a) * share(*here_b), preference));
    });
  };
  const Contacts& contacts = fields_.contacts();
  const bool rigid = fields_.is_image(b.field);
  Vec<axes> n = Vec<axes>::Zero(), rigid_velocity = Vec<axes>::Zero();
  int other = b.field;
  if (rigid) {
    const std::size_t body = fields_.body_of(b.field);
    const Vec3 x = in_space<axes>(fields_.grid().position(fields_.grid().nodes()[node.node]));
    const RigidBody::Nearest nearest = contacts.rigid_bodies()[body].nearest(x, time_);
    n = -nearest.outwards.template head<axes>();
    rigid_velocity = contacts.rigid_bodies()[body]
                         .velocity(x - nearest.distance * nearest.outwards, time_)
                         .template head<axes>();
    other = contacts.rigid_field(body);
  } else {
    each([&](const FieldNode<axes>& here_a, const FieldNode<axes>& here_b, double weight) {
      n += weight * (here_a.gradient - here_b.gradient);
    });
    const double size = n.norm();
    if (!(size > 0)) return;
    n /= size;
  }
  double gap = 0, weights = 0;
  each([&](const FieldNode<axes>& here_a, const FieldNode<axes>& here_b, double weight) {
    gap -= weight * (surface(here_b, -n) + surface(here_a, n));
    weights += weight;
  });
  if (!(weights > 0)) return;
  touches_.push_back({&a, &b, other, rigid, n, rigid_velocity, std::max(gap / weights, 0.0) / dt_,
                      &contacts.rule(a.field, other)});
}

template <int axes>
void ContactResolver<axes>::find_touches(const SharedNode<axes>& at, const Place& place) {
  touches_.clear();
  FieldNode<axes>* fields = fields_.fields_of(at);
  for (std::uint32_t a = 0; a < at.count; ++a) {
    if (!(fields[a].node.mass > 0) || fields_.is_image(fields[a].field)) continue;
    for (std::uint32_t b = a + 1; b < at.count; ++b) {
      const int other = fields[b].field;
      const bool meet = !fields_.is_image(other) || fields_.original_of(other) == fields[a].field;
      if (meet && fields[b].node.mass > 0) find_pair(at, place, fields[a], fields[b]);
    }
  }
}

template <int axes>
double ContactResolver<axes>::solve(Touch& t) const {
  const double mass_a = t.a->node.mass;
  const double mass = mass_a * t.b->node.mass / (mass_a + t.b->node.mass);
  const auto give = [&](const Vec<axes>& impulse) {
    t.a->node.velocity -= impulse / mass_a;
    t.b->node.velocity += impulse / t.b->node.mass;
  };
  const auto relative = [&] { return Vec<axes>(t.a->node.velocity - t.b->node.velocity); };
  const double push = std::max(0.0, t.push + mass * (relative().dot(t.normal) - t.allowed));
  const double change = push - t.push;
  give(change * t.normal);
  t.push = push;
  const Vec<axes> slip = relative();
  const Vec<axes> holding = t.drag + mass * (slip - slip.dot(t.normal) * t.normal);
  const Vec<axes> drag = tangential<axes>(*t.rule, holding, push);
  const double turned = (drag - t.drag).norm();
  give(drag - t.drag);
  t.drag = drag;
  const double size = push + drag.norm();
  return size > 0 ? (std::abs(change) + turned) / size : 0;
}

template <int axes>
void ContactResolver<axes>::report_touches(SharedNode<axes>& at, BasicStepReport<axes>& report) {
  at.rigid_work = 0;
  for (const Touch& t : touches_) {
    if (t.push == 0) continue;
    const Vec<axes> on_a = -(t.push * t.normal + t.drag);
    const double part = t.a->own / t.a->node.mass;
    const Vec<axes> counted = on_a.cwiseProduct(t.a->own_along) / t.a->node.mass;
    // velocities in the middle of the step, as the work is
    const auto middle = [&](const FieldNode<axes>& f) {
      return Vec<axes>(f.node.velocity - 0.5 * dt_ * f.node.acceleration);
    };
    const Vec<axes> of_b = t.rigid ? t.rigid_velocity : middle(*t.b);
    report.friction_heat += part * t.drag.dot(middle(*t.a) - of_b);
    if (t.rigid) {
      at.rigid_work += on_a.dot(t.rigid_velocity);
      report.rigid_work += part * on_a.dot(t.rigid_velocity);
      report.rigid_impulse += counted;
    }
    const bool in_order = t.a->field < t.field;
    auto& pair = of_pair(report.contacts, in_order ? t.a->field : t.field, in_order ? t.field : t.a->field);
    pair.on_first += in_order ? counted : Vec<axes>(-counted);
  }
}

template <int axes>
void ContactResolver<axes>::copy_to_images() {
  for (SharedNode<axes>& at : fields_.shared()) {
    const auto folded = fields_.folded(fields_.place(at));
    const SharedNode<axes>* from = folded.is_image ? fields_.shared_at(folded.place) : nullptr;
    if (!from) continue;
    at.rigid_work = from->rigid_work;
    for (std::uint32_t k = 0; k < at.count; ++k) {
      const FieldNode<axes>& f = fields_.fields_of(*from)[k];
      FieldNode<axes>& image = fields_.fields_of(at)[k];
      image.node.velocity = f.node.velocity.cwiseProduct(folded.signs);
      image.node.acceleration = f.node.acceleration.cwiseProduct(folded.signs);
      image.before = f.before.cwiseProduct(folded.signs);
    }
  }
}

template <int axes>
void ContactResolver<axes>::push(BasicStepReport<axes>& report) {
  if (fields_.shared().empty()) return;
  count_own();
  for (SharedNode<axes>& at : fields_.shared()) {
    for (std::uint32_t k = 0; k < at.count; ++k) {
      FieldNode<axes>& f = fields_.fields_of(at)[k];
      f.before = f.node.velocity;
    }
    const Place place = fields_.place(at);
    if (fields_.folded(place).is_image) continue;
    find_touches(at, place);
    for (int sweep = 0; sweep < most_sweeps; ++sweep) {
      double change = 0;
      for (Touch& t : touches_) change = std::max(change, solve(t));
      if (touches_.size() < 2 || change < small_change) break;
    }
    for (std::uint32_t k = 0; k < at.count; ++k) {
      FieldNode<axes>& f = fields_.fields_of(at)[k];
      f.node.acceleration += (f.node.velocity - f.before) / dt_;
    }
    report_touches(at, report);
  }
  copy_to_images();
}

namespace {

/// The nodes of one field, for walls.hpp. Those that are not shared are another's business.
template <int axes>
struct NodesOfField {
  FieldNodes<axes>& all;
  int field, slice;
  mutable BasicNode<axes> nothing{};

  auto at(int i, int j) const {
    typename FieldNodes<axes>::Place place{};
    place[0] = i, place[1] = j;
    if constexpr (axes == 3) place[2] = slice;
    const SharedNode<axes>* there = all.shared_at(place);
    FieldNode<axes>* f = there ? all.field_at(*there, field) : nullptr;
    if (f) return wall_node(f->node);
    nothing = {};
    return wall_node(nothing);
  }
  void leave_heat(int, int, double) const {}  // settle() counts all of it
};

}  // namespace

template <int axes>
void FieldNodes<axes>::push_off_wall(double dt) {
  for (const SharedNode<axes>& at : shared_) {
    const Place p = place(at);
    if (p[1] != 0) continue;
    for (std::uint32_t k = 0; k < at.count; ++k)
      walls::push_off_wall(NodesOfField<axes>{*this, fields_[at.first + k].field, p[axes - 1]}, p[0], p[0],
                           grid_->ghosts, dt);
  }
}

template <int axes>
void ContactResolver<axes>::settle(BasicStepReport<axes>& report) {
  for (const SharedNode<axes>& at : fields_.shared()) {
    double heat = at.rigid_work, mass = 0, own = 0;
    Vec<axes> momentum = Vec<axes>::Zero();
    FieldNode<axes>* fields = fields_.fields_of(at);
    for (std::uint32_t k = 0; k < at.count; ++k) {
      const BasicNode<axes>& n = fields[k].node;
      if (n.mass == 0 || fields_.is_image(fields[k].field)) continue;
      heat -= n.mass * (n.velocity - fields[k].before).dot(n.velocity - 0.5 * dt_ * n.acceleration);
      mass += n.mass, own += n.own_mass;
      momentum += n.mass * n.velocity;
    }
    if (mass == 0) continue;
    for (std::uint32_t k = 0; k < at.count; ++k) fields[k].node.contact_heat = heat / mass;
    report.contact_heat += own * heat / mass;
    BasicNode<axes>& mean = fields_.grid().nodes()[at.node];
    mean.mass = mass, mean.own_mass = own;
    mean.velocity = momentum / mass;
  }
}

template class ContactResolver<2>;
template class ContactResolver<3>;
template void FieldNodes<2>::push_off_wall(double);
template void FieldNodes<3>::push_off_wall(double);

}  // namespace mpm
