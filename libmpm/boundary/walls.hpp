#pragma once
/// What walls do to the nodes of a grid: one text for the plain step and the fast one. The rules, with their
/// sources, are in mirror.hpp and impact_wall.hpp.
///
/// `Nodes` gives access to a grid, in which layers of nodes lie behind the walls:
///   nodes.at(i, j)               a WallNode
///   nodes.leave_heat(i, j, h)    h [J/kg]: what the contact took from the motion of the node
namespace mpm::walls {

/// A node by its axes. Before the grid update v is momentum and a force, after it they are velocity and rate.
template <class Real>
struct WallNode {
  Real& mass;
  Real* v[2];
  Real* a[2];
};

/// A node on the mirror across `axis`: it and its image are one, of twice the mass, momentum and force.
template <class Real>
void stop(const WallNode<Real>& n, int axis) {
  n.mass *= 2;
  for (int k = 0; k < 2; ++k) *n.v[k] *= 2, *n.a[k] *= 2;
  *n.v[axis] = *n.a[axis] = 0;
}

/// Adds to each of two nodes the image of the other.
template <class Real>
void join(const WallNode<Real>& n, const WallNode<Real>& image, int axis) {
  image.mass = n.mass += image.mass;
  for (int k = 0; k < 2; ++k) {
    const Real sign = k == axis ? -1 : 1;
    *image.v[k] = sign * (*n.v[k] += sign * *image.v[k]);
    *image.a[k] = sign * (*n.a[k] += sign * *image.a[k]);
  }
}

/// Mirrors at the columns 0 and `right`, for the rows [first, last] and `layers` of nodes behind them.
template <class Nodes>
void reflect_sides(Nodes nodes, int right, int first, int last, int layers) {
  for (int j = first; j <= last; ++j)
    for (const int wall : {0, right}) {
      const int inwards = wall == 0 ? 1 : -1;
      stop(nodes.at(wall, j), 0);
      for (int k = 1; k <= layers; ++k)
        join(nodes.at(wall + inwards * k, j), nodes.at(wall - inwards * k, j), 0);
    }
}

/// A mirror along `row`, for the columns [first, last] and `layers` of rows below it.
template <class Nodes>
void reflect_row(Nodes nodes, int row, int first, int last, int layers) {
  for (int i = first; i <= last; ++i) {
    stop(nodes.at(i, row), 1);
    for (int k = 1; k <= layers; ++k) join(nodes.at(i, row + k), nodes.at(i, row - k), 1);
  }
}

/// Gives a node another velocity. a is the change of v over `step`.
template <class Nodes, class Real>
void move_to(Nodes nodes, int i, int j, Real x, Real y, Real step) {
  const WallNode<Real> n = nodes.at(i, j);
  const Real change[2] = {x - *n.v[0], y - *n.v[1]};
  *n.v[0] = x, *n.v[1] = y;
  for (int k = 0; k < 2; ++k) *n.a[k] += change[k] / step;
  const Real half = Real(0.5) * step;
  nodes.leave_heat(i, j, -(change[0] * (x - half * *n.a[0]) + change[1] * (y - half * *n.a[1])));
}

/// The impact wall along row 0, for the columns [first, last] and `layers` of rows on either side. `step`:
/// the time over which v changes by a; 1 where a is the change itself.
template <class Real, class Nodes>
void push_off_wall(Nodes nodes, int first, int last, int layers, Real step) {
  for (int i = first; i <= last; ++i) {
    const WallNode<Real> wall = nodes.at(i, 0);
    if (wall.mass == 0) continue;
    // the velocity of the common momentum of a node above the wall and the image of the one below
    const auto common = [&](int k, int axis) {
      const WallNode<Real> above = nodes.at(i, k), below = nodes.at(i, -k);
      if (!(below.mass > 0)) return *above.v[axis];
      const Real image = axis == 1 ? -*below.v[axis] : *below.v[axis];
      return (above.mass * *above.v[axis] + below.mass * image) / (above.mass + below.mass);
    };
    Real push = -(wall.mass * *wall.v[1]);
    for (int k = 1; k <= layers; ++k) {
      const WallNode<Real> above = nodes.at(i, k), below = nodes.at(i, -k);
      const Real y = common(k, 1);
      push = above.mass * (y - *above.v[1]) + push + below.mass * (-y - *below.v[1]);
    }
    if (!(push > 0)) continue;
    move_to(nodes, i, 0, *wall.v[0], Real(0), step);
    for (int k = 1; k <= layers; ++k) {
      if (nodes.at(i, k).mass == 0 && nodes.at(i, -k).mass == 0) continue;
      const Real x = common(k, 0), y = common(k, 1);
      move_to(nodes, i, k, x, y, step);
      move_to(nodes, i, -k, x, -y, step);
    }
  }
}

}  // namespace mpm::walls
