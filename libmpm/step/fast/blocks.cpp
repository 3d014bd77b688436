#include "libmpm/step/fast/blocks.hpp"

#include <cmath>
#include <numeric>

#include "libmpm/material/list.hpp"

namespace mpm::fast {

template <class Real>
Blocks<Real>::Blocks(Particles& ps, Particles::Range range, std::span<const StateColumn> own_columns,
                     const Grid& grid, const Layout& layout, double rho0, int stride)
    : layout_(layout), range_(range), own_(own_columns), columns_(layout.columns()), stride_(stride) {
  const std::size_t count = range.last - range.first, slots = (count + width - 1) / width * width;
  values_ = AlignedArray<Real>(slots * static_cast<std::size_t>(columns_));
  ids_.assign(slots, nobody);
  std::iota(ids_.begin(), ids_.begin() + static_cast<std::ptrdiff_t>(count),
            static_cast<std::uint32_t>(range.first));
  const OwnNumbers own_numbers(ps, own_columns);
  const Vec2& inverse = grid.inverse_cell();
  const bool radial = layout.space == Space::axisymmetric;
  const double per_unit = inverse.x() * inverse.y() / rho0 * (radial ? inverse.x() : 1);  // 1 / unit_mass()
  for (std::size_t s = 0; s < count; ++s) {
    const std::size_t p = range.first + s;
    const Vec2 xi = (ps.position[p] - grid.origin()).cwiseProduct(inverse);
    const Vec2 nearest(std::floor(xi.x() + 0.5), std::floor(xi.y() + 0.5));
    const auto set = [&](int column, double value) { at(s, column) = static_cast<Real>(value); };
    set(node, nearest.y() * stride + nearest.x());
    set(position_x, xi.x() - nearest.x());
    set(position_y, xi.y() - nearest.y());
    set(velocity_x, ps.velocity[p].x());
    set(velocity_y, ps.velocity[p].y());
    set(initial_volume, ps.mass[p] * per_unit);
    set(dilation, ps.dilation[p]);
    set(energy, ps.energy[p]);
    set(pressure, ps.pressure[p]);
    set(viscous_pressure, ps.viscous_pressure[p]);
    set(deviator_xx, ps.deviator[p].xx);
    set(deviator_yy, ps.deviator[p].yy);
    set(deviator_xy, ps.deviator[p].xy);
    for (int axis = 0; axis < layout.half_sizes(); ++axis)
      set(layout.half_size() + axis, ps.half_size[p][axis] * inverse[axis]);
    double own[most_own_numbers<Real, 2>];
    own_numbers.read(p, own);
    for (int c = 0; c < layout.own_columns; ++c) set(layout.own() + c, own[c]);
  }
}

template <class Real>
void Blocks<Real>::write(std::size_t s, const Grid& grid, Particles& ps,
                         const OwnNumbers& own_numbers) const {
  const std::size_t p = ids_[s];
  const auto get = [&](int column) { return static_cast<double>(at(s, column)); };
  const int n = static_cast<int>(at(s, node));
  const Vec2 xi(n % stride_ + get(position_x), n / stride_ + get(position_y));
  ps.position[p] = grid.origin() + xi.cwiseProduct(grid.cell());
  ps.velocity[p] = Vec2(get(velocity_x), get(velocity_y));
  ps.dilation[p] = get(dilation);
  ps.energy[p] = get(energy);
  ps.pressure[p] = get(pressure);
  ps.viscous_pressure[p] = get(viscous_pressure);
  const double xx = get(deviator_xx), yy = get(deviator_yy);
  ps.deviator[p] = {xx, yy, -(xx + yy), get(deviator_xy)};
  for (int axis = 0; axis < layout_.half_sizes(); ++axis)
    ps.half_size[p][axis] = get(layout_.half_size() + axis) * grid.cell()[axis];
  double own[most_own_numbers<Real, 2>];
  for (int c = 0; c < layout_.own_columns; ++c) own[c] = get(layout_.own() + c);
  own_numbers.write(p, own);
}

template <class Real>
void Blocks<Real>::copy_to(Particles& ps, const Grid& grid) const {
  const OwnNumbers own_numbers(ps, own_);
  for (std::size_t s = 0; s < ids_.size(); ++s)
    if (ids_[s] != nobody) write(s, grid, ps, own_numbers);
}

template <class Real>
void Blocks<Real>::copy_to(Particles& ps, const Grid& grid, std::span<const std::size_t> which) {
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

template <class Real>
std::size_t Blocks<Real>::memory() const {
  return values_.size() * sizeof(Real) + (ids_.capacity() + slots_.capacity()) * sizeof(std::uint32_t) +
         bands_.capacity() * sizeof(Range) + sort_memory_;
}

template <class Real>
void Blocks<Real>::carry(Archive& a) {
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

template class Blocks<double>;
template class Blocks<float>;

}  // namespace mpm::fast
