#include "libmpm/step/fast/blocks.hpp"

#include <cmath>
#include <numeric>

#include "libmpm/core/deviator_numbers.hpp"
#include "libmpm/material/list.hpp"

namespace mpm::fast {

template <class Real, int axes>
Blocks<Real, axes>::Blocks(Particles& ps, typename Particles::Range range,
                           std::span<const StateColumn> own_columns, const Grid& grid, const Layout& layout,
                           double rho0, const Nodes<Real, axes>& nodes)
    : layout_(layout),
      range_(range),
      own_(own_columns),
      columns_(layout.columns()),
      stride_(nodes.stride),
      to_row_(nodes.to_row) {
  const std::size_t count = range.last - range.first, slots = (count + width - 1) / width * width;
  values_ = AlignedArray<Real>(slots * static_cast<std::size_t>(columns_));
  ids_.assign(slots, nobody);
  std::iota(ids_.begin(), ids_.begin() + static_cast<std::ptrdiff_t>(count),
            static_cast<std::uint32_t>(range.first));
  const OwnNumbers own_numbers(ps, own_columns);
  const Vec<axes>& inverse = grid.inverse_cell();
  const bool radial = layout.space == Space::axisymmetric;
  const double per_unit = inverse.prod() / rho0 * (radial ? inverse.x() : 1);  // 1 / unit_mass()
  for (std::size_t s = 0; s < count; ++s) {
    const std::size_t p = range.first + s;
    const Vec<axes> xi = (ps.position[p] - grid.origin()).cwiseProduct(inverse);
    const Vec<axes> nearest = (xi.array() + 0.5).floor();
    const auto set = [&](int column, double value) { at(s, column) = static_cast<Real>(value); };
    int number = static_cast<int>(nearest.y()) * to_row_ + static_cast<int>(nearest.x());
    if constexpr (axes == 3) number += static_cast<int>(nearest.z()) * stride_;
    at(s, C::node) = real_of_node<Real>(number);
    for (int a = 0; a < axes; ++a) {
      set(C::position + a, xi[a] - nearest[a]);
      set(C::velocity + a, ps.velocity[p][a]);
    }
    set(C::initial_volume, ps.mass[p] * per_unit);
    set(C::dilation, ps.dilation[p]);
    set(C::energy, ps.energy[p]);
    set(C::pressure, ps.pressure[p]);
    set(C::viscous_pressure, ps.viscous_pressure[p]);
    double deviator[C::common - C::deviator];
    store(numbers_of(ps.deviator[p]), deviator);
    for (int c = C::deviator; c < C::common; ++c) set(c, deviator[c - C::deviator]);
    for (int axis = 0; axis < layout.half_sizes(); ++axis)
      set(layout.half_size() + axis, ps.half_size[p][axis] * inverse[axis]);
    double own[most_own_numbers<Real, axes>];
    own_numbers.read(p, own);
    for (int c = 0; c < layout.own_columns; ++c) set(layout.own() + c, own[c]);
  }
}

template <class Real, int axes>
void Blocks<Real, axes>::write(std::size_t s, const Grid& grid, Particles& ps,
                               const OwnNumbers& own_numbers) const {
  const std::size_t p = ids_[s];
  const auto get = [&](int column) { return static_cast<double>(at(s, column)); };
  const int n = static_cast<int>(node_of(s)), in_row = n % to_row_;
  Vec<axes> xi;
  xi[0] = in_row % stride_ + get(C::position);
  xi[1] = n / to_row_ + get(C::position + 1);
  if constexpr (axes == 3) xi[2] = in_row / stride_ + get(C::position + 2);
  ps.position[p] = grid.origin() + xi.cwiseProduct(grid.cell());
  for (int a = 0; a < axes; ++a) ps.velocity[p][a] = get(C::velocity + a);
  ps.dilation[p] = get(C::dilation);
  ps.energy[p] = get(C::energy);
  ps.pressure[p] = get(C::pressure);
  ps.viscous_pressure[p] = get(C::viscous_pressure);
  double deviator[C::common - C::deviator];
  for (int c = C::deviator; c < C::common; ++c) deviator[c - C::deviator] = get(c);
  decltype(numbers_of(ps.deviator[p])) numbers;
  load(deviator, numbers);
  ps.deviator[p] = tensor_of(numbers);
  for (int axis = 0; axis < layout_.half_sizes(); ++axis)
    ps.half_size[p][axis] = get(layout_.half_size() + axis) * grid.cell()[axis];
  double own[most_own_numbers<Real, axes>];
  for (int c = 0; c < layout_.own_columns; ++c) own[c] = get(layout_.own() + c);
  own_numbers.write(p, own);
}

template <class Real, int axes>
void Blocks<Real, axes>::copy_to(Particles& ps, const Grid& grid) const {
  const OwnNumbers own_numbers(ps, own_);
  for (std::size_t s = 0; s < ids_.size(); ++s)
    if (ids_[s] != nobody) write(s, grid, ps, own_numbers);
}

template <class Real, int axes>
void Blocks<Real, axes>::copy_to(Particles& ps, const Grid& grid, std::span<const std::size_t> which) {
  if (which.empty()) return;
  if (slots_.empty()) {
    slots_.resize(range_.last - range_.first);
    for (std::size_t s = 0; s < ids_.size(); ++s)
      if (ids_[s] != nobody) slots_[ids_[s] - range_.first] = static_cast<std::uint32_t>(s);
  }
  const OwnNumbers own_numbers(ps, own_);
  for (const std::size_t p : which)
    if (p >= range_.first && p < range_.last) write(slots_[p - range_.first], grid, ps, own_numbers);
}

template <class Real, int axes>
std::size_t Blocks<Real, axes>::memory() const {
  return values_.size() * sizeof(Real) + (ids_.capacity() + slots_.capacity()) * sizeof(std::uint32_t) +
         bands_.capacity() * sizeof(Range) + sort_memory_;
}

template <class Real, int axes>
void Blocks<Real, axes>::carry(Archive& a) {
  mpm::fast::carry(values_, count() * block_size(), "values", a);
  a.integers("ids", ids_), a.integer("loose", loose_);
  std::vector<std::size_t> ranges;
  for (const Range& r : bands_)
    for (const std::size_t v :
         {r.first, r.count, static_cast<std::size_t>(r.first_row), static_cast<std::size_t>(r.last_row)})
      ranges.push_back(v);
  a.integers("bands", ranges);
  bands_.clear();
  for (std::size_t i = 0; i + 3 < ranges.size(); i += 4)
    bands_.push_back(
        {ranges[i], ranges[i + 1], static_cast<int>(ranges[i + 2]), static_cast<int>(ranges[i + 3])});
  slots_ = {};
}

template class Blocks<double, 2>;
template class Blocks<float, 2>;
template class Blocks<double, 3>;
template class Blocks<float, 3>;

}  // namespace mpm::fast
