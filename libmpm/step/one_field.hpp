#pragma once
#include "libmpm/step/state.hpp"

namespace mpm {

/// All bodies share one velocity field: its nodes are those of the grid, and there is no contact. What a step
/// asks of fields; ManyFields (contact/many_fields.hpp) is the other answer.
struct OneField {
  /// The node of the field of particle p.
  template <class Node>
  static Node& node(Node& at, std::size_t /*p*/) {
    return at;
  }
  template <int axes, class Use>
  static void each_node(BasicGrid<axes>& grid, Use use) {
    for (BasicNode<axes>& n : grid.nodes()) use(n);
  }
  template <class Shape, class Space>
  static void start(const BasicState<Space::axes>&) {}
  template <class State>
  static bool at_open_face(const State&, int /*top_row*/) {
    return false;
  }
  template <class Shape, class Transfer, class Space>
  static void reflect(const BasicState<Space::axes>&) {}
  template <int axes>
  static void push(const BasicState<axes>&, double /*dt*/, BasicStepReport<axes>&) {}
  static void push_off_wall(double /*dt*/) {}
  template <int axes>
  static void settle(const BasicState<axes>&, double /*dt*/, BasicStepReport<axes>&) {}
};

}  // namespace mpm
