#pragma once
#include <cstdint>
#include <span>
#include <vector>

#include "libmpm/core/archive.hpp"
#include "libmpm/core/grid.hpp"
#include "libmpm/core/particles.hpp"
#include "libmpm/step/fast/aligned_array.hpp"
#include "libmpm/step/fast/kernels.hpp"

namespace mpm::fast {

/// Of the particle that fills a cell at rest; in axisymmetry, a cell at the distance of a cell from the axis
/// [kg/m, per radian kg, of three axes kg].
template <int axes>
double unit_mass(double rho0, const BasicGrid<axes>& grid, Space space) {
  const Vec<axes>& h = grid.cell();
  return rho0 * h.prod() * (space == Space::axisymmetric ? h.x() : 1);
}

/// The particles in blocks of `width` lanes: all columns of a block side by side, so that a pass over the
/// particles is one stream through memory.
///
///   nodes of a row     o     o     o     o     o     o     o     o     o
///   nearest to one       a b   c d   e f   g h   ...      particles of a group of four cells (width 4)
///   block k            [ a     c     e     g   ]          lane l: the k-th particle of the l-th cell
///   block k + 1        [ b     d     f     h   ]
///   one block in memory: [node x4][position along x x4][position along y x4][velocity x4] ... one pack per
///   column
///
/// After a sort most blocks are in step with the grid (transfer.hpp): the cells of a line along x,
/// counted by the nearest node, are taken in groups of `width` neighbours, and the k-th block of a group
/// holds the k-th particle of each of its cells, lane by lane. Lanes of cells that have no k-th particle are
/// empty. Where too few lanes would be filled, the particles go to blocks at the end of their line that are
/// filled in the order of the cells and are not in step.
template <class Real, int axes>
class Blocks {
 public:
  static constexpr int width = 32 / sizeof(Real);
  using Particles = BasicParticles<axes>;
  using Grid = BasicGrid<axes>;

  /// The particles of `range`, not sorted yet. Columns of the layout's model: `own`. rho0: of unit_mass().
  Blocks(Particles&, typename Particles::Range range, std::span<const StateColumn> own, const Grid&,
         const Layout&, double rho0, const Nodes<Real, axes>&);

  /// Puts the particles in order, for a grid of `rows` rows of nodes. Deterministic.
  void sort(int rows);

  /// Blocks whose particles lie in rows that no other band has. Neighbouring bands are at least `band_rows`
  /// rows high, and the order of their work is all that a result depends on.
  struct Range {
    std::size_t first, count;
    int first_row, last_row;
  };
  static constexpr int band_rows = axes == 3 ? 6 : 8;
  std::span<const Range> bands() const { return bands_; }

  Real* block(std::size_t b) { return values_.data() + b * block_size(); }
  std::size_t count() const { return ids_.size() / width; }
  std::size_t loose() const { return loose_; }  ///< blocks that are not in step by intention

  void copy_to(Particles&, const Grid&) const;
  void copy_to(Particles&, const Grid&, std::span<const std::size_t> which);
  void carry(Archive&);
  std::size_t memory() const;  ///< with what the last sort needed [bytes]

 private:
  using C = Columns<axes>;
  static constexpr std::uint32_t nobody = UINT32_MAX;

  std::size_t block_size() const { return static_cast<std::size_t>(columns_) * width; }
  Real& at(std::size_t slot, int column) { return block(slot / width)[column * width + slot % width]; }
  Real at(std::size_t slot, int column) const {
    return values_[slot / width * block_size() + static_cast<std::size_t>(column) * width + slot % width];
  }
  std::size_t node_of(std::size_t slot) const {
    return static_cast<std::size_t>(node_of_real(at(slot, C::node)));
  }
  void write(std::size_t slot, const Grid&, Particles&, const OwnNumbers&) const;
  std::vector<std::uint32_t> order(int rows);
  void permute(std::span<const std::uint32_t> order);
  void fill_empty_lanes(std::size_t block);

  Layout layout_;
  typename Particles::Range range_;
  std::span<const StateColumn> own_;
  int columns_, stride_, to_row_;     ///< of a block; of the nodes
  AlignedArray<Real> values_;         ///< may be larger than its blocks
  std::vector<std::uint32_t> ids_;    ///< original place of the particle in each slot, or nobody
  std::vector<std::uint32_t> slots_;  ///< of the particles of the range; empty until one is asked for
  std::vector<Range> bands_;
  std::size_t loose_ = 0, sort_memory_ = 0;
};

}  // namespace mpm::fast
