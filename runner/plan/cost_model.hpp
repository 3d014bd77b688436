#pragma once
/// What jobs will cost, learnt from what jobs of this host have cost. Pure.
///
/// Model: log(cpu_s / (particles steps cost)) = a + b log(particles) + c log(steps) + s + e, over predicted
/// particles and steps, so that jobs that end early are part of the scatter; cost:
/// mpm::Estimate::update_cost; s: the same for all jobs of a study, e: of each job. b and c are held near 0
/// (0 +- 0.2, a Gaussian prior): few jobs, or jobs of one size, say little about them. Variances of s and e
/// by the method of moments; with fewer than four studies those cannot be told apart, and all scatter counts
/// as common to the jobs of a study. Checked by tests/runner/plan/cost_model_test.cpp.
#include <Eigen/Core>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "libmpm/scene/scene.hpp"

namespace mpmstudy {

/// What one core is taken to do until the catalog has seen jobs of this host [particle updates/s]: studies of
/// ten thousand particles make 15 to 30 million (view `jobs`, particle_updates_per_s).
inline constexpr double assumed_updates_per_second = 2e7;

/// A job that is done.
struct CostSample {
  double particles = 0, steps = 0;  ///< as they were predicted
  double cpu_s = 0;                 ///< [s]
  std::string study;
  double update_cost = 1;  ///< mpm::Estimate::update_cost
};

/// Processor time [s], with its 95 % interval; without one if nothing is known.
struct Prediction {
  double seconds = 0;
  struct Interval {
    double low = 0, high = 0;
  };
  std::optional<Interval> interval;
};

class CostModel {
 public:
  /// A guess.
  CostModel(double updates_per_second = assumed_updates_per_second);
  /// Samples that took no time are left out; where none is left, the guess.
  explicit CostModel(std::span<const CostSample>);

  /// Expected, of one job [s].
  double seconds(const mpm::Estimate&) const;
  /// Of jobs of one study together.
  Prediction total(std::span<const mpm::Estimate>) const;
  /// How many jobs it is learnt from; 0: it is a guess.
  std::size_t learnt_from() const { return count_; }

 private:
  void fit(const Eigen::MatrixX3d& x, const Eigen::VectorXd& y);
  void split_scatter(const Eigen::VectorXd& residual, std::span<const std::string> studies);
  Eigen::Vector3d features(double particles, double steps) const;

  std::size_t count_ = 0;
  double log_particles_ = 0, log_steps_ = 0;                ///< means over the samples
  Eigen::Vector3d coefficients_ = Eigen::Vector3d::Zero();  ///< a, b, c
  Eigen::Matrix3d covariance_ = Eigen::Matrix3d::Zero();    ///< of them
  double common_variance_ = 0, own_variance_ = 0;           ///< of s and e
  int degrees_of_freedom_ = 0;                              ///< of common_variance_; 0: no interval
};

}  // namespace mpmstudy
