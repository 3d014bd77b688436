#include "runner/plan/cost_model.hpp"

#include <Eigen/LU>
#include <algorithm>
#include <cmath>
#include <map>

#include "analysis/student_t.hpp"

namespace mpmstudy {
namespace {

constexpr double prior_slope = 0.2;  ///< standard deviation of b and c
constexpr double probability = 0.95;
constexpr std::size_t least_jobs = 3, least_studies = 4;  ///< for an interval; for telling studies apart

}  // namespace

CostModel::CostModel(double updates_per_second) { coefficients_[0] = -std::log(updates_per_second); }

CostModel::CostModel(std::span<const CostSample> all) : CostModel() {
  std::vector<CostSample> samples;
  for (const CostSample& s : all)
    if (s.cpu_s > 0 && s.particles > 0 && s.steps > 0) samples.push_back(s);
  if (samples.empty()) return;
  count_ = samples.size();
  const auto n = static_cast<double>(count_);
  for (const CostSample& s : samples) {
    log_particles_ += std::log(s.particles) / n;
    log_steps_ += std::log(s.steps) / n;
  }
  Eigen::MatrixX3d x(samples.size(), 3);
  Eigen::VectorXd y(samples.size());
  std::vector<std::string> studies;
  for (std::size_t i = 0; i < samples.size(); ++i) {
    const CostSample& s = samples[i];
    x.row(static_cast<Eigen::Index>(i)) = features(s.particles, s.steps).transpose();
    y[static_cast<Eigen::Index>(i)] = std::log(s.cpu_s / (s.particles * s.steps * s.update_cost));
    studies.push_back(s.study);
  }
  fit(x, y);
  split_scatter(y - x * coefficients_, studies);
}

Eigen::Vector3d CostModel::features(double particles, double steps) const {
  return {1, std::log(particles) - log_particles_, std::log(steps) - log_steps_};
}

/// Least squares with the prior. How strong that is depends on the scatter, so twice.
void CostModel::fit(const Eigen::MatrixX3d& x, const Eigen::VectorXd& y) {
  coefficients_ = {y.mean(), 0, 0};
  for (int pass = 0; pass < 2; ++pass) {
    const double variance =
        (y - x * coefficients_).squaredNorm() / std::max<double>(1, static_cast<double>(y.size()) - 1);
    const double ridge = std::max(variance, 1e-6) / (prior_slope * prior_slope);
    const Eigen::Matrix3d normal =
        x.transpose() * x + Eigen::Matrix3d(Eigen::Vector3d(0, ridge, ridge).asDiagonal());
    const Eigen::Matrix3d inverse = normal.inverse();
    coefficients_ = inverse * (x.transpose() * y);
    covariance_ = variance * inverse;
  }
}

void CostModel::split_scatter(const Eigen::VectorXd& residual, std::span<const std::string> studies) {
  if (count_ < least_jobs) return;
  struct Group {
    double count = 0, sum = 0;
  };
  std::map<std::string, Group> groups;
  for (std::size_t i = 0; i < studies.size(); ++i) {
    Group& group = groups[studies[i]];
    ++group.count;
    group.sum += residual[static_cast<Eigen::Index>(i)];
  }
  const auto n = static_cast<double>(count_), k = static_cast<double>(groups.size());
  if (groups.size() < least_studies || groups.size() == count_) {
    common_variance_ = residual.squaredNorm() / (n - 1);
    degrees_of_freedom_ = static_cast<int>(count_) - 1;
    return;
  }
  double between = 0, within = 0, squares = 0;
  for (const auto& [name, group] : groups) {
    between += group.sum * group.sum / group.count;
    squares += group.count * group.count;
  }
  for (std::size_t i = 0; i < studies.size(); ++i) {
    const Group& group = groups[studies[i]];
    within += std::pow(residual[static_cast<Eigen::Index>(i)] - group.sum / group.count, 2);
  }
  own_variance_ = within / (n - k);
  common_variance_ = std::max(0.0, (between / (k - 1) - own_variance_) / ((n - squares / n) / (k - 1)));
  degrees_of_freedom_ = static_cast<int>(groups.size()) - 1;
}

double CostModel::seconds(const mpm::Estimate& estimate) const {
  const auto particles = static_cast<double>(estimate.particles), steps = static_cast<double>(estimate.steps);
  if (particles <= 0 || steps <= 0) return 0;
  // The mean of a lognormal variable: studies are sums.
  return particles * steps * estimate.update_cost *
         std::exp(features(particles, steps).dot(coefficients_) + 0.5 * own_variance_);
}

Prediction CostModel::total(std::span<const mpm::Estimate> estimates) const {
  Prediction prediction;
  double squares = 0;
  Eigen::Vector3d mean = Eigen::Vector3d::Zero();  // features, weighted by what the jobs cost
  for (const mpm::Estimate& estimate : estimates) {
    const double cost = seconds(estimate);
    if (cost <= 0) continue;
    prediction.seconds += cost;
    squares += cost * cost;
    mean += cost * features(static_cast<double>(estimate.particles), static_cast<double>(estimate.steps));
  }
  if (degrees_of_freedom_ == 0 || prediction.seconds <= 0) return prediction;
  mean /= prediction.seconds;
  const double own_share = squares / (prediction.seconds * prediction.seconds);
  const double variance =
      common_variance_ + own_share * std::expm1(own_variance_) + mean.dot(covariance_ * mean);
  const double factor =
      std::exp(analysis::student_t_two_sided(probability, degrees_of_freedom_) * std::sqrt(variance));
  prediction.interval = {prediction.seconds / factor, prediction.seconds * factor};
  return prediction;
}

}  // namespace mpmstudy
