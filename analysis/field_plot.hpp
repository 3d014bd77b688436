#pragma once
/// Snapshots of particles side by side, with one scale of colours.
#include <filesystem>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "analysis/raster.hpp"
#include "analysis/units.hpp"

namespace analysis {

enum class Palette {
  viridis,  ///< perceptually uniform, safe for colour-blind readers
  grey,     ///< for print: from black (least) to white (most), in units of fixed_unit()
};

struct FieldPanel {
  std::string title;  ///< "t = 1.62 ns": value_label() of the time
  ParticleSquares particles;
};

struct FieldPlot {
  std::string title;
  std::string footer;
  QuantityLabel value;                 ///< of ParticleSquares::value
  std::string across = "x", up = "y";  ///< the axes of space along those of the panels
  bool mirrored = false;               ///< x >= 0 was modelled: show the other half too
  Palette palette = Palette::viridis;
  std::vector<FieldPanel> panels;
  std::optional<Window> window;  ///< what every panel shows; else window_of() them all
  std::optional<std::pair<double, double>>
      range;  ///< of the colours, SI; else what 99 % of all particles lie in, 99.9 % of what begins at zero
};

/// Writes stem.png and stem.svg: one panel per snapshot, up to three in a row, all of one scale of length
/// (both axes alike, a bar of a round length in the first) and colour; a line between materials. Throws
/// std::invalid_argument where there is nothing to draw or columns have unequal lengths, std::runtime_error
/// where gnuplot or the disk fails.
void draw(const FieldPlot&, const std::filesystem::path& stem);

}  // namespace analysis
