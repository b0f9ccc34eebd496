#include "solvers/graduation.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <random>
#include <vector>

#include "factors/loss.h"
#include "factors/prior.h"

namespace walkgraph {
namespace {

constexpr LossSettings kTruncated{LossKind::kTruncated, 3.0};
constexpr double kSigma = 0.1;

// One unknown, measured again and again.
FactorGraph Measured(const std::vector<double>& values, double start) {
  FactorGraph graph;
  const int block =
      graph.AddBlock({BlockKind::kStepScale, 0}, 0, Eigen::VectorXd::Constant(1, start));
  for (const double value : values) {
    GraphFactor factor = MakeGraphFactor(StatePriorFactor{value, kSigma}, {block});
    factor.loss = MakeLoss(kTruncated, 1);
    graph.AddFactor(std::move(factor));
  }
  return graph;
}

double TruncatedCost(const std::vector<double>& values, double x) {
  double cost = 0;
  for (const double value : values) {
    cost += std::min(std::pow((value - x) / kSigma, 2), 9.0);
  }
  return cost;
}

double GlobalMinimum(const std::vector<double>& values) {
  double best = 0, lowest = std::numeric_limits<double>::infinity();
  for (double x = -2; x < 12; x += 1e-3) {
    const double cost = TruncatedCost(values, x);
    if (cost < lowest) lowest = cost, best = x;
  }
  return best;
}

TEST(SolveGraduated, FindsTheGlobalMinimumFromAmongTheOutliers) {
  std::mt19937 random(4);
  std::normal_distribution<double> noise(1.0, kSigma);
  std::uniform_real_distribution<double> anything(-2, 12);
  for (int run = 0; run < 20; ++run) {
    std::vector<double> values;
    for (int i = 0; i < 12; ++i) values.push_back(noise(random));
    for (int i = 0; i < 6; ++i) values.push_back(anything(random));
    FactorGraph graph = Measured(values, 10.0);
    ASSERT_TRUE(SolveGraduated(WholeGraph(graph), {}, &graph).ok);
    // What is left of an outlier's weight moves the answer by under a hundredth.
    EXPECT_NEAR(*graph.value(0), GlobalMinimum(values), 0.01) << run;
  }
}

TEST(SolveGraduated, WithoutGraduationTheStartDecides) {
  const std::vector<double> values = {1.0, 1.05, 0.95, 1.02, 10.0, 10.1};
  FactorGraph graph = Measured(values, 10.0);
  ASSERT_TRUE(SolveGraph(WholeGraph(graph), {}, &graph).ok);
  EXPECT_NEAR(*graph.value(0), 10.05, 0.02);
  ASSERT_TRUE(SolveGraduated(WholeGraph(graph), {}, &graph).ok);
  EXPECT_NEAR(*graph.value(0), 1.005, 0.02);
}

TEST(SolveGraduated, WithoutOutliersIsTheMean) {
  FactorGraph graph = Measured({1.0, 1.1, 0.9}, 7.0);
  ASSERT_TRUE(SolveGraduated(WholeGraph(graph), {}, &graph).ok);
  EXPECT_NEAR(*graph.value(0), 1.0, 1e-6);
}

TEST(TruncatedLoss, IsSmoothBetweenParabolaAndCut) {
  TruncatedLoss loss(4.0);
  for (const double mu : {0.05, 1.0, 20.0}) {
    loss.SetMu(mu);
    for (double s = 0.05; s < 4 * (mu + 1) / mu + 5; s += 0.0637) {
      double at[3], up[3], down[3];
      constexpr double kStep = 1e-6;
      loss.Evaluate(s, at);
      loss.Evaluate(s + kStep, up);
      loss.Evaluate(s - kStep, down);
      EXPECT_NEAR(at[1], (up[0] - down[0]) / (2 * kStep), 1e-4) << mu << " " << s;
      EXPECT_GE(at[1], 0);
      EXPECT_LE(at[0], s + 1e-12);
    }
  }
  double cut[3];
  loss.SetMu(TruncatedLoss::kFinalMu);
  loss.Evaluate(400, cut);
  EXPECT_NEAR(cut[0], 4, 0.1);
  loss.SetParabola();
  loss.Evaluate(400, cut);
  EXPECT_EQ(cut[0], 400);
}

TEST(TruncatedLoss, ThresholdIsAsRareInTwoRowsAsInOne) {
  EXPECT_DOUBLE_EQ(ChiSquareThreshold(3, 1), 9);
  // The 99.73 % quantile of chi-square with two degrees of freedom.
  EXPECT_NEAR(ChiSquareThreshold(3, 2), 11.829, 1e-3);
}

}  // namespace
}  // namespace walkgraph
