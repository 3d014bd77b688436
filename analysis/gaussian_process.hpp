#pragma once
/// A surface through numbers that have intervals: a Gaussian process (kriging) with a constant mean and a
/// Matern kernel of 5/2 with one length for each input [Rasmussen, Williams 2006, ch. 4, 5].
#include <Eigen/Core>
#include <cmath>
#include <optional>
#include <span>
#include <string>
#include <vector>

namespace analysis {

/// Half width of a 95 % interval over the standard deviation.
inline constexpr double half_width_95 = 1.959963984540054;

struct ValueWithDeviation {
  double value = 0, deviation = 0;  ///< of the curve itself, without the scatter of single runs
};

/// How well a surface says a run that it has not seen: every run from all others, with the surface's own
/// lengths [Dubrule 1983].
struct CrossValidation {
  double rms = 0;            ///< of the errors, unit of the values
  std::optional<double> q2;  ///< 1 - their squares / those about the mean; empty where all values are equal
  double covered = 0;  ///< share of the runs within the surface's 95 % interval for a run, its noise included
};

class GaussianProcess {
 public:
  /// `inputs`: a row per run. `deviations`: of the values, 0 where none is known; empty: none is known at
  /// all. On top of them all runs have one scatter, which is found with the lengths: those that make the data
  /// most likely. What it does follows from its arguments alone. Where there is no surface, `failure` says
  /// why: fewer than three runs per input, an input with one value, numbers that are not finite.
  GaussianProcess(const Eigen::MatrixXd& inputs, std::span<const double> values,
                  std::span<const double> deviations = {});

  const std::string& failure() const { return failure_; }
  bool ok() const { return failure_.empty(); }

  ValueWithDeviation at(const Eigen::VectorXd& input) const;
  /// Covariance of the curve's values at places, a row each, as the runs leave it [unit of the values,
  /// squared].
  Eigen::MatrixXd covariance(const Eigen::MatrixXd& places) const;
  const CrossValidation& cross_validation() const { return cross_validation_; }
  /// What each run is off the surface through all others, over the standard deviation that this has of it.
  std::vector<double> left_out_scores() const;
  /// How far off runs about a place are, left out, against what the surface says of them: 1 as it says, more
  /// where it is too sure of itself. Mean of the squares, over as many runs about as a run has neighbours.
  double surprise(const Eigen::VectorXd& place) const;
  /// Standard deviation of a run from the curve: scatter and, on average, its own [unit of the values].
  double run_deviation() const { return std::sqrt(scatter_ + noise_.mean()) * scale_; }
  /// In the unit of the input: how far one has to go for another value.
  Eigen::VectorXd lengths() const { return lengths_.cwiseProduct(width_); }
  double scatter() const { return std::sqrt(scatter_) * scale_; }  ///< standard deviation, unit of the values

  /// One surface out of all that the runs allow, each as likely as the process has it [Wilson et al. 2020]:
  /// its differences from at().value are what the runs leave open.
  class Path {
   public:
    double operator()(const Eigen::VectorXd& input) const;

   private:
    friend class GaussianProcess;
    const GaussianProcess* of_ = nullptr;
    Eigen::MatrixXd frequencies_;  ///< a row each
    Eigen::VectorXd phases_, weights_, update_;
    double amplitude_ = 0, mean_ = 0;
  };
  /// `normal`: independent numbers of the standard normal distribution; `uniform`: of [0, 1).
  template <class Normal, class Uniform>
  Path path(Normal normal, Uniform uniform) const;

 private:
  struct Likelihood;
  Eigen::VectorXd scaled(const Eigen::VectorXd& input) const { return (input - low_).cwiseQuotient(width_); }
  double kernel(const Eigen::VectorXd& a, const Eigen::VectorXd& b) const;
  void find_lengths();
  void solve();
  Path finish(Path) const;

  std::string failure_;
  Eigen::MatrixXd x_;              ///< a row per run, each input from 0 to 1
  Eigen::VectorXd low_, width_;    ///< of the inputs
  Eigen::VectorXd y_, noise_;      ///< mean 0, deviation 1; variances in that unit
  double offset_ = 0, scale_ = 1;  ///< of the values
  Eigen::VectorXd lengths_;        ///< of scaled inputs
  double variance_ = 1, scatter_ = 0, mean_ = 0;
  Eigen::MatrixXd factor_;           ///< L, covariance of the runs = L L^T
  Eigen::VectorXd weights_;          ///< covariance^-1 (y - mean)
  Eigen::VectorXd one_;              ///< covariance^-1 1
  Eigen::VectorXd left_out_scores_;  ///< error of each run over its standard deviation
  double neighbour_ = 1;             ///< distance of a run from the next one, in lengths, on average
  CrossValidation cross_validation_;
};

template <class Normal, class Uniform>
GaussianProcess::Path GaussianProcess::path(Normal normal, Uniform uniform) const {
  constexpr Eigen::Index features = 256;
  Path path;
  path.of_ = this;
  path.frequencies_.resize(features, x_.cols());
  path.phases_.resize(features);
  path.weights_.resize(features);
  for (Eigen::Index k = 0; k < features; ++k) {
    // The spectrum of a Matern kernel of 5/2 is a t distribution of 5 degrees of freedom.
    double square = 0;
    for (int i = 0; i < 5; ++i) {
      const double z = normal();
      square += z * z;
    }
    for (Eigen::Index i = 0; i < x_.cols(); ++i)
      path.frequencies_(k, i) = normal() * std::sqrt(5 / square) / lengths_(i);
    path.phases_(k) = 6.283185307179586 * uniform();
    path.weights_(k) = normal();
  }
  path.amplitude_ = std::sqrt(2 * variance_ / features);
  path.mean_ = mean_ + normal() / std::sqrt(one_.sum());
  path.update_.resize(x_.rows());
  for (Eigen::Index i = 0; i < x_.rows(); ++i)
    path.update_(i) = std::sqrt(noise_(i) + scatter_) * normal();  // the noise of this draw, until finish()
  return finish(std::move(path));
}

}  // namespace analysis
