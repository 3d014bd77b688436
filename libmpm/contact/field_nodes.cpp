#include "libmpm/contact/field_nodes.hpp"

#include <algorithm>
#include <limits>

#include "libmpm/boundary/grid_nodes.hpp"

namespace mpm {
namespace {

/// An axis-parallel box.
template <int axes>
struct Box {
  Vec<axes> low = Vec<axes>::Constant(std::numeric_limits<double>::infinity()), high = -low;

  void add(const Vec<axes>& x) { low = low.cwiseMin(x), high = high.cwiseMax(x); }
  void add(const Box& b) { low = low.cwiseMin(b.low), high = high.cwiseMax(b.high); }
  Box grown(const Vec<axes>& by) const { return {low - by, high + by}; }
  bool meets(const Box& b) const {
    return (low.array() <= b.high.array()).all() && (b.low.array() <= high.array()).all();
  }
  bool holds(const Vec<axes>& x) const {
    return (low.array() <= x.array()).all() && (x.array() <= high.array()).all();
  }
};

}  // namespace

template <int axes>
std::size_t FieldNodes<axes>::index_of(const Place& at) const {
  const int ghosts = grid_->ghosts;
  const auto between = [&](int k, int last) { return k >= -ghosts && k <= last + ghosts; };
  const std::size_t nowhere = grid_->nodes().size();
  if (!between(at[0], grid_->columns()) || at[1] < -ghosts || at[1] > grid_->rows() - 2) return nowhere;
  if constexpr (axes == 2)
    return grid_->index(at[0], at[1]);
  else
    return between(at[2], grid_->slices()) ? grid_->index(at[0], at[1], at[2]) : nowhere;
}

template <int axes>
void FieldNodes<axes>::begin(const BasicState<axes>& s) {
  grid_ = const_cast<BasicGrid<axes>*>(&s.grid);
  const auto& ps = s.particles;
  if (field_of_.size() != ps.size()) {
    field_of_.resize(ps.size());
    for (std::size_t p = 0; p < ps.size(); ++p)
      field_of_[p] = static_cast<std::int32_t>(contacts_.field_of(ps.body_of(p)));
  }
  owner_.assign(s.grid.nodes().size(), none);
  shared_.clear(), links_.clear(), head_.clear(), fields_.clear();
  mirrors_ = {{0, 0, s.grid.ghosts, 1, true}, {0, s.grid.columns(), s.grid.ghosts, -1, false}};
  if constexpr (axes == 3) {
    mirrors_.push_back({2, 0, s.grid.ghosts, 1, true});
    mirrors_.push_back({2, s.grid.slices(), s.grid.ghosts, -1, false});
  }
  if (s.floor == Floor::mirror) mirrors_.push_back({1, 0, s.grid.ghosts, 1, true});
  if (s.ceiling) mirrors_.push_back({1, *s.ceiling, static_cast<int>(reach), 1, false});
  find_active(s);
  find_images(s);
}

/// Two fields share a node only where the box of the one, grown by what shape functions reach, meets that of
/// the other: only particles there are looked at. The thousand bodies of a heap have few neighbours each.
template <int axes>
void FieldNodes<axes>::find_active(const BasicState<axes>& s) {
  const auto& ps = s.particles;
  const Vec<axes> reach_of_two = 3 * reach * s.grid.cell();  // and of a wall, between its rows
  std::vector<Box<axes>> boxes(contacts_.fields()), zones(contacts_.fields());
  for (std::size_t p = 0; p < ps.size(); ++p)
    boxes[static_cast<std::size_t>(field_of_[p])].add(ps.position[p]);
  for (std::size_t a = 0; a < boxes.size(); ++a)
    for (std::size_t b = a + 1; b < boxes.size(); ++b) {
      if (!boxes[a].grown(reach_of_two).meets(boxes[b])) continue;
      zones[a].add(boxes[b].grown(reach_of_two)), zones[b].add(boxes[a].grown(reach_of_two));
    }
  const double near = reach_of_two.norm();
  active_.clear();
  for (std::size_t p = 0; p < ps.size(); ++p) {
    const Vec<axes>& x = ps.position[p];
    const auto is_near = [&](const RigidBody& body) {
      return body.nearest(in_space<axes>(x), s.time).distance < near;
    };
    if (zones[static_cast<std::size_t>(field_of_[p])].holds(x) ||
        std::ranges::any_of(contacts_.rigid_bodies(), is_near))
      active_.push_back(p);
  }
}

template <int axes>
void FieldNodes<axes>::mark(std::size_t node, int field) {
  const std::int32_t owner = owner_[node];
  if (owner == field) return;
  if (owner == none)
    owner_[node] = field;
  else
    add(node, field);
}

/// Makes the node a shared one that has this field, too. Whether that is new.
template <int axes>
bool FieldNodes<axes>::add(std::size_t node, int field) {
  std::int32_t& owner = owner_[node];
  bool grows = false;
  if (owner >= none) {
    links_.push_back({owner, -1});
    head_.push_back(owner == none ? -1 : static_cast<int>(links_.size()) - 1);
    owner = -2 - static_cast<std::int32_t>(shared_.size());
    shared_.push_back({node, 0, 0});
    grows = true;
  }
  int& head = head_[static_cast<std::size_t>(-2 - owner)];
  for (int k = head; k >= 0; k = links_[static_cast<std::size_t>(k)].next)
    if (links_[static_cast<std::size_t>(k)].field == field) return grows;
  links_.push_back({field, head});
  head = static_cast<int>(links_.size()) - 1;
  return true;
}

template <int axes>
void FieldNodes<axes>::share(const BasicState<axes>& s) {
  share_images(s);
  make_fields();
}

/// Those of particles whose image reaches a node that the particle's field reaches, too.
template <int axes>
void FieldNodes<axes>::find_images(const BasicState<axes>& s) {
  images_.clear();
  image_places_.position.clear(), image_places_.half_size.clear(), image_places_.domain.clear();
  const auto& ps = s.particles;
  const double near = reach * s.grid.cell().norm();
  const double top = s.grid.origin().y() + (s.grid.rows() - 2 - reach) * s.grid.cell().y();
  for (std::size_t body = 0; body < contacts_.rigid_bodies().size(); ++body) {
    const RigidBody& rigid = contacts_.rigid_bodies()[body];
    for (const std::size_t p : active_) {
      const Vec3 x = in_space<axes>(ps.position[p]);
      const RigidBody::Nearest nearest = rigid.nearest(x, s.time);
      if (std::abs(nearest.distance) > near) continue;
      const Vec3 on_surface = x - nearest.distance * nearest.outwards;
      const Vec<axes> image = (on_surface - nearest.distance * nearest.outwards).template head<axes>();
      if (!s.grid.holds(image) || image.y() > top) continue;  // no node there that a particle reaches
      if (s.space == Space::axisymmetric && !(image.x() > 0)) continue;
      const Vec<axes> n = nearest.outwards.template head<axes>();
      images_.push_back(
          {p, image_field(field_of_[p], body), n, rigid.velocity(on_surface, s.time).template head<axes>()});
      image_places_.position.push_back(image);
      image_places_.half_size.push_back(ps.half_size[p]);
      if (!ps.domain.empty())
        image_places_.domain.push_back(ps.domain[p] - 2 * n * (n.transpose() * ps.domain[p]));
    }
  }
}

/// Nodes that mirrors or the wall below treat together: calls use(place) for each but the place itself.
template <int axes>
template <class Use>
void FieldNodes<axes>::each_image(const BasicState<axes>& s, const Place& at, Use use) const {
  for (const Mirror& m : mirrors_) {
    const auto axis = static_cast<std::size_t>(m.axis);
    const int off = at[axis] - m.at;
    if (off == 0 || std::abs(off) > m.layers) continue;
    Place image = at;
    image[axis] = m.at - off;
    use(image);
  }
  if (s.floor == Floor::impact_wall && std::abs(at[1]) <= s.grid.ghosts)
    for (int j = -s.grid.ghosts; j <= s.grid.ghosts; ++j) {
      Place image = at;
      image[1] = j;
      if (j != at[1]) use(image);
    }
}

template <int axes>
void FieldNodes<axes>::share_images(const BasicState<axes>& s) {
  grown_.clear();
  for (std::size_t k = 0; k < shared_.size(); ++k) grown_.push_back(static_cast<int>(k));
  while (!grown_.empty()) {
    const auto at = static_cast<std::size_t>(grown_.back());
    grown_.pop_back();
    each_image(s, grid_->place(shared_[at].node), [&](const Place& image) {
      const std::size_t node = index_of(image);
      if (node == owner_.size()) return;
      bool grows = false;
      for (int k = head_[at]; k >= 0; k = links_[static_cast<std::size_t>(k)].next)
        if (add(node, links_[static_cast<std::size_t>(k)].field)) grows = true;
      if (grows) grown_.push_back(-2 - owner_[node]);
    });
  }
}

template <int axes>
void FieldNodes<axes>::make_fields() {
  std::vector<int> there;
  for (std::size_t k = 0; k < shared_.size(); ++k) {
    there.clear();
    for (int l = head_[k]; l >= 0; l = links_[static_cast<std::size_t>(l)].next)
      there.push_back(links_[static_cast<std::size_t>(l)].field);
    std::ranges::sort(there);
    shared_[k].first = static_cast<std::uint32_t>(fields_.size());
    shared_[k].count = static_cast<std::uint32_t>(there.size());
    for (const int field : there) fields_.emplace_back().field = field;
  }
}

template <int axes>
FieldNode<axes>* FieldNodes<axes>::field_at(const SharedNode<axes>& at, int field) {
  FieldNode<axes>* f = fields_of(at);
  for (std::uint32_t k = 0; k < at.count; ++k, ++f)
    if (f->field == field) return f;
  return nullptr;
}

template <int axes>
SharedNode<axes>* FieldNodes<axes>::shared_at(const Place& at) {
  const std::size_t node = index_of(at);
  if (node == owner_.size() || owner_[node] >= none) return nullptr;
  return &shared_[static_cast<std::size_t>(-2 - owner_[node])];
}

template <int axes>
void FieldNodes<axes>::reflect() {
  const auto each = [&](const SharedNode<axes>& at, auto use) {
    FieldNode<axes>* f = fields_of(at);
    for (std::uint32_t k = 0; k < at.count; ++k, ++f) use(*f, k);
  };
  const auto mass_of = [](FieldNode<axes>& f) { return wall_node(f.node); };
  const auto look_of = [](FieldNode<axes>& f) { return wall_node<axes>(f.size, f.gradient, f.moment); };
  for (const Mirror& m : mirrors_)
    for (const SharedNode<axes>& at : shared_) {
      Place there = place(at);
      int& k = there[static_cast<std::size_t>(m.axis)];
      const int off = (k - m.at) * m.inwards;
      if (off < 0 || off > m.layers) continue;
      if (off == 0) {
        each(at, [&](FieldNode<axes>& f, std::uint32_t) {
          walls::stop(mass_of(f), m.axis), walls::stop(look_of(f), m.axis);
        });
        continue;
      }
      k = 2 * m.at - k;
      const SharedNode<axes>* behind = shared_at(there);
      if (!behind) continue;
      FieldNode<axes>* images = fields_of(*behind);
      each(at, [&](FieldNode<axes>& f, std::uint32_t n) {
        walls::join(mass_of(f), mass_of(images[n]), m.axis),
            walls::join(look_of(f), look_of(images[n]), m.axis);
      });
    }
}

template <int axes>
auto FieldNodes<axes>::folded(const Place& at) const -> Folded {
  Folded f{at, Vec<axes>::Ones(), false};
  for (const Mirror& m : mirrors_) {
    int& k = f.place[static_cast<std::size_t>(m.axis)];
    if (m.keeps_low ? k >= m.at : k <= m.at) continue;
    k = 2 * m.at - k;
    f.signs[m.axis] *= -1;
    f.is_image = true;
  }
  return f;
}

template <int axes>
bool FieldNodes<axes>::at_open_face(const BasicState<axes>& s, int top_row) const {
  for (const SharedNode<axes>& at : shared_) {
    const Place p = place(at);
    if (p[1] < 0 || p[1] > top_row) continue;
    bool open = (s.open.left && p[0] == 0) || (s.open.right && p[0] == s.grid.columns()) ||
                (s.floor == Floor::open && p[1] == 0);
    if constexpr (axes == 3)
      open = open || (s.open.front && p[2] == 0) || (s.open.back && p[2] == s.grid.slices());
    for (std::uint32_t k = 0; open && k < at.count; ++k)
      if (fields_[at.first + k].node.mass > 0) return true;
  }
  return false;
}

template class FieldNodes<2>;
template class FieldNodes<3>;

}  // namespace mpm
