#include "libmpm/scene/kinds/cavity.hpp"

#include <algorithm>
#include <charconv>
#include <cmath>
#include <limits>
#include <numbers>

namespace mpm::with_cavity {
namespace {

/// a - b - c, which has the rounding of its terms: of the numbers that it may stand for, the one with the
/// fewest digits. A wall that was written as 1 um is 1e-06, not 9.999999999999995e-07.
double rounded_difference(double a, double b, double c) {
  const double difference = a - b - c;
  const double doubt =
      2 * std::numeric_limits<double>::epsilon() * std::max({std::abs(a), std::abs(b), std::abs(c)});
  if (std::abs(difference) <= doubt) return 0;
  for (int digits = 0; digits < std::numeric_limits<double>::max_digits10; ++digits) {
    char text[32];
    const auto end =
        std::to_chars(text, text + sizeof text, difference, std::chars_format::scientific, digits).ptr;
    double rounded = difference;
    std::from_chars(text, end, rounded);
    if (std::abs(rounded - difference) <= doubt) return rounded;
  }
  return difference;  // not finite
}

}  // namespace

double wall_thickness(const Scene& s) {
  return rounded_difference(s.block_height, s.cavity_center_height, s.cavity_radius);
}

/// The edge of a cavity needs more particles than a planar shock, and the smaller viscosity moves the
/// collapse less: measured by tests/verification.
void set_default_numerics(Numerics& n) {
  n.scheme = ShapeFunction::bspline2;
  n.particles_per_cell = 4;
  n.linear_viscosity = 0.5;
}

void check(const Scene& s, Report& report) {
  with_block::check(s, report);
  const double r = s.cavity_radius, y = s.cavity_center_height;
  report.require(2 * r < s.block_width, "cavity_radius",
                 "less than half of block_width (" + text_of(s.block_width / 2) +
                     " m): the cavity is as wide as the block");
  report.require(s.numerics.cell_size <= r, "cell_size",
                 "at most cavity_radius (" + text_of(r) + " m): the cavity is smaller than a cell");
  // Rounding is allowed for: a centre that is computed from a wall thickness may miss tangency by it.
  const double slack = 4 * std::numeric_limits<double>::epsilon() * s.block_height;
  report.require(y - r >= -slack, "cavity_center_height",
                 "at least cavity_radius (" + text_of(r) + " m): the cavity leaves the block below");
  report.require(y + r <= s.block_height + slack, "cavity_center_height",
                 "at most block_height - cavity_radius (" + text_of(s.block_height - r) +
                     " m): the cavity leaves the block above");
}

template <int axes>
double hole(const Scene& s, const BasicLattice<axes>& l) {
  const double circle = std::numbers::pi * s.cavity_radius * s.cavity_radius,
               modelled = l.width / s.block_width;
  return axes == 2 ? circle * modelled : 4 * s.cavity_radius / 3 * circle * (modelled * modelled);
}

double coarsest_cell(const Scene& s) {
  return std::min({s.cavity_radius / 4, s.block_width / 8, s.block_height / 8});
}

std::vector<Part> parts(const Scene& s) {
  const double r = s.cavity_radius, y = s.cavity_center_height;
  return {{"the wall above the cavity", "wall_thickness", s.block_height - y - r},
          {"the wall below the cavity", "cavity_center_height", y - r},
          {"the wall between the cavity and its mirror image", "block_width", s.block_width - 2 * r},
          {"the cavity", "cavity_radius", 2 * r}};
}

template <int axes>
BasicMeasurements<axes> measurements(const Scene& s, const BasicState<axes>& state, bool open_below) {
  BasicMeasurements<axes> all;
  all.push_back(std::make_unique<BasicCavity<axes>>(s, state, open_below));
  if (s.measures.decides == Decides::ejection) all.push_back(std::make_unique<BasicEjection<axes>>(s, state));
  return all;
}

template double hole(const Scene&, const Lattice&);
template double hole(const Scene&, const BasicLattice<3>&);
template BasicMeasurements<2> measurements(const Scene&, const State&, bool);
template BasicMeasurements<3> measurements(const Scene&, const BasicState<3>&, bool);

}  // namespace mpm::with_cavity
