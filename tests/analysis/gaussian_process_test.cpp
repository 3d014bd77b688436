#include "analysis/gaussian_process.hpp"

#include <gmock/gmock.h>

#include <cmath>
#include <random>

#include "analysis/next_places.hpp"

namespace {

using namespace analysis;
using Eigen::MatrixXd;
using Eigen::VectorXd;

/// Scattered points of the unit cube: a Kronecker sequence.
MatrixXd points(int count, int inputs, double first = 0.5) {
  double golden = 2;  // the root of g^(inputs + 1) = g + 1
  for (int k = 0; k < 60; ++k) golden = std::pow(1 + golden, 1.0 / (inputs + 1));
  MatrixXd x(count, inputs);
  for (int i = 0; i < count; ++i)
    for (int k = 0; k < inputs; ++k) x(i, k) = std::fmod(first + (i + 1) * std::pow(golden, -(k + 1)), 1);
  return x;
}

/// [Friedman 1991]: five inputs, of which one is linear, one quadratic, two are a product.
double friedman(const VectorXd& x) {
  return 10 * std::sin(3.14159265358979 * x(0) * x(1)) + 20 * std::pow(x(2) - 0.5, 2) + 10 * x(3) + 5 * x(4);
}

std::vector<double> values(const MatrixXd& x, double (*of)(const VectorXd&)) {
  std::vector<double> y;
  for (Eigen::Index i = 0; i < x.rows(); ++i) y.push_back(of(x.row(i).transpose()));
  return y;
}

TEST(GaussianProcess, IsRightWhereItHasNotSeen) {
  const MatrixXd x = points(100, 5), other = points(200, 5, 0.13);
  const GaussianProcess process(x, values(x, friedman));
  ASSERT_TRUE(process.ok()) << process.failure();
  double squares = 0;
  int covered = 0;
  for (Eigen::Index i = 0; i < other.rows(); ++i) {
    const auto [value, deviation] = process.at(other.row(i).transpose());
    const double error = value - friedman(other.row(i).transpose());
    squares += error * error;
    covered += std::abs(error) <= 1.96 * deviation;
  }
  const double rms = std::sqrt(squares / 200);
  EXPECT_LT(rms, 0.1);  // of values from 1 to 28
  EXPECT_GE(covered, 170);
  EXPECT_NEAR(process.cross_validation().rms / rms, 1, 0.7);
  EXPECT_GT(*process.cross_validation().q2, 0.999);
  // the input that is a line has the longest length
  const VectorXd lengths = process.lengths();
  EXPECT_GT(lengths(3), 2 * lengths(0));
}

TEST(GaussianProcess, GoesThroughWhatHasNoScatter) {
  const MatrixXd x = points(40, 2);
  const auto y = values(x, [](const VectorXd& p) { return std::exp(p(0)) * p(1); });
  const GaussianProcess process(x, y);
  for (Eigen::Index i = 0; i < x.rows(); ++i)
    EXPECT_NEAR(process.at(x.row(i).transpose()).value, y[static_cast<std::size_t>(i)], 1e-3);
}

/// Runs with wide intervals count less: the surface goes by those with narrow ones.
TEST(GaussianProcess, AnIntervalIsItsRunsOwnNoise) {
  MatrixXd x(21, 1);
  std::vector<double> y, deviation;
  for (int i = 0; i < 21; ++i) {
    x(i, 0) = 0.05 * i;
    y.push_back(std::sin(3 * x(i, 0)) + (i == 10 ? 0.5 : 0));
    deviation.push_back(i == 10 ? 0.5 : 0.001);
  }
  const VectorXd at = VectorXd::Constant(1, 0.5);
  EXPECT_NEAR(GaussianProcess(x, y, deviation).at(at).value, std::sin(1.5), 0.02);
}

/// Of many noisy runs the intervals of runs left out hold as often as they say, and the scatter is found.
TEST(GaussianProcess, CoversWhatItLeavesOut) {
  const MatrixXd x = points(150, 2);
  std::mt19937_64 random(3);
  std::normal_distribution<double> normal;
  auto y = values(x, [](const VectorXd& p) { return std::sin(4 * p(0)) + p(1); });
  for (double& v : y) v += 0.1 * normal(random);
  const GaussianProcess process(x, y);
  EXPECT_NEAR(process.scatter(), 0.1, 0.02);
  EXPECT_NEAR(process.cross_validation().covered, 0.95, 0.04);
  EXPECT_NEAR(process.cross_validation().rms, 0.1, 0.025);
}

/// The error of a run left out, without its formula: a process of the others, with the same lengths nearly.
TEST(GaussianProcess, CrossValidationIsLeavingOut) {
  const MatrixXd x = points(60, 2);
  const auto y = values(x, [](const VectorXd& p) { return std::sin(6 * p(0)) * p(1); });
  const GaussianProcess all(x, y);
  double squares = 0;
  for (Eigen::Index i = 0; i < x.rows(); ++i) {
    MatrixXd rest(x.rows() - 1, 2);
    std::vector<double> of_rest;
    for (Eigen::Index j = 0, k = 0; j < x.rows(); ++j) {
      if (j == i) continue;
      rest.row(k++) = x.row(j);
      of_rest.push_back(y[static_cast<std::size_t>(j)]);
    }
    const double error =
        GaussianProcess(rest, of_rest).at(x.row(i).transpose()).value - y[static_cast<std::size_t>(i)];
    squares += error * error;
  }
  EXPECT_NEAR(all.cross_validation().rms / std::sqrt(squares / static_cast<double>(x.rows())), 1, 0.15);
}

/// Mean and deviation of many paths are those of the process.
TEST(GaussianProcess, PathsAreDrawsOfIt) {
  const MatrixXd x = points(12, 1);
  const auto y = values(x, [](const VectorXd& p) { return std::sin(9 * p(0)); });
  const GaussianProcess process(x, y);
  std::mt19937_64 random(7);
  std::normal_distribution<double> normal;
  std::uniform_real_distribution<double> uniform;
  std::vector<GaussianProcess::Path> paths;
  for (int k = 0; k < 600; ++k)
    paths.push_back(process.path([&] { return normal(random); }, [&] { return uniform(random); }));
  for (const double at : {0.02, 0.31, 0.5, 0.97}) {
    const VectorXd p = VectorXd::Constant(1, at);
    double mean = 0, square = 0;
    for (const auto& path : paths) mean += path(p) / 600;
    for (const auto& path : paths) square += std::pow(path(p) - mean, 2) / 600;
    const auto [value, deviation] = process.at(p);
    EXPECT_NEAR(mean, value, 0.2 * deviation + 1e-4) << at;
    EXPECT_NEAR(std::sqrt(square) / deviation, 1, 0.2) << at;
  }
}

TEST(GaussianProcess, CovarianceIsThatOfItsPaths) {
  const MatrixXd x = points(12, 1);
  MatrixXd places(3, 1);
  places << 0.02, 0.04, 0.97;
  const GaussianProcess process(x, values(x, [](const VectorXd& p) { return std::sin(9 * p(0)); }));
  const MatrixXd covariance = process.covariance(places);
  for (Eigen::Index i = 0; i < 3; ++i)
    EXPECT_NEAR(std::sqrt(covariance(i, i)), process.at(places.row(i).transpose()).deviation, 1e-9);
  std::mt19937_64 random(5);
  std::normal_distribution<double> normal;
  std::uniform_real_distribution<double> uniform;
  EXPECT_GT(covariance(0, 1), 0.5 * std::sqrt(covariance(0, 0) * covariance(1, 1)))
      << "neighbours go together";
  MatrixXd drawn = MatrixXd::Zero(3, 3);
  constexpr int paths = 2000;
  for (int k = 0; k < paths; ++k) {
    const auto path = process.path([&] { return normal(random); }, [&] { return uniform(random); });
    VectorXd off(3);
    for (Eigen::Index i = 0; i < 3; ++i)
      off(i) = path(places.row(i).transpose()) - process.at(places.row(i).transpose()).value;
    drawn += off * off.transpose() / paths;
  }
  for (Eigen::Index i = 0; i < 3; ++i)
    for (Eigen::Index j = 0; j < 3; ++j)
      EXPECT_NEAR(drawn(i, j), covariance(i, j), 0.2 * std::sqrt(covariance(i, i) * covariance(j, j)));
}

/// Runs leave a gap: it is filled first, nothing is chosen twice, and nobody goes where runs say nothing.
TEST(NextPlaces, AreWhereNothingIsKnown) {
  MatrixXd x(12, 1), candidates(101, 1);
  for (int i = 0; i < 12; ++i) x(i, 0) = i < 6 ? 0.05 * i : 0.75 + 0.05 * (i - 6);
  for (int i = 0; i <= 100; ++i) candidates(i, 0) = 0.01 * i;
  const GaussianProcess process(x, values(x, [](const VectorXd& p) { return std::sin(9 * p(0)); }));
  const auto chosen = next_places(process, candidates, MatrixXd(0, 1), 4);
  ASSERT_EQ(chosen.size(), 4u);
  EXPECT_NEAR(candidates(chosen[0], 0), 0.5, 0.1);
  for (std::size_t k = 0; k < 4; ++k) {
    EXPECT_GT(candidates(chosen[k], 0), 0.25);
    EXPECT_LT(candidates(chosen[k], 0), 0.75);
    for (std::size_t m = 0; m < k; ++m) EXPECT_GT(std::abs(chosen[k] - chosen[m]), 2);
  }
  const auto elsewhere = next_places(process, candidates, candidates.row(chosen[0]), 4);
  for (const auto place : elsewhere) EXPECT_GT(std::abs(place - chosen[0]), 2);
  EXPECT_EQ(next_places(process, candidates, MatrixXd(0, 1), 1000).size(), 101u)
      << "all, if so many are asked for";
}

/// Of a curve with a jump the runs about it are further off than the surface says of them.
TEST(NextPlaces, AJumpIsASurprise) {
  MatrixXd x(40, 1);
  for (int i = 0; i < 40; ++i) x(i, 0) = (i + 0.5) / 40;
  const GaussianProcess process(
      x, values(x, [](const VectorXd& p) { return p(0) < 0.6 ? 0.1 * std::sin(9 * p(0)) : 1.0; }));
  const double at_jump = process.surprise(VectorXd::Constant(1, 0.6));
  EXPECT_GT(at_jump, 2);
  EXPECT_LT(process.surprise(VectorXd::Constant(1, 0.2)), 0.2 * at_jump);
}

TEST(GaussianProcess, SaysWhyThereIsNone) {
  const std::vector<double> y = {1, 2, 3, 4, 5, 6};
  MatrixXd x = points(6, 2);
  EXPECT_THAT(GaussianProcess(x.topRows(5), std::vector<double>(5, 1.0)).failure(),
              testing::HasSubstr("over 2 inputs needs at least 6 runs; there are 5"));
  x.col(1).setConstant(1);
  EXPECT_EQ(GaussianProcess(x, y).failure(), "input 2 has one value");
  EXPECT_TRUE(GaussianProcess(points(6, 2), std::vector<double>(6, 4.0)).ok());
}

}  // namespace
