#pragma once
#include <cstdint>
#include <span>
#include <vector>

#include "libmpm/core/grid.hpp"
#include "libmpm/core/particles.hpp"
#include "libmpm/step/fast/aligned_array.hpp"
#include "libmpm/step/fast/kernels.hpp"

namespace mpm::fast {

/// The particles in blocks of `width`: all columns of a block side by side, so that a pass over the particles
/// is one stream through memory. They are kept in the order of the cells; `id` knows their original place.
/// The last block is filled up with copies of the last particle that have no mass: they follow it and change
/// nothing.
template <class Real>
class Blocks {
 public:
  static constexpr int width = 32 / sizeof(Real);

  Blocks(const Particles&, const Grid&, const Variant&, double rho0);

  Real* data() { return values_.data(); }
  const Real* data() const { return values_.data(); }
  std::size_t count() const { return ids_.size() / width; }

  /// Sorts by the node nearest to a particle, row by row; a stable counting sort.
  void sort(int stride);

  void copy_to(Particles&, const Grid&) const;
  void copy_to(Particles&, const Grid&, std::span<const std::size_t> which);
  std::size_t memory() const;  ///< [bytes]

 private:
  Real& at(std::size_t slot, int column) {
    return values_[(slot / width * columns_ + column) * width + slot % width];
  }
  Real at(std::size_t slot, int column) const {
    return values_[(slot / width * columns_ + column) * width + slot % width];
  }
  void write(std::size_t slot, const Grid&, Particles&, std::size_t p) const;
  void permute(std::span<const std::uint32_t> order);

  Variant variant_;
  int columns_;
  std::size_t particles_;
  AlignedArray<Real> values_;
  std::vector<std::uint32_t> ids_;    ///< original place of each slot; >= particles_: no particle
  std::vector<std::uint32_t> slots_;  ///< the inverse; empty until somebody asks for single particles
  std::vector<std::uint32_t> order_;
  AlignedArray<Real> moved_;  ///< four columns on their way to their new slots
};

}  // namespace mpm::fast
