#include "analysis/next_places.hpp"

#include <cmath>

namespace analysis {
namespace {

using Eigen::Index;
using Eigen::MatrixXd;
using Eigen::VectorXd;

/// What a run at one of the places leaves of the covariance of all.
void see(MatrixXd& covariance, Index place, double noise) {
  const double variance = covariance(place, place) + noise;
  if (!(variance > 0)) return;
  const VectorXd column = covariance.col(place);
  covariance.noalias() -= column * column.transpose() / variance;
}

}  // namespace

std::vector<Index> next_places(const GaussianProcess& process, const MatrixXd& candidates,
                               const MatrixXd& seen, std::size_t count) {
  MatrixXd places(candidates.rows() + seen.rows(), candidates.cols());
  places << candidates, seen;
  MatrixXd covariance = process.covariance(places);
  const double noise = process.scatter() * process.scatter();
  for (Index i = candidates.rows(); i < places.rows(); ++i) see(covariance, i, noise);
  const Index n = candidates.rows();
  covariance = covariance.topLeftCorner(n, n).eval();
  VectorXd weights(n);
  for (Index i = 0; i < n; ++i) weights(i) = process.surprise(candidates.row(i).transpose());
  std::vector<Index> chosen;
  std::vector<bool> taken(static_cast<std::size_t>(n), false);
  while (chosen.size() < std::min(count, static_cast<std::size_t>(n))) {
    const VectorXd gains = covariance.array().square().matrix() * weights;
    Index best = -1;
    double most = 0;
    for (Index i = 0; i < n; ++i) {
      const double variance = covariance(i, i) + noise;
      if (taken[static_cast<std::size_t>(i)] || !(variance > 0) || !(gains(i) / variance > most)) continue;
      most = gains(i) / variance;
      best = i;
    }
    if (best < 0) break;  // all is known
    taken[static_cast<std::size_t>(best)] = true;
    chosen.push_back(best);
    see(covariance, best, noise);
  }
  return chosen;
}

}  // namespace analysis
