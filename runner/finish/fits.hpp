#pragma once
#include <vector>

#include "analysis/fit.hpp"
#include "runner/catalog/records.hpp"
#include "runner/finish/study_results.hpp"

namespace mpmstudy {

/// Columns of one group of jobs: a quantity against a result. Jobs without the result are left out.
struct Column {
  std::vector<double> x, y;
  std::vector<double> y_error;  ///< empty unless every point has an error above 0
};
Column column_of(const StudyResults&, const Group&, const std::string& x, const std::string& y);

/// The curve through a column. Points weigh the same: errors of a collapse (scatter of the ring-down,
/// difference of measures) are no standard deviations about the curve, and as weights would let the quietest
/// runs decide. Critical values for cells of size 0 are the exception: what is not known of them is how far
/// the extrapolation went, which differs tenfold from point to point, so they weigh 1 / interval^2.
analysis::Fit fit_column(const FitRequest&, const Column&);

/// Every [[fit]] of the study. Rows go coefficient by coefficient, in SI. Where the study sweeps more than
/// the fit's x, one fit a group, and `model` carries the group: "quadratic, h = 0.1 um". A fit that cannot be
/// made is in `problems`, a line each.
struct Fits {
  std::vector<FitRow> rows;
  std::vector<std::string> problems;
};
Fits fit_study(const Study&, const StudyResults&);

}  // namespace mpmstudy
