#include "libmpm/scene/build.hpp"

#include "libmpm/body/fill.hpp"
#include "libmpm/core/errors.hpp"
#include "libmpm/scene/kinds/kind.hpp"

namespace mpm {

template <int axes>
BasicState<axes> empty_state_of(const Scene& s, const BasicLattice<axes>& l) {
  const Floor floor = kind_of(s).floor(s);
  if constexpr (axes == 2)
    return empty_state(l.origin, l.cell, l.columns, floor, s.space);
  else
    return empty_state(l.origin, l.cell, l.columns, l.slices, floor);
}

namespace {

template <int axes>
BasicState<axes> one_body(const Scene& s) {
  const Kind& kind = kind_of(s);
  const BasicLattice<axes> l = kind.in<axes>().lattice(s);
  BasicState<axes> state = empty_state_of<axes>(s, l);
  const auto cells =
      static_cast<std::size_t>(l.columns * l.rows) * static_cast<std::size_t>(axes == 2 ? 1 : l.slices);
  state.particles.reserve(cells * static_cast<std::size_t>(s.numerics.particles_per_cell));
  fill_rows(state, kind.in<axes>().body(s, l), s.material.reference_density,
            particles_per_edge(s.numerics, axes), l.empty_rows, l.rows);
  return state;
}

}  // namespace

template <int axes>
BasicLattice<axes> lattice_of(const Scene& s) {
  return kind_of(s).in<axes>().lattice(s);
}

template <int axes>
BasicState<axes> build_state(const Scene& s) {
  BasicState<axes> state = kind_of(s).in<axes>().state ? kind_of(s).in<axes>().state(s) : one_body<axes>(s);
  state.tracks_wall_gap = s.numerics.wall_gap == WallGap::tracked;
  for (std::size_t m = 0; m < material_count(s); ++m) state.particles.keep(state_columns(material_of(s, m)));
  return state;
}

double initial_speed(const Scene& s) { return kind_of(s).fastest(s); }

MaterialModel build_material(const Scene& s) {
  return {s.material, {s.numerics.linear_viscosity, s.numerics.quadratic_viscosity, s.numerics.cell_size}};
}

const Material& material_of(const Scene& s, std::size_t index) {
  if (index >= material_count(s))
    throw InputError("material = " + std::to_string(index) + ": must be below " +
                     std::to_string(material_count(s)) + ", the number of materials of the scene");
  return index == 0 ? s.material : s.other_materials[index - 1];
}

MaterialModels build_materials(const Scene& s) {
  MaterialModels models(build_material(s));
  for (const Material& m : s.other_materials) models.of.push_back({m, models.of[0].viscosity});
  return models;
}

std::vector<Temperature> temperatures_of(const Scene& s) {
  std::vector<Temperature> all;
  for (std::size_t m = 0; m < material_count(s); ++m) all.emplace_back(material_of(s, m));
  return all;
}

template Lattice lattice_of(const Scene&);
template BasicLattice<3> lattice_of(const Scene&);
template State empty_state_of(const Scene&, const Lattice&);
template BasicState<3> empty_state_of(const Scene&, const BasicLattice<3>&);
template State build_state(const Scene&);
template BasicState<3> build_state(const Scene&);

}  // namespace mpm
