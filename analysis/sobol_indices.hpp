#pragma once
/// How much of the variance of a function each of its inputs makes [Sobol 2001].
#include <Eigen/Core>
#include <functional>
#include <vector>

namespace analysis {

struct SobolIndices {
  std::vector<double> first;       ///< share of the variance that the input makes alone
  std::vector<double> total;       ///< ... with all that it does together with others
  double mean = 0, deviation = 0;  ///< of the function
};

/// From two independent samples of the inputs, a row per point: the estimators of [Saltelli et al. 2010,
/// table 2] (first: b; total: f, of Jansen). The function is asked rows * (inputs + 2) times. Empty where it
/// has one value only.
SobolIndices sobol_indices(const std::function<double(const Eigen::VectorXd&)>&, const Eigen::MatrixXd& a,
                           const Eigen::MatrixXd& b);

/// Spearman's rank correlation; ties have the mean of their ranks. 0 where one of the two has one value only.
double rank_correlation(const std::vector<double>& x, const std::vector<double>& y);

}  // namespace analysis
