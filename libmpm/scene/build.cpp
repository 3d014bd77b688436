#include "libmpm/scene/build.hpp"

#include <cmath>

#include "libmpm/body/fill.hpp"
#include "libmpm/scene/kinds/kind.hpp"

namespace mpm {

Lattice lattice_of(const Scene& s) { return kind_of(s).lattice(s); }

State build_state(const Scene& s) {
  const Kind& kind = kind_of(s);
  const Lattice l = kind.lattice(s);
  const int side = static_cast<int>(std::lround(std::sqrt(s.numerics.particles_per_cell)));
  State state = empty_state(l.origin, l.cell, l.columns, kind.floor(s), s.space);
  state.particles.reserve(static_cast<std::size_t>(l.columns * l.rows * side * side));
  fill_rows(state, kind.body(s, l), s.material.reference_density, side, l.empty_rows, l.rows);
  state.particles.keep(state_columns(s.material));
  return state;
}

double initial_speed(const Scene& s) { return kind_of(s).fastest(s); }

MaterialModel build_material(const Scene& s) {
  return {s.material, {s.numerics.linear_viscosity, s.numerics.quadratic_viscosity, s.numerics.cell_size}};
}

}  // namespace mpm
