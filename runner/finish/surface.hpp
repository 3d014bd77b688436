#pragma once
/// A surface through a result of a study, over all quantities that the study sweeps: what predict and
/// sensitivity ask.
#include <functional>
#include <map>
#include <string>
#include <vector>

#include "analysis/gaussian_process.hpp"
#include "runner/finish/study_results.hpp"
#include "runner/study/study.hpp"

namespace mpmstudy {

/// Swept quantities of which the jobs have more than one value, in the order of the file.
std::vector<std::string> surface_inputs(const Study&, const StudyResults&);
/// Swept words, such as material: a surface is of one of each.
std::vector<std::string> swept_words(const Study&);

struct ResultSurface {
  std::string result, unit;         ///< SI
  std::vector<std::string> inputs;  ///< columns of the process
  std::vector<double> low, high;    ///< of the runs, SI
  std::vector<double> values;       ///< of the runs
  Eigen::MatrixXd points;           ///< a row per run
  analysis::GaussianProcess process;
};

/// Of the done jobs with these words (swept word -> value). The half width of a job's interval counts as its
/// standard deviation, as in fits. Throws StudyError with what is missing: words, runs, a result.
ResultSurface surface_of(const Study&, const StudyResults&, const std::string& result,
                         const std::map<std::string, std::string>& words);

/// An estimate with the 2.5 % and 97.5 % points of what the runs leave open.
struct Estimate {
  double value = 0, low = 0, high = 0;
};
/// What a result is on average where one input has a value and all others are drawn.
struct MainEffect {
  std::vector<double> inputs;     ///< SI, ascending
  std::vector<Estimate> results;  ///< at each, in the unit of the result
};
struct Sensitivity {
  std::vector<Estimate> first, total;  ///< Sobol indices of each input
  std::vector<MainEffect> effects;     ///< of each input
  Estimate mean, deviation;            ///< of the result, its inputs drawn
};
/// Of surfaces drawn from the process [Marrel et al. 2009], each with a Sobol sequence of its own. Intervals
/// hold what the runs leave open and the error of the sums, and are wider by the share of the variance that
/// runs left out show to be unexplained (1 - Q2): whose it is, is not known. `at`: the value of each input
/// below which a share of it lies. Main effects are at nine values of each, of equal shares between its 2 %
/// and its 98 % point. The same on every machine but for rounding.
Sensitivity sensitivity_of(const analysis::GaussianProcess&,
                           const std::vector<std::function<double(double)>>& at);

}  // namespace mpmstudy
