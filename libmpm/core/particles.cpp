#include "libmpm/core/particles.hpp"

#include <algorithm>
#include <stdexcept>

namespace mpm {

namespace {

/// Null where there is none of that name.
template <class Columns>
auto* find_column(Columns& columns, std::string_view name) {
  const auto found = std::ranges::find(columns, name, &MaterialColumn::name);
  return found == columns.end() ? nullptr : &*found;
}

/// Part number `part` of particles whose parts end at `ends`; no ends: all `size` are part 0.
template <class Range>
Range range_in(const std::vector<std::size_t>& ends, std::size_t part, std::size_t size) {
  if (ends.empty()) return {0, part == 0 ? size : 0};
  return {part == 0 ? 0 : ends.at(part - 1), ends.at(part)};
}
std::size_t part_of(const std::vector<std::size_t>& ends, std::size_t p) {
  return static_cast<std::size_t>(std::ranges::upper_bound(ends, p) - ends.begin());
}

}  // namespace

template <int axes>
std::span<const double> BasicParticles<axes>::own_values(std::string_view name) const {
  const auto* column = find_column(own, name);
  return column ? std::span<const double>(column->values) : std::span<const double>();
}

template <int axes>
std::span<double> BasicParticles<axes>::own_values(std::string_view name) {
  auto* column = find_column(own, name);
  return column ? std::span<double>(column->values) : std::span<double>();
}

template <int axes>
void BasicParticles<axes>::keep(std::span<const StateColumn> columns) {
  for (const StateColumn& column : columns) {
    const auto each = static_cast<std::size_t>(numbers_in(column.form, axes));
    const MaterialColumn* found = find_column(own, column.name);
    if (!found)
      own.push_back({std::string(column.name), static_cast<int>(each), std::vector<double>(size() * each)});
    else if (found->each != static_cast<int>(each) || found->values.size() != size() * each)
      throw std::logic_error("the particles have another column " + found->name);
  }
}

template <int axes>
auto BasicParticles<axes>::range_of(std::size_t material) const -> Range {
  return range_in<Range>(material_ends, material, size());
}
template <int axes>
std::size_t BasicParticles<axes>::material_of(std::size_t p) const {
  return part_of(material_ends, p);
}

template <int axes>
auto BasicParticles<axes>::range_of_body(std::size_t body) const -> Range {
  return range_in<Range>(body_ends, body, size());
}
template <int axes>
std::size_t BasicParticles<axes>::body_of(std::size_t p) const {
  return part_of(body_ends, p);
}

template <int axes>
OwnNumbers::OwnNumbers(BasicParticles<axes>& ps, std::span<const StateColumn> columns) {
  for (const StateColumn& column : columns) columns_.push_back(find_column(ps.own, column.name));
}

void OwnNumbers::read(std::size_t p, double* to) const {
  for (const MaterialColumn* column : columns_) {
    const auto each = static_cast<std::size_t>(column->each);
    to = std::copy_n(&column->values[p * each], each, to);
  }
}

void OwnNumbers::write(std::size_t p, const double* from) const {
  for (MaterialColumn* column : columns_) {
    const auto each = static_cast<std::size_t>(column->each);
    std::copy_n(from, each, &column->values[p * each]);
    from += each;
  }
}

template <int axes>
void BasicParticles<axes>::reserve(std::size_t n) {
  position.reserve(n);
  velocity.reserve(n);
  mass.reserve(n);
  initial_volume.reserve(n);
  dilation.reserve(n);
  energy.reserve(n);
  pressure.reserve(n);
  viscous_pressure.reserve(n);
  deviator.reserve(n);
  half_size.reserve(n);
}

template <int axes>
void BasicParticles<axes>::add(Vector x, Vector v, double m, double v0, Vector half) {
  position.push_back(x);
  velocity.push_back(v);
  mass.push_back(m);
  initial_volume.push_back(v0);
  dilation.push_back(0);
  energy.push_back(0);
  pressure.push_back(0);
  viscous_pressure.push_back(0);
  deviator.push_back({});
  for (MaterialColumn& column : own)
    column.values.resize(column.values.size() + static_cast<std::size_t>(column.each));
  half_size.push_back(half);
}

template <int axes>
void carry_particles(BasicParticles<axes>& ps, Archive& a) {
  a.numbers("position", ps.position), a.numbers("velocity", ps.velocity);
  a.numbers("mass", ps.mass), a.numbers("initial_volume", ps.initial_volume);
  a.numbers("dilation", ps.dilation), a.numbers("energy", ps.energy);
  a.numbers("pressure", ps.pressure), a.numbers("viscous_pressure", ps.viscous_pressure);
  a.numbers("deviator", ps.deviator);
  a.numbers("half_size", ps.half_size), a.numbers("domain", ps.domain);
  a.numbers("affine", ps.affine), a.numbers("affine_energy", ps.affine_energy);
  Archive material = a.part("material");
  for (MaterialColumn& column : ps.own) material.numbers(column.name, column.values);
}

template struct BasicParticles<2>;
template struct BasicParticles<3>;
template OwnNumbers::OwnNumbers(BasicParticles<2>&, std::span<const StateColumn>);
template OwnNumbers::OwnNumbers(BasicParticles<3>&, std::span<const StateColumn>);
template void carry_particles(BasicParticles<2>&, Archive&);
template void carry_particles(BasicParticles<3>&, Archive&);

}  // namespace mpm
