#pragma once
#include <optional>
#include <string>

namespace mpmstudy {

/// The cells under every job of a study ([numerics] ladder, accuracy, accuracy_of).
///
/// Without an accuracy every job runs at `cells` cells, of which the study's own is the finest. With one, a
/// job starts at its coarsest cells and gets finer ones, up to `cells` of them, until the interval of
/// `quantity` is inside.
struct LadderRequest {
  int cells = 1;                   ///< how many; with an accuracy: at most
  std::optional<double> accuracy;  ///< wanted half width of the interval over the quantity's scale [1]
  std::string quantity;            ///< whose interval it is: "collapsibility"
  bool finds_cell = false;  ///< the file gives no cell_size: scenes hold the coarsest cell, else the finest
  std::string unit = "1";   ///< SI, where `quantity` is in no table (of a gauge)
};

}  // namespace mpmstudy
