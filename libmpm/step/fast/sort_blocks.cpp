#include <algorithm>

#include "libmpm/step/fast/blocks.hpp"

namespace mpm::fast {
namespace {

/// Blocks of a line of cells are filled in step where so many lanes or more have a particle. A block out of
/// step costs more, one with empty lanes does less: 3 is best with eight lanes, and with four no other number
/// is better (PERFORMANCE.md, "Sorting").
constexpr int least_lanes = 3;

}  // namespace

template <class Real, int axes>
void Blocks<Real, axes>::sort(int rows) {
  const std::vector<std::uint32_t> from = order(rows);
  sort_memory_ = from.size() * sizeof(from[0]);
  permute(from);
  slots_ = {};
}

/// The slot from which each slot is filled, or nobody. Stable: particles of a cell keep their order.
template <class Real, int axes>
std::vector<std::uint32_t> Blocks<Real, axes>::order(int rows) {
  const auto stride = static_cast<std::size_t>(stride_),
             lines_of_row = static_cast<std::size_t>(to_row_) / stride;
  const std::size_t lines = lines_of_row * static_cast<std::size_t>(rows), nodes = stride * lines;
  std::vector<std::uint32_t> particles(nodes, 0);
  for (std::size_t s = 0; s < ids_.size(); ++s)
    if (ids_[s] != nobody) ++particles[node_of(s)];

  struct Group {
    std::uint32_t first, depth;  // slot, blocks
  };
  std::vector<Group> groups(nodes / width);
  std::vector<std::uint32_t> loose_slot(lines);
  bands_.clear();
  loose_ = 0;
  std::uint32_t slot = 0;
  Range band{0, 0, 0, -1};
  for (std::size_t line = 0, g = 0; line < lines; ++line) {
    std::uint32_t loose = 0;
    for (; g < (line + 1) * stride / width; ++g) {
      const std::uint32_t* const in_cell = &particles[g * width];
      const auto lanes = [&](std::uint32_t depth) {
        return std::count_if(in_cell, in_cell + width, [=](std::uint32_t n) { return n > depth; });
      };
      groups[g] = {slot, 0};
      while (lanes(groups[g].depth) >= least_lanes) ++groups[g].depth;
      slot += groups[g].depth * width;
      for (int l = 0; l < width; ++l) loose += in_cell[l] - std::min(in_cell[l], groups[g].depth);
    }
    loose_slot[line] = slot;
    const std::uint32_t loose_blocks = (loose + width - 1) / width;
    slot += loose_blocks * width;
    loose_ += loose_blocks;
    if ((line + 1) % lines_of_row != 0) continue;
    const int row = static_cast<int>(line / lines_of_row), rows_left = rows - 1 - row;
    if ((row - band.first_row + 1 >= band_rows && rows_left >= band_rows) || rows_left == 0) {
      band.count = slot / width - band.first;
      band.last_row = row;
      if (band.count > 0) bands_.push_back(band);
      band = {slot / width, 0, row + 1, -1};
    }
  }

  std::vector<std::uint32_t> from(slot, nobody);
  std::fill(particles.begin(), particles.end(), 0);
  for (std::size_t s = 0; s < ids_.size(); ++s) {
    if (ids_[s] == nobody) continue;
    const std::size_t n = node_of(s);
    const Group& group = groups[n / width];
    const std::uint32_t rank = particles[n]++;
    const std::uint32_t to = rank < group.depth
                                 ? group.first + rank * width + static_cast<std::uint32_t>(n % width)
                                 : loose_slot[n / stride]++;
    from[to] = static_cast<std::uint32_t>(s);
  }
  return from;
}

/// Slot s receives what was in slot from[s]. In place: particles move little between two sorts, so it is
/// enough to remember the last few blocks that were overwritten.
template <class Real, int axes>
void Blocks<Real, axes>::permute(std::span<const std::uint32_t> from) {
  const std::size_t old_blocks = count(), new_blocks = from.size() / width, size = block_size();
  std::size_t remembered = 1;
  for (std::size_t s = 0; s < from.size(); ++s)
    if (from[s] != nobody && from[s] / width < s / width)
      remembered = std::max(remembered, s / width - from[s] / width + 1);
  if (new_blocks * size > values_.size()) {
    AlignedArray<Real> more((new_blocks + new_blocks / 64) * size);
    std::copy_n(values_.data(), old_blocks * size, more.data());
    values_ = std::move(more);
  }
  ids_.resize(std::max(old_blocks, new_blocks) * width, nobody);
  AlignedArray<Real> old(remembered * size);
  std::vector<std::uint32_t> old_ids(remembered * width);
  for (std::size_t b = 0; b < new_blocks; ++b) {
    if (b < old_blocks) {
      std::copy_n(block(b), size, old.data() + b % remembered * size);
      std::copy_n(&ids_[b * width], width, &old_ids[b % remembered * width]);
    }
    const auto values_of = [&](std::size_t q) {
      return q > b ? block(q) : old.data() + q % remembered * size;
    };
    const auto ids_of = [&](std::size_t q) {
      return q > b ? &ids_[q * width] : &old_ids[q % remembered * width];
    };
    const std::uint32_t* const lanes = &from[b * width];
    Real* const to = block(b);
    bool whole = lanes[0] != nobody && lanes[0] % width == 0;
    for (std::uint32_t l = 1; l < width; ++l) whole &= lanes[l] == lanes[0] + l;
    if (whole) {
      if (lanes[0] == b * width) continue;
      std::copy_n(values_of(lanes[0] / width), size, to);
      std::copy_n(ids_of(lanes[0] / width), width, &ids_[b * width]);
      continue;
    }
    bool empty_lanes = false;
    for (std::size_t l = 0; l < width; ++l) {
      if (lanes[l] == nobody) {
        ids_[b * width + l] = nobody;
        empty_lanes = true;
        continue;
      }
      const Real* const source = values_of(lanes[l] / width) + lanes[l] % width;
      for (std::size_t c = 0; c < size; c += width) to[c + l] = source[c];
      ids_[b * width + l] = ids_of(lanes[l] / width)[lanes[l] % width];
    }
    if (empty_lanes) fill_empty_lanes(b);
  }
  ids_.resize(new_blocks * width);
  sort_memory_ += old.size() * sizeof(Real) + old_ids.size() * sizeof(std::uint32_t);
}

/// Lanes without a particle are at rest and unstressed, and in step with the others if those are.
template <class Real, int axes>
void Blocks<Real, axes>::fill_empty_lanes(std::size_t b) {
  Real* const values = block(b);
  const std::uint32_t* const ids = &ids_[b * width];
  const int present =
      static_cast<int>(std::find_if(ids, ids + width, [](auto id) { return id != nobody; }) - ids);
  for (int l = 0; l < width; ++l) {
    if (ids[l] != nobody) continue;
    for (int c = 0; c < columns_; ++c) values[c * width + l] = 0;
    const auto neighbour = node_of_real(values[C::node * width + present]);
    values[C::node * width + l] = real_of_node<Real>(neighbour + l - present);
    if (layout_.gimp)
      for (int a = 0; a < axes; ++a) values[(layout_.half_size() + a) * width + l] = Real(0.5);
  }
}

template class Blocks<double, 2>;
template class Blocks<float, 2>;
template class Blocks<double, 3>;
template class Blocks<float, 3>;

}  // namespace mpm::fast
