#pragma once
#include <vector>

#include "libmpm/boundary/mirror.hpp"
#include "libmpm/boundary/walls.hpp"
#include "libmpm/core/grid.hpp"
#include "libmpm/step/fast/aligned_array.hpp"
#include "libmpm/step/fast/kernels.hpp"

namespace mpm::fast {

/// The nodes: their motion in this step, and what the particles give them for the next.
template <class Real, int axes>
class NodeGrid {
 public:
  using Nodes = fast::Nodes<Real, axes>;
  using Grid = BasicGrid<axes>;

  /// For the columns, and of three axes the slices, of the grid.
  explicit NodeGrid(const Grid&);

  const Nodes& nodes() const { return nodes_; }

  /// Makes room for stencils that start in this row, and for what a step may climb. Throws InputError where
  /// nodes have numbers that the kernels cannot count.
  void reach(int row);

  /// Side walls as mirrors (boundary/mirror.hpp), before momentum and force become motion.
  void reflect_sides(int first_row, int last_row);
  /// Whether a body gives mass to the nodes of an open side in these rows, or of an open floor.
  bool at_open_face(const OpenSides&, Floor, int first_row, int last_row);
  /// The floor as a mirror, after them.
  void reflect_floor();
  /// The impact wall (boundary/impact_wall.hpp), afterwards. The heat of the contact is left in
  /// `change_square`, where particles take it up together with that of the transfer. `gaps`: null, or as of
  /// apply_impact_wall(), of the columns and slices with one ghost on each side.
  void push_off_wall(std::vector<double>* gaps, double dt);

  void copy_rows(Grid&, double unit, int first, int last, int first_used, int last_used) const;
  void carry(Archive&);
  std::size_t memory() const;  ///< [bytes]

 private:
  using M = Motion<axes>;
  void resize(int rows);
  Real& at(int component, int i, int j, int k = -1) {
    return nodes_.motion[Nodes::motion_at(number(i, j, k), component)];
  }
  /// Of two axes k = -1.
  std::ptrdiff_t number(int i, int j, int k) const { return nodes_.to_line(j + 1, k + 1) + (i + 1); }
  walls::WallNode<Real, axes> wall_node(int i, int j, int k);
  struct Slice;
  struct Column;
  /// Calls use(Slice) for every slice, the ghosts too; of two axes for the only one.
  template <class Use>
  void each_slice(Use use);

  AlignedArray<Real> motion_, sums_;
  Nodes nodes_{};
};

}  // namespace mpm::fast
