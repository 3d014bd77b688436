#pragma once
#include "libmpm/core/grid.hpp"

namespace mpm {

/// Rigid, frictionless impact wall at y = origin, which pushes and does not pull.
///
/// In contact the body moves as if its mirror image came against it: normal velocities of the three rows of
/// nodes around the wall become antisymmetric, tangential ones symmetric, each pair at the velocity of its
/// common momentum. A column of nodes is in contact if that takes a push, sum of m_j dv_y over its rows > 0;
/// otherwise the body leaves. The change is handed to the particles as acceleration: without it FLIP would
/// let them keep the velocity of their approach, and it would not show whether they part. What the
/// contact takes from the motion,
///   - dv . (v - dt a / 2)   per mass, v and a those after the contact,
/// is left as heat at the nodes (contact_heat), so that the sum of kinetic and internal energy is kept.
/// A body that comes back is felt from a distance of about a cell on, since that is how far shape functions
/// reach. Source: two bodies in one grid, Bardenhagen, Brackbill, Sulsky 2000, Comput. Methods Appl. Mech.
/// Engng 187, 529, with the second body the image of the first. Call after update_grid. Checked by
/// tests/libmpm/step_test.cpp and tests/verification/.
void apply_impact_wall(Grid&, double dt);
void apply_impact_wall(BasicGrid<3>&, double dt);

}  // namespace mpm
