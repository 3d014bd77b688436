#pragma once
#include <array>
#include <cstddef>
#include <vector>

#include "libmpm/core/tensor.hpp"

namespace mpm {

/// A node of the background grid. Between p2g and grid update it holds sums over particles, after it motion.
/// Units are those of plane strain, per depth; of three axes kg, N.
template <int axes>
struct BasicNode {
  double mass = 0;                             ///< sum, with what mirrors add [kg/m]
  double own_mass = 0;                         ///< sum, without it [kg/m]
  Vec<axes> velocity = Vec<axes>::Zero();      ///< momentum [kg/s], then velocity at the end [m/s]
  Vec<axes> acceleration = Vec<axes>::Zero();  ///< internal force [N/m], then acceleration [m/s^2]
  double contact_heat = 0;                     ///< what contact with the wall takes from the motion [J/kg]
};
using Node = BasicNode<2>;

/// Rows of nodes first ... last; empty if last < first.
struct RowRange {
  int first = 0, last = -1;
};

/// Uniform grid of nodes x = origin + (i hx, j hy, k hz), with layers of ghost nodes below and on all sides
/// (behind the mirrors) and as many rows upwards as the particles ask for. i: columns along x, j: rows along
/// y, k: slices along z, of which a grid of two axes has one. Nodes of a row and a slice are contiguous, and
/// those of a row.
template <int axes>
class BasicGrid {
 public:
  using Vector = Vec<axes>;
  using NodeType = BasicNode<axes>;

  /// Layers of ghost nodes: a stencil may reach this far out of [0, columns] and of [0, slices].
  static constexpr int ghosts = 2;

  /// columns: cells across; slices: cells along z.
  BasicGrid(Vector origin, Vector cell, int columns) requires(axes == 2);
  BasicGrid(Vector origin, Vector cell, int columns, int slices) requires(axes == 3);

  const Vector& origin() const { return origin_; }
  const Vector& cell() const { return cell_; }                  ///< (hx, hy, hz) [m]
  const Vector& inverse_cell() const { return inverse_cell_; }  ///< [1/m]
  int columns() const { return columns_; }
  int rows() const { return rows_; }  ///< nodes j = -ghosts ... rows() - 2 exist
  int slices() const requires(axes == 3) { return slices_; }
  int stride() const { return stride_; }

  /// Node (i, j), -ghosts <= i <= columns + ghosts, -ghosts <= j.
  NodeType& at(int i, int j) requires(axes == 2) { return nodes_[index(i, j)]; }
  const NodeType& at(int i, int j) const requires(axes == 2) { return nodes_[index(i, j)]; }
  /// Node (i, j, k), k as i.
  NodeType& at(int i, int j, int k) requires(axes == 3) { return nodes_[index(i, j, k)]; }
  const NodeType& at(int i, int j, int k) const requires(axes == 3) { return nodes_[index(i, j, k)]; }

  /// Whether a particle there reaches no further than the ghost nodes; false where x is not a number.
  bool holds(const Vector& x) const;
  /// Nodes j <= top exist after this; keeps what there is.
  void grow_to_row(int top);
  void clear();

  /// (i, j), of three axes (i, j, k), of the node with this index().
  using Place = std::array<int, axes>;
  Place place(std::size_t index) const {
    const auto at = static_cast<int>(index);
    const int i = at % stride_ - ghosts, rest = at / stride_;
    if constexpr (axes == 2)
      return {i, rest - ghosts};
    else
      return {i, rest / layers_ - ghosts, rest % layers_ - ghosts};
  }
  /// Where a node of this grid is [m].
  Vector position(const NodeType& n) const {
    const Place at = place(static_cast<std::size_t>(&n - nodes_.data()));
    Vector steps;
    for (int k = 0; k < axes; ++k) steps[k] = at[static_cast<std::size_t>(k)];
    return origin_ + cell_.cwiseProduct(steps);
  }

  std::vector<NodeType>& nodes() { return nodes_; }
  const std::vector<NodeType>& nodes() const { return nodes_; }

  std::size_t index(int i, int j) const requires(axes == 2) {
    return static_cast<std::size_t>(j + ghosts) * static_cast<std::size_t>(stride_) +
           static_cast<std::size_t>(i + ghosts);
  }
  std::size_t index(int i, int j, int k) const requires(axes == 3) {
    const std::size_t row = static_cast<std::size_t>(j + ghosts) * static_cast<std::size_t>(layers_) +
                            static_cast<std::size_t>(k + ghosts);
    return row * static_cast<std::size_t>(stride_) + static_cast<std::size_t>(i + ghosts);
  }

 private:
  Vector origin_, cell_, inverse_cell_;
  int columns_, stride_, rows_ = 0;
  int slices_ = 0, layers_ = 1;  ///< cells along z, and nodes
  std::vector<NodeType> nodes_;
};
using Grid = BasicGrid<2>;

}  // namespace mpm
