#include "solvers/modes.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <vector>

#include "graph/graph_part.h"

namespace walkgraph {
namespace {

TEST(MixtureWeightsTest, AreTheMassesAddingUpToOne) {
  const std::vector<double> weights = MixtureWeights({700.0, 700.0 + std::log(3.0)});
  ASSERT_EQ(weights.size(), 2U);
  EXPECT_NEAR(weights[0], 0.75, 1e-12);
  EXPECT_NEAR(weights[1], 0.25, 1e-12);
}

TEST(MixtureWeightsTest, GiveAllToTheFirstWhereNoneIsFinite) {
  const double infinity = std::numeric_limits<double>::infinity();
  EXPECT_EQ(MixtureWeights({infinity, infinity}), (std::vector<double>{1.0, 0.0}));
}

// Two nodes with the same covariance, and a point that is (dx, 0) away at both.
bool IsSame(double dx, double sigma_m, double distinct_m) {
  FactorGraph graph;
  graph.AddBlock({BlockKind::kPosition, 0}, 0, Eigen::Vector2d(0, 0));
  graph.AddBlock({BlockKind::kPosition, 1}, 1, Eigen::Vector2d(5, 0));
  const Eigen::VectorXd values = graph.values();
  PointUncertainty uncertainty;
  uncertainty.covariance.assign(2, sigma_m * sigma_m * Eigen::Matrix2d::Identity());
  const Eigen::VectorXd point = values + Eigen::Vector4d(dx, 0, dx, 0);
  return SamePath(graph, WholeGraph(graph), point, values, uncertainty, distinct_m);
}

TEST(SamePathTest, LooksAtMetresAndAtTheSpreadOfTheMode) {
  EXPECT_TRUE(IsSame(0.9, 0.1, 1.0));
  EXPECT_FALSE(IsSame(1.1, 0.1, 1.0));
  // A mode that leaves the walk anywhere within 100 m is the same from wherever it was found.
  EXPECT_TRUE(IsSame(120, 100, 1.0));
  EXPECT_FALSE(IsSame(150, 100, 1.0));
}

}  // namespace
}  // namespace walkgraph
