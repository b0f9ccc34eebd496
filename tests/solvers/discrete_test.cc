#include "solvers/baselines/discrete.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <random>
#include <vector>

namespace walkgraph {
namespace {

// Random rows over `n` states: some listed entries, the rest the same and no more than any of them.
TransitionRows RandomRows(int n, std::mt19937& random) {
  TransitionRows rows;
  std::uniform_real_distribution<double> chance(0, 1);
  for (int i = 0; i < n; ++i) {
    std::vector<int> to;
    for (int j = 0; j < n; ++j) {
      if (chance(random) < 0.3) to.push_back(j);
    }
    std::vector<double> weight(to.size());
    double sum = n - static_cast<double>(to.size());
    for (double& w : weight) sum += w = 1 + 20 * chance(random);
    rows.elsewhere.push_back(1 / sum);
    for (std::size_t e = 0; e < to.size(); ++e) rows.entries.push_back({to[e], weight[e] / sum});
    rows.begin.push_back(rows.entries.size());
  }
  return rows;
}

Eigen::MatrixXd Dense(const TransitionRows& rows) {
  const auto n = static_cast<Eigen::Index>(rows.size());
  Eigen::MatrixXd dense(n, n);
  for (Eigen::Index i = 0; i < n; ++i) {
    dense.row(i).setConstant(rows.elsewhere[static_cast<std::size_t>(i)]);
    for (const auto& entry : rows.Row(static_cast<std::size_t>(i))) {
      dense(i, entry.to) = entry.probability;
    }
  }
  return dense;
}

std::vector<double> RandomDistribution(int n, std::mt19937& random) {
  std::uniform_real_distribution<double> chance(0.01, 1);
  std::vector<double> p(static_cast<std::size_t>(n));
  double sum = 0;
  for (double& value : p) sum += value = chance(random);
  for (double& value : p) value /= sum;
  return p;
}

TEST(Discrete, LogSumExpNeitherOverflowsNorVanishes) {
  const double inf = std::numeric_limits<double>::infinity();
  EXPECT_NEAR(LogSumExp(std::vector{-2000.0, -2000.0 + std::log(3)}), -2000 + std::log(4), 1e-12);
  EXPECT_NEAR(LogSumExp(std::vector{1500.0, -inf}), 1500, 1e-12);
  EXPECT_EQ(LogSumExp(std::vector{-inf, -inf}), -inf);
  EXPECT_EQ(LogSumExp({}), -inf);
}

TEST(Discrete, PredictionIsTheDenseMatrixProduct) {
  std::mt19937 random(1);
  for (int trial = 0; trial < 20; ++trial) {
    const TransitionRows rows = RandomRows(17, random);
    const Eigen::MatrixXd dense = Dense(rows);
    ASSERT_NEAR((dense.rowwise().sum().array() - 1).abs().maxCoeff(), 0, 1e-12);
    const std::vector<double> p = RandomDistribution(17, random);
    const std::vector<double> next = PredictDistribution(rows, p);
    const Eigen::VectorXd expected =
        dense.transpose() * Eigen::Map<const Eigen::VectorXd>(p.data(), 17);
    for (int j = 0; j < 17; ++j) EXPECT_NEAR(next[static_cast<std::size_t>(j)], expected[j], 1e-14);
  }
}

TEST(Discrete, ViterbiFindsTheBestOfAllPaths) {
  std::mt19937 random(2);
  constexpr int kStates = 5;
  for (int trial = 0; trial < 20; ++trial) {
    const TransitionRows rows[2] = {RandomRows(kStates, random), RandomRows(kStates, random)};
    std::vector<std::vector<double>> likelihood;
    for (int k = 0; k < 3; ++k) {
      likelihood.push_back(RandomDistribution(kStates, random));
      for (double& value : likelihood.back()) value = std::log(value);
    }
    double best = -1e300;
    std::vector<int> expected;
    for (int path = 0; path < kStates * kStates * kStates; ++path) {
      const int s[3] = {path % kStates, path / kStates % kStates, path / kStates / kStates};
      double score = likelihood[0][static_cast<std::size_t>(s[0])];
      for (int k = 0; k < 2; ++k) {
        score += std::log(Dense(rows[k])(s[k], s[k + 1])) +
                 likelihood[static_cast<std::size_t>(k + 1)][static_cast<std::size_t>(s[k + 1])];
      }
      if (score <= best) continue;
      best = score;
      expected = {s[0], s[1], s[2]};
    }
    std::vector<double> score = likelihood[0];
    std::vector<std::vector<int>> from;
    for (std::size_t k = 0; k < 2; ++k) {
      ViterbiStep step = AdvanceViterbi(rows[k], score);
      score = step.log_score;
      for (std::size_t i = 0; i < score.size(); ++i) score[i] += likelihood[k + 1][i];
      from.push_back(step.from);
    }
    EXPECT_EQ(TraceViterbi(from, score), expected);
    EXPECT_NEAR(score[static_cast<std::size_t>(ArgMax(score))], best, 1e-12);
  }
}

TEST(Discrete, UpdateOfTheImpossibleIsUniform) {
  const std::vector<double> posterior = UpdateDistribution(
      std::vector{1.0, 0.0}, std::vector{-std::numeric_limits<double>::infinity(), 0.0});
  EXPECT_EQ(posterior, (std::vector{0.5, 0.5}));
}

TEST(Discrete, SecondMomentIsVariancePlusSquaredBias) {
  const std::vector<Eigen::Vector2d> positions{{0, 0}, {2, 0}};
  const Eigen::Matrix2d moment = SecondMoment(positions, std::vector{0.5, 0.5}, {1, 3});
  EXPECT_NEAR(moment(0, 0), 1, 1e-15);
  EXPECT_NEAR(moment(1, 1), 9, 1e-15);
  EXPECT_NEAR(moment(0, 1), 0, 1e-15);
}

}  // namespace
}  // namespace walkgraph
