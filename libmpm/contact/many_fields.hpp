#pragma once
#include "libmpm/contact/resolve.hpp"

namespace mpm {

/// Bodies with velocity fields of their own, in contact: see OneField (step/one_field.hpp) for what a step
/// asks when.
template <int axes>
struct ManyFields {
  FieldNodes<axes>* nodes;
  const SurfaceTable* table;

  template <class Node>
  Node& node(Node& at, std::size_t p) const {
    return nodes->node(at, p);
  }
  template <class Use>
  void each_node(BasicGrid<axes>& grid, Use use) const {
    nodes->each_node(grid, use);
  }
  template <class Shape, class Space>
  void start(const BasicState<axes>& s) const {
    nodes->template start<Shape, Space>(s);
  }
  bool at_open_face(const BasicState<axes>& s, int top_row) const { return nodes->at_open_face(s, top_row); }
  template <class Shape, class Transfer, class Space>
  void reflect(const BasicState<axes>& s) const {
    nodes->template look<Shape, Transfer, Space>(s);
    nodes->reflect();
  }
  void push(const BasicState<axes>& s, double dt, BasicStepReport<axes>& report) const {
    ContactResolver<axes>(*nodes, *table, s.time, dt).push(report);
  }
  void push_off_wall(double dt) const { nodes->push_off_wall(dt); }
  void settle(const BasicState<axes>& s, double dt, BasicStepReport<axes>& report) const {
    ContactResolver<axes>(*nodes, *table, s.time, dt).settle(report);
  }
};

}  // namespace mpm
