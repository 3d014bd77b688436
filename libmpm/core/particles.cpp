#include "libmpm/core/particles.hpp"

#include <algorithm>
#include <stdexcept>

namespace mpm {

template <int axes>
std::span<const double> BasicParticles<axes>::own_values(std::string_view name) const {
  const auto found = std::ranges::find(own, name, &MaterialColumn::name);
  return found == own.end() ? std::span<const double>{} : std::span<const double>(found->values);
}

template <int axes>
std::span<double> BasicParticles<axes>::own_values(std::string_view name) {
  const auto found = std::ranges::find(own, name, &MaterialColumn::name);
  return found == own.end() ? std::span<double>{} : std::span<double>(found->values);
}

template <int axes>
void BasicParticles<axes>::keep(std::span<const StateColumn> columns) {
  if (own.empty())
    for (const StateColumn& column : columns) {
      const int each = numbers_in(column.form, axes);
      own.push_back(
          {std::string(column.name), each, std::vector<double>(size() * static_cast<std::size_t>(each))});
    }
  const auto same = [&](const MaterialColumn& mine, const StateColumn& column) {
    return mine.name == column.name && mine.each == numbers_in(column.form, axes) &&
           mine.values.size() == size() * static_cast<std::size_t>(mine.each);
  };
  if (!std::ranges::equal(own, columns, same))
    throw std::logic_error("the particles have columns of another material model");
}

template <int axes>
void BasicParticles<axes>::read_own(std::size_t p, double* to) const {
  for (const MaterialColumn& column : own) {
    const auto each = static_cast<std::size_t>(column.each);
    to = std::copy_n(&column.values[p * each], each, to);
  }
}

template <int axes>
void BasicParticles<axes>::write_own(std::size_t p, const double* from) {
  for (MaterialColumn& column : own) {
    const auto each = static_cast<std::size_t>(column.each);
    std::copy_n(from, each, &column.values[p * each]);
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
template void carry_particles(BasicParticles<2>&, Archive&);
template void carry_particles(BasicParticles<3>&, Archive&);

}  // namespace mpm
