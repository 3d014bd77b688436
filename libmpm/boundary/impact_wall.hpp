#pragma once
#include <vector>

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
/// reach; unless `gaps` are tracked (WallGap::tracked). Then each column has the gap g that has opened since
/// it was last in contact,
///   g <- g + dt v,   v = - (that push) / (m_0 + sum 4 m_j m_-j / (m_j + m_-j)),
/// v the velocity of parting, the mean of v_0 and (v_j + v_-j)/2 that the push stops; it is in contact, and g
/// is 0 again, once g falls to 0. Columns begin with g = 0, and keep theirs while they have no mass.
/// Source: two bodies in one grid, Bardenhagen, Brackbill, Sulsky 2000, Comput. Methods Appl. Mech.
/// Engng 187, 529, with the second body the image of the first. Call after update_grid. Checked by
/// tests/libmpm/step_test.cpp and tests/verification/.
/// `gaps`: null, or those of the columns, ghosts too, along x and, of three axes, of slice after slice [m];
/// an empty one is filled with zeros.
void apply_impact_wall(Grid&, double dt, std::vector<double>* gaps = nullptr);
void apply_impact_wall(BasicGrid<3>&, double dt, std::vector<double>* gaps = nullptr);

}  // namespace mpm
