#pragma once
#include "libmpm/boundary/walls.hpp"
#include "libmpm/core/grid.hpp"

namespace mpm {

/// The nodes of a Grid, for walls.hpp.
struct GridNodes {
  Grid& grid;

  walls::WallNode<double> at(int i, int j) const {
    Node& n = grid.at(i, j);
    return {n.mass, {&n.velocity.x(), &n.velocity.y()}, {&n.acceleration.x(), &n.acceleration.y()}};
  }
  void leave_heat(int i, int j, double heat) const { grid.at(i, j).contact_heat = heat; }
};

}  // namespace mpm
