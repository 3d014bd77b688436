#pragma once
/// From a ladder of cells to the number at cell 0 and how well it is known.
///
/// Sources: P. J. Roache, Perspective: a method for uniform reporting of grid refinement studies, J. Fluids
/// Eng. 116 (1994) 405, and Verification and Validation in Computational Science and Engineering (1998), for
/// the extrapolation and the safety factors 1.25 and 3; L. Eca, M. Hoekstra, J. Comput. Phys. 262 (2014) 104,
/// for the fall back on a fixed order where the observed one is not clean; ASME V&V 20-2009 for adding the
/// parts.
#include <limits>
#include <optional>
#include <span>
#include <string_view>

namespace analysis {

/// One number measured with one cell.
struct LadderPoint {
  double cell = 0;  ///< > 0; any unit
  double value = 0;
  double measuring_error = 0;  ///< half width of what its measurement leaves open, >= 0; unit of the value
};

/// How an interval came about.
enum class LadderMethod {
  observed_order,  ///< the value moves one way, with an order that theory allows
  first_order,     ///< the value moves one way, but its order is not clean, or two cells cannot show one
  spread,          ///< the value turns: its spread is all that is known
  one_cell,        ///< nothing but the caller's estimate is known
};
/// "observed order", "first order", "spread", "one cell".
std::string_view name(LadderMethod);

/// What the quantity can be at all: a share is at most 1, an area at least 0.
struct Bounds {
  double lower = -std::numeric_limits<double>::infinity();
  double upper = std::numeric_limits<double>::infinity();
};

/// The value at cell 0, and two intervals that it lies in. All in the unit of the value.
struct Extrapolation {
  LadderMethod method = LadderMethod::one_cell;
  int cells = 0;
  double value = 0;                      ///< at the finest cell
  double extrapolated_value = 0;         ///< best estimate at cell 0
  std::optional<double> observed_order;  ///< also where it is not clean
  double discretisation_error = 0;       ///< half width about `value`, from the cells alone
  double measuring_error = 0;            ///< the largest of the three finest cells
  double error = 0;                      ///< half width about `value`, both parts
  double extrapolated_error = 0;         ///< half width about `extrapolated_value`, both parts
};

/// Points in any order, each with its own cell; at least one. `one_cell_error`: half width that a single cell
/// gets.
///
/// The differences between the three finest cells give the observed order p of value = v0 + a cell^p. If it
/// is in [0.5, 2.5], v0 is the extrapolated value. If it is not, the extrapolated value is the one of order
/// 1: the straight line through two cells, or by least squares through up to the four finest. If the
/// differences change sign, it is the value of the finest cell.
///
/// U, the half width about the extrapolated value that the cells leave open: half of the way to it from the
/// finest cell, and no less than its distance from the straight line's; the whole way, and no less than the
/// last difference, where the order is not clean; 1.25 times the spread of the three finest cells where the
/// value turns. (Roache's 1.25 about the finest value is a quarter of the way beyond the extrapolated one;
/// that way is halved here because three cells a factor sqrt(2) apart show their order less well.
/// studies/examples/error-bars.toml measures how often these intervals hold.) The measuring error is added in
/// quadrature, as independent; an interval ends at the bounds. Affine: a value in other units gives the same
/// interval in those.
Extrapolation extrapolate(std::span<const LadderPoint>, const Bounds& = {}, double one_cell_error = 0);

}  // namespace analysis
