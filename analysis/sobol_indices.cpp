#include "analysis/sobol_indices.hpp"

#include <algorithm>
#include <cmath>
#include <numeric>

namespace analysis {
namespace {

using Eigen::Index;
using Eigen::MatrixXd;
using Eigen::VectorXd;

std::vector<double> ranks(const std::vector<double>& values) {
  std::vector<std::size_t> order(values.size());
  std::iota(order.begin(), order.end(), std::size_t{0});
  std::ranges::sort(order, {}, [&](std::size_t i) { return values[i]; });
  std::vector<double> rank(values.size());
  for (std::size_t from = 0, to; from < order.size(); from = to) {
    for (to = from; to < order.size() && values[order[to]] == values[order[from]];) ++to;
    for (std::size_t i = from; i < to; ++i) rank[order[i]] = 0.5 * static_cast<double>(from + to - 1);
  }
  return rank;
}

}  // namespace

SobolIndices sobol_indices(const std::function<double(const VectorXd&)>& function, const MatrixXd& a,
                           const MatrixXd& b) {
  const auto values = [&](const MatrixXd& points) {
    VectorXd f(points.rows());
    for (Index i = 0; i < points.rows(); ++i) f(i) = function(points.row(i).transpose());
    return f;
  };
  const VectorXd of_a = values(a), of_b = values(b);
  const double n = static_cast<double>(a.rows());
  SobolIndices indices;
  indices.mean = 0.5 * (of_a.mean() + of_b.mean());
  const double variance =
      ((of_a.array() - indices.mean).square().sum() + (of_b.array() - indices.mean).square().sum()) / (2 * n);
  indices.deviation = std::sqrt(variance);
  if (!(variance > 0)) return indices;
  for (Index k = 0; k < a.cols(); ++k) {
    MatrixXd mixed = a;
    mixed.col(k) = b.col(k);
    const VectorXd f = values(mixed);
    // less the mean, which changes nothing but the error of the sum
    indices.first.push_back((of_b.array() - indices.mean).matrix().dot(f - of_a) / n / variance);
    indices.total.push_back((of_a - f).squaredNorm() / (2 * n) / variance);
  }
  return indices;
}

double rank_correlation(const std::vector<double>& x, const std::vector<double>& y) {
  const auto of_x = ranks(x), of_y = ranks(y);
  const double mean = 0.5 * (static_cast<double>(x.size()) - 1);
  double product = 0, xx = 0, yy = 0;
  for (std::size_t i = 0; i < x.size(); ++i) {
    product += (of_x[i] - mean) * (of_y[i] - mean);
    xx += (of_x[i] - mean) * (of_x[i] - mean);
    yy += (of_y[i] - mean) * (of_y[i] - mean);
  }
  return xx > 0 && yy > 0 ? product / std::sqrt(xx * yy) : 0;
}

}  // namespace analysis
