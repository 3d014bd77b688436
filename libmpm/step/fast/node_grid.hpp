#pragma once
#include "libmpm/boundary/mirror.hpp"
#include "libmpm/core/grid.hpp"
#include "libmpm/step/fast/aligned_array.hpp"
#include "libmpm/step/fast/kernels.hpp"

namespace mpm::fast {

/// The nodes: their motion in this step, and what the particles give them for the next.
template <class Real>
class NodeGrid {
 public:
  explicit NodeGrid(int columns);

  const Nodes<Real>& nodes() const { return nodes_; }

  /// Makes room for stencils that start in this row, and for what a step may climb.
  void reach(int row);

  /// Side walls as mirrors (boundary/mirror.hpp), before momentum and force become motion.
  void reflect_sides(int first_row, int last_row);
  /// Whether a body gives mass to the nodes of an open side in these rows, or of an open floor.
  bool at_open_face(const OpenSides&, Floor, int first_row, int last_row);
  /// The floor as a mirror, after them.
  void reflect_floor();
  /// The impact wall (boundary/impact_wall.hpp), afterwards. The heat of the contact is left in
  /// `change_square`, where particles take it up together with that of the transfer.
  void push_off_wall();

  void copy_rows(Grid&, double unit, int first, int last, int first_used, int last_used) const;
  void carry(Archive&);
  std::size_t memory() const;  ///< [bytes]

 private:
  void resize(int rows);
  Real& at(Motion component, int i, int j) {
    return nodes_.motion[Nodes<Real>::motion_at(number(i, j), component)];
  }
  std::ptrdiff_t number(int i, int j) const {
    return static_cast<std::ptrdiff_t>(j + 1) * nodes_.stride + (i + 1);
  }
  struct WallNodes;

  AlignedArray<Real> motion_, sums_;
  Nodes<Real> nodes_{};
};

}  // namespace mpm::fast
