#pragma once
#include <vector>

#include "analysis/fit.hpp"
#include "runner/catalog/records.hpp"
#include "runner/finish/study_results.hpp"

namespace mpmstudy {

/// Columns of one group of jobs: a quantity against a result. Jobs without the result are left out.
struct Column {
  std::vector<double> x, y;
  std::vector<double> y_error;  ///< half widths, 0 where none is known; empty if none is known at all
};
Column column_of(const StudyResults&, const Group&, const std::string& x, const std::string& y);

/// Values for cells of size 0 stand on the finest cell alone: no fit is made of a group without any, and none
/// is missed.
bool stands_elsewhere(const Group&, const std::string& y);

/// The curve through a column. Where every point has an interval, points weigh 1 / half width^2, and half
/// widths are taken as standard deviations: standard errors are then no smaller than what the bars beside the
/// curve leave open. Otherwise they weigh the same.
analysis::Fit fit_column(const FitRequest&, const Column&);

/// Every [[fit]] of the study. Rows go coefficient by coefficient, in SI. Where the study sweeps more than
/// the fit's x, one fit per group, and `model` names the group: "quadratic, h = 0.1 um". A fit that cannot be
/// made is in `not_made`, a line each; what is to be said of one that is made (its points are off the curve
/// by more than their intervals) is in `notes`.
struct Fits {
  std::vector<FitRow> rows;
  std::vector<std::string> not_made, notes;
};
Fits fit_study(const Study&, const StudyResults&);

}  // namespace mpmstudy
