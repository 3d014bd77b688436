// Order of convergence on manufactured solutions: neo-Hookean bodies under body forces, by the library's p2g,
// grid update and g2p.
//
// Small amplitudes: second order with either shape function. Large ones, 16 % of strain: the particles of
// quadratic B-splines no longer tile the body as they move through the cells, and the quadrature error that
// this leaves [Steffen2008] stops the convergence near 1 %; it does not come from FLIP's transfer, since
// neither a blend with PIC nor smaller steps change it. Domains that follow the stretch go on tiling.
#include <gtest/gtest.h>

#include "libmpm/shape/bspline2.hpp"
#include "libmpm/shape/bspline3.hpp"
#include "libmpm/shape/cpdi.hpp"
#include "libmpm/shape/gimp.hpp"
#include "tests/verification/manufactured_solution.hpp"

namespace {

using manufactured::axis_aligned;
using manufactured::vortex;

double order(double coarse, double fine) { return std::log2(coarse / fine); }

TEST(Convergence, AxisAlignedSmallStrain) {
  const double coarse = axis_aligned<mpm::BSpline2>({16, 2, 0.4, 0.001});
  const double fine = axis_aligned<mpm::BSpline2>({32, 2, 0.4, 0.001});
  EXPECT_GT(order(coarse, fine), 1.8);
  EXPECT_LT(fine, 0.014);
  EXPECT_GT(order(axis_aligned<mpm::Gimp>({16, 2, 0.4, 0.001}), axis_aligned<mpm::Gimp>({32, 2, 0.4, 0.001})),
            1.8);
}

/// Errors with 16, 32 and 64 cells must fall in second order.
template <class Shape>
void expect_second_order(int side, double finest) {
  const double coarse = axis_aligned<Shape>({16, side, 0.4, 0.05});
  const double middle = axis_aligned<Shape>({32, side, 0.4, 0.05});
  const double fine = axis_aligned<Shape>({64, side, 0.4, 0.05});
  EXPECT_GT(order(coarse, middle), 1.8);
  EXPECT_GT(order(middle, fine), 1.8);
  EXPECT_LT(fine, finest);
}

// The quadrature error is what stops the quadratic B-spline: the smoother cubic one goes on, and so do
// domains that tile, even one to a cell, where Gimp, whose domains cannot grow beyond a cell, goes astray.
TEST(Convergence, AxisAlignedLargeStrainWithCubicBSplines) { expect_second_order<mpm::BSpline3>(2, 0.0045); }
TEST(Convergence, AxisAlignedLargeStrainWithOneParallelogramACell) {
  expect_second_order<mpm::Cpdi>(1, 0.0042);
}

TEST(Convergence, AxisAlignedLargeStrainWithTilingDomains) {
  const double coarse = axis_aligned<mpm::Gimp>({16, 2, 0.4, 0.05});
  const double middle = axis_aligned<mpm::Gimp>({32, 2, 0.4, 0.05});
  const double fine = axis_aligned<mpm::Gimp>({64, 2, 0.4, 0.05});
  EXPECT_GT(order(coarse, middle), 1.8);
  EXPECT_GT(order(middle, fine), 1.8);
  EXPECT_LT(fine, 0.0025);
}

// The default of cavities and shells as it is: this pins where it stops, so that a better scheme shows.
TEST(Convergence, AxisAlignedLargeStrainWithBSplinesStopsNearOnePercent) {
  const double coarse = axis_aligned<mpm::BSpline2>({16, 2, 0.4, 0.05});
  const double fine = axis_aligned<mpm::BSpline2>({32, 2, 0.4, 0.05});
  EXPECT_GT(order(coarse, fine), 1.8);
  EXPECT_LT(axis_aligned<mpm::BSpline2>({64, 2, 0.4, 0.05}), 0.007);
}

TEST(Convergence, Vortex) {
  const double coarse = vortex<mpm::BSpline2>({16, 3, 0.4, 0.05});
  const double fine = vortex<mpm::BSpline2>({32, 3, 0.4, 0.05});
  EXPECT_GT(order(coarse, fine), 1.8);
  EXPECT_LT(fine, 0.02);
}

}  // namespace
