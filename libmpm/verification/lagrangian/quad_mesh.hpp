#pragma once
#include <array>
#include <cstdint>
#include <vector>

#include "libmpm/core/tensor.hpp"

namespace mpm::verification::lagrangian {

/// What a node may not do.
enum Hold : std::uint8_t {
  held_x = 1,   ///< it stays on a mirror across x
  held_y = 2,   ///< ... across y
  on_floor = 4  ///< a rigid wall below y = 0 pushes it and does not pull
};

/// Quadrilaterals over nodes; lengths in m.
struct QuadMesh {
  std::vector<Vec2> nodes;
  std::vector<std::uint8_t> holds;        ///< of each node: a sum of Hold
  std::vector<std::array<int, 4>> cells;  ///< nodes of each, counter-clockwise
  std::vector<int> rim;  ///< nodes of the inner surface, if there is one, from its lowest one upwards

  int add_node(Vec2 x, std::uint8_t hold = 0);
  /// A logical block of columns x rows cells; `node(i, j)`: the nodes it lies on, counter-clockwise in (i,
  /// j).
  template <class Node>
  void add_block(int columns, int rows, Node node) {
    for (int j = 0; j < rows; ++j)
      for (int i = 0; i < columns; ++i)
        cells.push_back({node(i, j), node(i + 1, j), node(i + 1, j + 1), node(i, j + 1)});
  }
};

/// A block between mirrors at 0 and `width`, on a floor.
QuadMesh block_mesh(double width, double height, int columns, int rows);

/// A quarter of a ring between mirrors, x, y >= 0: `around` cells along the hoop, `layers` across. Nodes lie
/// a little outside the circles, such that polygons and circles have equal areas.
QuadMesh ring_mesh(double inner_radius, double outer_radius, int around, int layers);

/// Half of a block with a cavity on its mirror x = 0, on a floor, with a mirror at the other side.
struct CavityBlock {
  double width, height;  ///< of the modelled half; of the block [m]
  double radius, center_height;
};
/// `cells`: to the radius, about; counts of cells are in proportion to `times`, so that two meshes of one
/// `cells` are nested. Rings of cells around the cavity fill a rectangle, outside of which cells are
/// rectangles themselves; where the block ends near the cavity, so does the rectangle.
/// Throws std::invalid_argument where the cavity touches a side of the block.
QuadMesh cavity_mesh(const CavityBlock&, int cells, int times);

}  // namespace mpm::verification::lagrangian
