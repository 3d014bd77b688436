#pragma once
/// Curves and points on one pair of axes.
#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "analysis/fit.hpp"
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
  bool y_from_zero = false;  ///< the y axis starts at 0
  bool log_axes = false;     ///< both axes by their logarithm; numbers that are not positive are left out
};

/// "Φ = (0.98 ± 0.02) − (0.11 ± 0.01) R;  R in µm;  r² = 0.998;  χ²/ν = 0.4" in the units of the axes. χ²/ν,
/// per degree of freedom, only where the errors of the points are its weights; above 1 it says "lack of fit".
std::string fit_caption(const Fit&, const QuantityLabel& x, const DisplayUnit&, const QuantityLabel& y,
                        const DisplayUnit&);

/// Writes stem.png (1800 x 1200) and stem.svg (900 x 600). Throws std::invalid_argument where there is
/// nothing to draw or columns have unequal lengths, std::runtime_error where gnuplot or the disk fails.
void draw(const Plot&, const std::filesystem::path& stem);

}  // namespace analysis
