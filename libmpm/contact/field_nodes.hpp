#pragma once
/// Nodes of the grid that several velocity fields share. A node that one field alone reaches stays the node
/// of the grid; at one where two or more meet, or near a rigid body, each field has a node of its own, and
/// that of the grid is empty. Memory follows the places where bodies meet, not their number.
///
/// In a step, in this order:
///   start()       which nodes are shared, from the places of the particles
///   p2g           with node(at, p): the node of the field of particle p
///   look()        how much of each field a node sees, and where (surfaces); images in rigid bodies
///   reflect()     mirrors, after those of the grid
///   contact       contact/resolve.hpp
///   g2p           with node(at, p)
#include <array>
#include <cstdint>
#include <vector>

#include "libmpm/contact/contacts.hpp"
#include "libmpm/core/grid.hpp"
#include "libmpm/step/gravity.hpp"
#include "libmpm/step/state.hpp"

namespace mpm {

/// What one field has at a shared node.
template <int axes>
struct FieldNode {
  int field = 0;
  BasicNode<axes> node;
  // What the node sees of the field, as long as its shape function reaches: sums of w A, A grad w and
  // w A (x_p - x_i), with A the area of a particle in the grid's plane (of three axes its volume).
  double size = 0;
  Vec<axes> gradient = Vec<axes>::Zero();  ///< points out of the field
  Vec<axes> moment = Vec<axes>::Zero();
  Vec<axes> before = Vec<axes>::Zero();     ///< velocity without contact [m/s]
  double own = 0;                           ///< own_mass of this node and of its images
  Vec<axes> own_along = Vec<axes>::Zero();  ///< the same, with the signs that momentum has in the images
};

template <int axes>
struct SharedNode {
  std::size_t node;            ///< of the grid
  std::uint32_t first, count;  ///< in fields()
  double rigid_work = 0;       ///< that rigid bodies do on the fields, as if there were no images [J/m]
};

template <int axes>
class FieldNodes {
 public:
  using Node = BasicNode<axes>;
  using Place = typename BasicGrid<axes>::Place;

  explicit FieldNodes(Contacts contacts) : contacts_(std::move(contacts)) {}

  const Contacts& contacts() const { return contacts_; }
  /// Number of the image of a field in rigid_bodies()[body]: beyond those of all fields.
  int image_field(int field, std::size_t body) const {
    return static_cast<int>(contacts_.fields() * (body + 1)) + field;
  }
  bool is_image(int field) const { return field >= static_cast<int>(contacts_.fields()); }
  /// The rigid body that an image is in, and the field that it is the image of.
  std::size_t body_of(int image) const { return static_cast<std::size_t>(image) / contacts_.fields() - 1; }
  int original_of(int image) const { return image % static_cast<int>(contacts_.fields()); }

  template <class Shape, class Space>
  void start(const BasicState<axes>& s) {
    begin(s);
    for_active<Shape, Space>(s, [&](std::size_t p, Node& n, auto...) { mark(index(n), field_of_[p]); });
    for (std::size_t k = 0; k < images_.size(); ++k)
      stencil_of<Shape, Space>(*grid_, image_places_, k).for_each(*grid_, [&](Node& n, auto...) {
        mark(index(n), images_[k].field);
      });
    share(s);
  }
  template <class Shape, class Transfer, class Space>
  void look(const BasicState<axes>& s) {
    if (shared_.empty()) return;
    for_active<Shape, Space>(s, [&](std::size_t p, Node& n, double w, const Vec<axes>& g) {
      if (FieldNode<axes>* at = shared_of(n, field_of_[p]))
        look_at(*at, n, w, g, filled(s, p), s.particles.position[p]);
    });
    add_images<Shape, Transfer, Space>(s);
  }
  void reflect();

  /// The node of the grid, or that of the particle's field where it is shared.
  Node& node(Node& at, std::size_t p) {
    const std::int32_t owner = owner_[index(at)];
    return owner >= none ? at : find(owner, field_of_[p])->node;
  }
  const Node& node(const Node& at, std::size_t p) const {
    return const_cast<FieldNodes*>(this)->node(const_cast<Node&>(at), p);
  }
  /// All nodes: those of the grid, and those of fields.
  template <class Use>
  void each_node(BasicGrid<axes>& grid, Use use) {
    for (Node& n : grid.nodes()) use(n);
    for (FieldNode<axes>& f : fields_) use(f.node);
  }
  /// The impact wall along row 0, for each field by itself. Their heat is counted by who counts all.
  void push_off_wall(double dt);
  /// Whether a shared node of an open side or floor has mass, see boundary/mirror.hpp.
  bool at_open_face(const BasicState<axes>&, int top_row) const;

  std::vector<SharedNode<axes>>& shared() { return shared_; }
  FieldNode<axes>* fields_of(const SharedNode<axes>& at) { return &fields_[at.first]; }
  /// Null: the field has nothing there.
  FieldNode<axes>* field_at(const SharedNode<axes>& at, int field);
  /// Null: the node is not there, or not shared.
  SharedNode<axes>* shared_at(const Place&);
  Place place(const SharedNode<axes>& at) const { return grid_->place(at.node); }
  /// Where what lies behind mirrors has its image before them, and the signs of a vector there.
  struct Folded {
    Place place;
    Vec<axes> signs;
    bool is_image;
  };
  Folded folded(const Place&) const;
  BasicGrid<axes>& grid() { return *grid_; }

