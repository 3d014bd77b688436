#pragma once
#include <cstddef>
#include <vector>

#include "libmpm/core/tensor.hpp"

namespace mpm {

/// A node of the background grid. Between p2g and grid update it holds sums over particles, after it motion.
struct Node {
  double mass = 0;                   ///< sum, with what mirrors add [kg/m]
  double own_mass = 0;               ///< sum, without it [kg/m]
  Vec2 velocity = Vec2::Zero();      ///< momentum [kg/s], then velocity at the end of the step [m/s]
  Vec2 acceleration = Vec2::Zero();  ///< internal force [N/m], then acceleration [m/s^2]
  double contact_heat = 0;           ///< energy that the contact with the wall takes from the motion [J/kg]
};

/// Rows of nodes first ... last; empty if last < first.
struct RowRange {
  int first = 0, last = -1;
};

/// Uniform grid of nodes x = origin + (i hx, j hy), with layers of ghost nodes below and on both sides
/// (behind the mirrors) and as many rows upwards as the particles ask for. Rows are contiguous.
class Grid {
 public:
  /// Layers of ghost nodes: a stencil may reach this far out of [0, columns].
  static constexpr int ghosts = 2;

  /// columns: cells across.
  Grid(Vec2 origin, Vec2 cell, int columns);

  const Vec2& origin() const { return origin_; }
  const Vec2& cell() const { return cell_; }                  ///< (hx, hy) [m]
  const Vec2& inverse_cell() const { return inverse_cell_; }  ///< [1/m]
  int columns() const { return columns_; }
  int rows() const { return rows_; }  ///< nodes j = -ghosts ... rows() - 2 exist
  int stride() const { return stride_; }

  /// Node (i, j), -ghosts <= i <= columns + ghosts, -ghosts <= j.
  Node& at(int i, int j) { return nodes_[index(i, j)]; }
  const Node& at(int i, int j) const { return nodes_[index(i, j)]; }

  /// Nodes j <= top exist after this; keeps what there is.
  void grow_to_row(int top);
  void clear();

  /// Where a node of this grid is [m].
  Vec2 position(const Node& n) const {
    const auto k = static_cast<int>(&n - nodes_.data());
    return origin_ + cell_.cwiseProduct(Vec2(k % stride_ - ghosts, k / stride_ - ghosts));
  }

  std::vector<Node>& nodes() { return nodes_; }
  const std::vector<Node>& nodes() const { return nodes_; }

  std::size_t index(int i, int j) const {
    return static_cast<std::size_t>(j + ghosts) * static_cast<std::size_t>(stride_) +
           static_cast<std::size_t>(i + ghosts);
  }

 private:
  Vec2 origin_, cell_, inverse_cell_;
  int columns_, stride_, rows_ = 0;
  std::vector<Node> nodes_;
};

}  // namespace mpm
