#pragma once
#include <algorithm>

#include "libmpm/contact/field_nodes.hpp"
#include "libmpm/contact/surface_table.hpp"

namespace mpm {

/// Contact between the fields at shared nodes, after the forces have become velocities.
///
/// Of a pair, a and b, at a node i:
///   normal    n = (g_a - g_b) / |g_a - g_b|, from a to b, of the gradients of the volumes that it sees: one
///             for both, so that momentum is kept, and none that a difference of densities turns
///   gap       d = -s(-D_b) - s(D_a), with D_a = (x_a - x_i).n the centroid that the node sees
///             (surface_table.hpp)
///   Both are means over the node and its neighbours, weighed by (f_a f_b)^4 with f the share of its cell
///   that a node sees filled: a node off the face sees a sliver of one side, whose surface it does not know,
///   or the side of a corner, which is no face. approach  (v_a - v_b).n dt > max(d, 0): bodies that are apart
///   may come together, and no further
/// Both together are contact. Then, with m = m_a m_b / (m_a + m_b),
///   N = m ((v_a - v_b).n - max(d, 0) / dt),   T by the law of the pair (frictionless.hpp, coulomb.hpp)
///   v_a <- v_a - (N n + T) / m_a,   v_b <- v_b + (N n + T) / m_b
/// Where more than two meet, pair after pair, again and again, with impulses that add up (E. Catto's
/// sequential impulses). Against a rigid body b is the image of a in it (FieldNodes::add_images), and n minus
/// the normal of its surface.
///
/// The change goes into the acceleration as a whole, as that of the impact wall does (impact_wall.hpp). Codes
/// that give particles the change of momentum of the forces alone apply contact before the forces as well,
/// lest its first part is lost to them (Nairn, Hammerquist, Smith 2020, Comput. Methods Appl. Mech. Engng
/// 362, 112859); here nothing is lost, and once is enough: the velocity before the forces moves nothing.
///
/// What contact takes from the motion at a node, - sum m_k dv_k . (v_k - dt a_k/2) over the fields and the
/// work of rigid bodies, is left as heat, the same per mass for all fields there: so total energy is kept to
/// rounding, and momentum as well.
/// Sources: Nairn (above); gaps from centroids: J. A. Nairn 2013, Comput. Model. Eng. Sci. 92, 271;
/// Bardenhagen, Guilkey, Roessig, Brackbill, Witzel, Foster 2001, Comput. Model. Eng. Sci. 2, 509. Checked by
/// tests/libmpm/contact_test.cpp and tests/verification/contact_test.cpp.
template <int axes>
class ContactResolver {
 public:
  ContactResolver(FieldNodes<axes>& fields, const SurfaceTable& table, double time, double dt)
      : fields_(fields),
        table_(table),
        time_(time),
        dt_(dt),
        inverse_volume_(1 / fields.grid().cell().prod()) {}

  /// Changes velocities and accelerations of the fields' nodes.
  void push(BasicStepReport<axes>&);
  /// After the walls: what all of it leaves as heat. Gives the nodes of the grid the mean of the fields.
  void settle(BasicStepReport<axes>&);

 private:
  /// Two fields, or a field and its image, at one node.
  struct Touch {
    FieldNode<axes>* a;
    FieldNode<axes>* b;  ///< another field, or the image of a in a rigid body
    int field;           ///< of b, that of the rigid body
    bool rigid;
    Vec<axes> normal;          ///< from a to b
    Vec<axes> rigid_velocity;  ///< at its surface
    double allowed;            ///< speed of approach [m/s]
    const ContactRule* rule;
    double push = 0;                     ///< N
    Vec<axes> drag = Vec<axes>::Zero();  ///< T, on b
  };
  using Place = typename FieldNodes<axes>::Place;

  void count_own();
  void find_touches(const SharedNode<axes>&, const Place&);
  void find_pair(const SharedNode<axes>&, const Place&, FieldNode<axes>& a, FieldNode<axes>& b);
  double solve(Touch&) const;  ///< the change of its impulse, over what it is [1]
  void report_touches(SharedNode<axes>&, BasicStepReport<axes>&);
  void copy_to_images();

  /// Share of a node's cell that a field fills.
  double share(const FieldNode<axes>& f) const { return std::clamp(f.size * inverse_volume_, 0.0, 1.0); }
  double cell_along(const Vec<axes>& n) const { return fields_.grid().cell().dot(n.cwiseAbs2()); }
  /// Of a field's surface from the node along n [m].
  double surface(const FieldNode<axes>& f, const Vec<axes>& n) const {
    const double h = cell_along(n);
    return h * table_.surface(f.moment.dot(n) / (f.size * h));
  }
  /// Calls use(shared node, weight) for a node and its neighbours.
  template <class Use>
  void around(const Place&, Use);

  FieldNodes<axes>& fields_;
  const SurfaceTable& table_;
  double time_, dt_, inverse_volume_;
  std::vector<Touch> touches_;
};

}  // namespace mpm
