#pragma once
/// Curves and points on one pair of axes.
#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "analysis/fit.hpp"
#include "analysis/fit_caption.hpp"
#include "analysis/units.hpp"

namespace analysis {

struct Series {
  std::string label;            ///< in the legend, e.g. value_label(radius, 1.5e-6); empty: not in it
  std::vector<double> x, y;     ///< SI, of one length; rows with a nan are left out
  std::vector<double> y_error;  ///< half widths, SI; empty where none is known
};

struct Plot {
  enum class Kind {
    history,  ///< lines, an error as a shade; legend at the side
    xy,       ///< points with error bars; legend above
  };
  Kind kind = Kind::history;
  std::string title;
  std::string footer;  ///< small, below: catalog hash, physics version
  QuantityLabel x, y;
  std::vector<Series> series;
  /// Drawn with its 95 % band where ok(), its formula under the title; where not, its failure is said there.
  /// SI.
  std::optional<Fit> fit;
  bool y_from_zero = false;           ///< the y axis starts at 0
  bool log_x = false, log_y = false;  ///< axes by their logarithm; numbers that are not positive are left out
};

/// Writes stem.png (1800 x 1200) and stem.svg (900 x 600). Throws std::invalid_argument where there is
/// nothing to draw or columns have unequal lengths, std::runtime_error where gnuplot or the disk fails.
void draw(const Plot&, const std::filesystem::path& stem);

}  // namespace analysis