 private:
  static constexpr std::int32_t none = -1;  ///< owner of a node that no field reaches; below: shared
  static constexpr double reach = 2;        ///< cells, of any shape function

  struct Mirror {
    int axis, at, layers, inwards;
    bool keeps_low;  ///< what lies below it is the image
  };
  struct Link {
    int field, next;
  };

  std::size_t index(const Node& n) const { return static_cast<std::size_t>(&n - grid_->nodes().data()); }
  /// Outside of the grid: as many as it has nodes.
  std::size_t index_of(const Place&) const;
  FieldNode<axes>* find(std::int32_t owner, int field) {
    const SharedNode<axes>& at = shared_[static_cast<std::size_t>(-2 - owner)];
    FieldNode<axes>* f = &fields_[at.first];
    for (std::uint32_t k = 0; k < at.count; ++k, ++f)
      if (f->field == field) return f;
    return nullptr;
  }
  template <class Shape, class Space, class Use>
  void for_active(const BasicState<axes>& s, Use use) {
    for (const std::size_t p : active_)
      stencil_of<Shape, Space>(*grid_, s.particles, p)
          .for_each(*grid_, [&](Node& n, double w, const Vec<axes>& g, auto...) { use(p, n, w, g); });
  }
  /// Null: the node is not shared.
  FieldNode<axes>* shared_of(const Node& n, int field) {
    const std::int32_t owner = owner_[index(n)];
    return owner >= none ? nullptr : find(owner, field);
  }
  void look_at(FieldNode<axes>& at, const Node& n, double w, const Vec<axes>& g, double size,
               const Vec<axes>& x) {
    at.size += w * size;
    at.gradient += size * g;
    at.moment += w * size * (x - grid_->position(n));
  }
  template <class Shape, class Transfer, class Space>
  void add_images(const BasicState<axes>&);
  void begin(const BasicState<axes>&);
  void find_images(const BasicState<axes>&);
  void find_active(const BasicState<axes>&);
  void mark(std::size_t node, int field);
  bool add(std::size_t node, int field);
  void share(const BasicState<axes>&);
  void share_images(const BasicState<axes>&);
  template <class Use>
  void each_image(const BasicState<axes>&, const Place&, Use) const;
  void make_fields();

  Contacts contacts_;
  BasicGrid<axes>* grid_ = nullptr;
  std::vector<std::int32_t> field_of_;  ///< of each particle
  std::vector<std::size_t> active_;     ///< particles that may be at a shared node
  std::vector<std::int32_t> owner_;     ///< of each node: none, a field, or -2 - its number in shared_
  std::vector<SharedNode<axes>> shared_;
  std::vector<Link> links_;  ///< fields of shared nodes, as lists
  std::vector<int> head_, grown_;
  std::vector<FieldNode<axes>> fields_;
  std::vector<Mirror> mirrors_;

  /// Of a particle behind the surface of a rigid body.
  struct Image {
    std::size_t particle;
    int field;  ///< image_field()
    Vec<axes> outwards, rigid_velocity;
  };
  std::vector<Image> images_;
  BasicParticles<axes> image_places_;  ///< with what shape functions ask for
};

/// The image of a particle behind the surface of a rigid body, with H = 1 - 2 n n^T and u the velocity of the
/// rigid body there:
///   x' = H x (about the surface),   v' = 2 u - v,   force on a node: V sigma H grad w - m g
/// The body and this image meet as two equal bodies do that come against each other, along the normal and
/// across it, so that the surface between them has the velocity u. Nodes inside the body are then no
/// more held than those of a body that meets its like; a rigid body with a mass without limit would hold all
/// that its shape functions reach, 1.5 cells deep.
template <int axes>
template <class Shape, class Transfer, class Space>
void FieldNodes<axes>::add_images(const BasicState<axes>& s) {
  const auto& ps = s.particles;
  const Vec<axes> gravity = gravity_now(s);
  for (std::size_t k = 0; k < images_.size(); ++k) {
    const auto& [p, field, n, u] = images_[k];
    const Vec<axes>& x = image_places_.position[k];
    const Mat<axes> mirror = Mat<axes>::Identity() - 2 * n * n.transpose();
    const Tensor<axes> stress = ps.volume(p) * ps.stress(p);
    stencil_of<Shape, Space>(*grid_, image_places_, k)
        .for_each(*grid_, [&](Node& at, double w, const Vec<axes>& g, [[maybe_unused]] double hoop = 0) {
          FieldNode<axes>* f = shared_of(at, field);
          if (!f) return;
          look_at(*f, at, w, g, filled(s, p), x);
          Vec<axes> offset = Vec<axes>::Zero();
          if constexpr (Transfer::affine) offset = mirror * (grid_->position(at) - x);
          const double mass = w * ps.mass[p];
          f->node.mass += mass;
          f->node.velocity += mass * (2 * u - Transfer::brought(ps, p, offset));
          f->node.acceleration += product(stress, mirror * g) - mass * gravity;
          if constexpr (Space::has_hoop) f->node.acceleration.x() += hoop * stress.zz / ps.position[p].x();
        });
  }
}

}  // namespace mpm
