#include "libmpm/step/fast/blocks.hpp"

#include <numeric>

namespace mpm::fast {

template <class Real>
Blocks<Real>::Blocks(const Particles& ps, const Grid& grid, const Variant& v, double rho0)
    : variant_(v), columns_(v.columns()), particles_(ps.size()) {
  const std::size_t slots = (ps.size() + width - 1) / width * width;
  values_ = AlignedArray<Real>(slots * columns_);
  ids_.resize(slots);
  std::iota(ids_.begin(), ids_.end(), 0U);
  const Vec2& inverse = grid.inverse_cell();
  const double cells = inverse.x() * inverse.y() / rho0;
  for (std::size_t s = 0; s < slots; ++s) {
    const std::size_t p = std::min(s, particles_ - 1);
    const Vec2 xi = (ps.position[p] - grid.origin()).cwiseProduct(inverse);
    const auto set = [&](int column, double value) { at(s, column) = static_cast<Real>(value); };
    set(position_x, xi.x());
    set(position_y, xi.y());
    set(velocity_x, ps.velocity[p].x());
    set(velocity_y, ps.velocity[p].y());
    set(initial_volume, s < particles_ ? ps.mass[p] * cells : 0);
    set(dilation, ps.dilation[p]);
    set(energy, ps.energy[p]);
    set(pressure, ps.pressure[p]);
    set(viscous_pressure, ps.viscous_pressure[p]);
    set(deviator_xx, ps.deviator[p].xx);
    set(deviator_yy, ps.deviator[p].yy);
    set(deviator_xy, ps.deviator[p].xy);
    set(plastic_strain, ps.plastic_strain[p]);
    set(plastic_work, ps.plastic_work[p]);
    int next = common_columns;
    if (v.gimp) {
      set(next++, ps.half_size[p].x() * inverse.x());
      set(next++, ps.half_size[p].y() * inverse.y());
    }
    if (v.back_stress) {
      set(next++, ps.back_stress[p].xx);
      set(next++, ps.back_stress[p].yy);
      set(next++, ps.back_stress[p].xy);
    }
  }
}

template <class Real>
void Blocks<Real>::write(std::size_t s, const Grid& grid, Particles& ps, std::size_t p) const {
  const auto get = [&](int column) { return static_cast<double>(at(s, column)); };
  const auto tensor = [&](int first) {
    return PlaneTensor{get(first), get(first + 1), -(get(first) + get(first + 1)), get(first + 2)};
  };
  ps.position[p] = grid.origin() + Vec2(get(position_x), get(position_y)).cwiseProduct(grid.cell());
  ps.velocity[p] = Vec2(get(velocity_x), get(velocity_y));
  ps.dilation[p] = get(dilation);
  ps.energy[p] = get(energy);
  ps.pressure[p] = get(pressure);
  ps.viscous_pressure[p] = get(viscous_pressure);
  ps.deviator[p] = tensor(deviator_xx);
  ps.plastic_strain[p] = get(plastic_strain);
  ps.plastic_work[p] = get(plastic_work);
  int next = common_columns;
  if (variant_.gimp) {
    ps.half_size[p] = Vec2(get(next), get(next + 1)).cwiseProduct(grid.cell());
    next += 2;
  }
  if (variant_.back_stress) ps.back_stress[p] = tensor(next);
}

template <class Real>
void Blocks<Real>::copy_to(Particles& ps, const Grid& grid) const {
  for (std::size_t s = 0; s < ids_.size(); ++s)
    if (ids_[s] < particles_) write(s, grid, ps, ids_[s]);
}

template <class Real>
void Blocks<Real>::copy_to(Particles& ps, const Grid& grid, std::span<const std::size_t> which) {
  if (which.empty()) return;
  if (slots_.empty()) {
    slots_.resize(ids_.size());
    for (std::size_t s = 0; s < ids_.size(); ++s) slots_[ids_[s]] = static_cast<std::uint32_t>(s);
  }
  for (const std::size_t p : which) write(slots_[p], grid, ps, p);
}

template <class Real>
void Blocks<Real>::sort(int stride) {
  const auto key = [&](std::size_t s) {
    // the stencil of weights.hpp; a particle that left the grid has ended the run
    const int i = static_cast<int>(at(s, position_x) + Real(1.5)),
              j = static_cast<int>(at(s, position_y) + Real(1.5));
    return static_cast<std::size_t>(std::max(j, 0)) * static_cast<std::size_t>(stride) +
           static_cast<std::size_t>(std::max(i, 0));
  };
  std::vector<std::uint32_t> start;
  for (std::size_t s = 0; s < ids_.size(); ++s) {
    const std::size_t k = key(s) + 1;
    if (k >= start.size()) start.resize(k + 1 + k / 4, 0);
    ++start[k];
  }
  std::partial_sum(start.begin(), start.end(), start.begin());
  order_.resize(ids_.size());
  for (std::size_t s = 0; s < ids_.size(); ++s) order_[start[key(s)]++] = static_cast<std::uint32_t>(s);
  permute(order_);
}

/// Slot s receives what was in slot order[s].
template <class Real>
void Blocks<Real>::permute(std::span<const std::uint32_t> order) {
  constexpr int together = 4;
  if (moved_.size() == 0) moved_ = AlignedArray<Real>(together * ids_.size());
  for (int first = 0; first < columns_; first += together) {
    const int count = std::min(together, columns_ - first);
    for (std::size_t s = 0; s < order.size(); ++s)
      for (int c = 0; c < count; ++c) moved_[s * together + c] = at(order[s], first + c);
    for (std::size_t s = 0; s < order.size(); ++s)
      for (int c = 0; c < count; ++c) at(s, first + c) = moved_[s * together + c];
  }
  std::vector<std::uint32_t> ids(ids_.size());
  for (std::size_t s = 0; s < order.size(); ++s) ids[s] = ids_[order[s]];
  ids_ = std::move(ids);
  slots_.clear();
}

template <class Real>
std::size_t Blocks<Real>::memory() const {
  return (values_.size() + moved_.size()) * sizeof(Real) +
         (ids_.size() + slots_.capacity() + order_.size()) * sizeof(std::uint32_t);
}

template class Blocks<double>;

}  // namespace mpm::fast
