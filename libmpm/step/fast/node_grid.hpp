#pragma once
#include "libmpm/core/grid.hpp"
#include "libmpm/step/fast/aligned_array.hpp"
#include "libmpm/step/fast/kernels.hpp"

namespace mpm::fast {

/// Nodes of one time level, and which of their rows are in use.
template <class Real>
class NodeGrid {
 public:
  explicit NodeGrid(int columns);

  const Nodes<Real>& nodes() const { return nodes_; }
  int first_row() const { return first_; }
  int last_row() const { return last_; }

  /// Empties the rows that were in use and makes room for particles up to y = `highest` cells and a little
  /// further.
  void prepare(double highest);
  /// Says which rows the particles between these heights [cells] have reached.
  void use(double lowest, double highest);

  /// Side walls as mirrors (boundary/mirror.hpp), before momentum and force become motion.
  void reflect_sides();
  /// The floor as a mirror, after them.
  void reflect_floor();
  /// The impact wall (boundary/impact_wall.hpp), afterwards. The heat of the contact is left in `square`,
  /// where particles take it up together with that of the transfer.
  void push_off_wall();

  void copy_rows(Grid&, double rho0, int first, int last) const;
  std::size_t memory() const;  ///< [bytes]

 private:
  Real* motion(int i, int j) { return nodes_.motion + 4 * index(i, j); }
  std::size_t index(int i, int j) const {
    return static_cast<std::size_t>(j + 1) * static_cast<std::size_t>(nodes_.stride) +
           static_cast<std::size_t>(i + 1);
  }
  void stop(int i, int j, int axis);
  void join(int i, int j, int image_i, int image_j, int axis);
  void move_to(int i, int j, Real velocity_x, Real velocity_y);

  AlignedArray<Real> motion_, mass_, square_;
  Nodes<Real> nodes_{};
  int first_ = 0, last_ = -1;  ///< rows in use
};

}  // namespace mpm::fast
