#include "graph/map_error_states.h"

#include <gtest/gtest.h>

#include <Eigen/Dense>
#include <cmath>
#include <vector>

#include "graph/linearize.h"

namespace walkgraph {
namespace {

using Eigen::MatrixXd;
using Eigen::Vector2d;
using Eigen::VectorXd;

double Fade(const Vector2d& a, const Vector2d& b) { return std::exp(-(a - b).norm() / 20); }

// An exponential covariance on a line is Markov.
TEST(ConditionOnEarlier, OnALineIsTheNeighbourAlone) {
  const auto correlation = [](int a, int b) { return std::exp(-0.3 * std::abs(a - b)); };
  const SparseConditional conditional = ConditionOnEarlier(7, correlation, 3);
  EXPECT_EQ(conditional.given, std::vector<int>{6});
  EXPECT_NEAR(conditional.weights[0], std::exp(-0.3), 1e-12);
  EXPECT_NEAR(conditional.variance, 1 - std::exp(-0.6), 1e-12);
}

TEST(ConditionOnEarlier, OfAsManyAsThereAreIsTheGaussianConditional) {
  const std::vector<Vector2d> places = {{0, 0}, {9, 1}, {2, 8}, {4, 4}};
  const auto correlation = [&](int a, int b) { return Fade(places[a], places[b]); };
  const SparseConditional conditional = ConditionOnEarlier(3, correlation, 3);
  ASSERT_EQ(conditional.given.size(), 3U);
  MatrixXd among(3, 3);
  VectorXd own(3);
  for (int i = 0; i < 3; ++i) {
    own[i] = correlation(conditional.given[i], 3);
    for (int j = 0; j < 3; ++j)
      among(i, j) = correlation(conditional.given[i], conditional.given[j]);
  }
  const VectorXd weights = among.inverse() * own;
  EXPECT_LT((conditional.weights - weights).norm(), 1e-12);
  EXPECT_NEAR(conditional.variance, 1 - own.dot(weights), 1e-12);
}

TEST(ConditionOnEarlier, OfNothingNearIsThePrior) {
  const SparseConditional conditional = ConditionOnEarlier(
      5, [](int a, int b) { return a == b ? 1.0 : 0.001; }, 3);
  EXPECT_TRUE(conditional.given.empty());
  EXPECT_EQ(conditional.variance, 1);
}

constexpr double kSigmaM = 3;

// A person who walks two rounds of a square of 20 m, 1 m/s, a node per second.
WalkGraph TwoRounds(const FloorPath& floors, double correlation_s) {
  WalkGraph walk;
  walk.floors = floors;
  const Vector2d sides[] = {{1, 0}, {0, 1}, {-1, 0}, {0, -1}};
  Vector2d position(0, 0);
  for (int i = 0; i <= 160; ++i) {
    walk.node_ns.push_back(i * kNsPerSecond);
    walk.walked_m.time_ns.push_back(walk.node_ns.back());
    walk.walked_m.value.push_back(i);
    walk.position.push_back(
        walk.graph.AddBlock({BlockKind::kPosition, i}, walk.node_ns.back(), position));
    position += sides[i / 20 % 4];
  }
  MapErrorSettings settings;
  settings.correlation_m = 20;
  settings.correlation_s = correlation_s;
  settings.knot_s = 5;
  AddMapErrorState(BlockKind::kMapError, settings, kSigmaM, {}, &walk);
  return walk;
}

// Of the x components, as the factors have it.
MatrixXd CovarianceOfKnots(const WalkGraph& walk) {
  const MapErrorKnots& knots = walk.map_errors.front();
  const VariableIndex index(walk.graph, knots.state.blocks);
  const LinearSystem system =
      Linearize(walk.graph, knots.factors, {walk.graph.values(), std::nullopt}, index);
  MatrixXd information = MatrixXd::Zero(index.size(), index.size());
  for (const LinearFactor& factor : system.factors) {
    for (std::size_t a = 0; a < factor.blocks.size(); ++a) {
      for (std::size_t b = 0; b < factor.blocks.size(); ++b) {
        information(factor.blocks[a], factor.blocks[b]) +=
            factor.jacobian(0, 2 * static_cast<int>(a)) *
            factor.jacobian(0, 2 * static_cast<int>(b));
      }
    }
  }
  return information.inverse();
}

TEST(MapErrorStates, BeforeThePlacesAreKnownFadeWithTheWay) {
  const MatrixXd covariance = CovarianceOfKnots(TwoRounds(0, 1e9));
  for (Eigen::Index k = 0; k < covariance.rows(); ++k) {
    EXPECT_NEAR(covariance(0, k), kSigmaM * kSigmaM * std::exp(-5.0 * k / 20), 1e-6) << k;
  }
}

// Against the dense Gaussian process over the same places; three neighbours are not all there is.
TEST(MapErrorStates, OnPlacesAreNearlyTheField) {
  WalkGraph walk = TwoRounds(0, 1e9);
  ConditionOnPlaces(&walk);
  const MapErrorKnots& knots = walk.map_errors.front();
  const std::vector<KnotPlace> places = KnotPlaces(knots, walk, walk.node_ns.back());
  const MatrixXd covariance = CovarianceOfKnots(walk);
  ASSERT_EQ(covariance.rows(), static_cast<Eigen::Index>(places.size()));
  double worst = 0;
  for (std::size_t a = 0; a < places.size(); ++a) {
    for (std::size_t b = 0; b < places.size(); ++b) {
      const double exact = Fade(places[a].position_m, places[b].position_m);
      const double made =
          covariance(static_cast<int>(a), static_cast<int>(b)) / (kSigmaM * kSigmaM);
      worst = std::max(worst, std::abs(made - exact));
      if (a == b) {
        EXPECT_NEAR(made, 1, 0.05) << a;
      }
    }
  }
  EXPECT_LT(worst, 0.12);
  // A round later, at the same place.
  EXPECT_GT(covariance(2, 18), 0.98 * kSigmaM * kSigmaM);
}

// Each mode of a walk has its own; the graph goes from one to the other.
TEST(MapErrorStates, GoBackToWhatTheyWereConditionedOn) {
  WalkGraph walk = TwoRounds(0, 1e9);
  const MatrixXd as_walked = CovarianceOfKnots(walk);
  ConditionOnPlaces(&walk);
  const MapErrorConditionals here = Conditionals(walk);
  const MatrixXd on_places = CovarianceOfKnots(walk);
  ASSERT_GT((on_places - as_walked).cwiseAbs().maxCoeff(), 0.5 * kSigmaM * kSigmaM);
  SetConditionals(ConditionalsAsWalked(walk), &walk);
  EXPECT_EQ(CovarianceOfKnots(walk), as_walked);
  SetConditionals(here, &walk);
  EXPECT_EQ(CovarianceOfKnots(walk), on_places);
}

TEST(MapErrorStates, FadeAtOnePlaceWithTime) {
  WalkGraph walk = TwoRounds(0, 100);
  ConditionOnPlaces(&walk);
  EXPECT_NEAR(CovarianceOfKnots(walk)(2, 18), std::exp(-0.8) * kSigmaM * kSigmaM, 0.5);
}

// Every floor has a map of its own.
TEST(MapErrorStates, KnowNothingOfAnotherFloor) {
  WalkGraph walk = TwoRounds(
      FloorPath({{0, 0, 79 * kNsPerSecond}, {1, 80 * kNsPerSecond, 160 * kNsPerSecond}}), 1e9);
  for (int pass = 0; pass < 2; ++pass) {
    const MatrixXd covariance = CovarianceOfKnots(walk);
    EXPECT_NEAR(covariance(15, 16), 0, 1e-12);
    EXPECT_NEAR(covariance(2, 18), 0, 1e-12);
    EXPECT_NEAR(covariance(16, 16), kSigmaM * kSigmaM, 1e-9);
    ConditionOnPlaces(&walk);
  }
}

// What a window does: the new knot from those that it still has.
TEST(MapErrorStates, OfAWalkUnderWayUseWhatIsKnown) {
  WalkGraph walk = TwoRounds(0, 1e9);
  const std::vector<int>& blocks = walk.map_errors.front().state.blocks;
  const auto given = [&](int first_known) {
    ConditionNewOnPlaces(
        90 * kNsPerSecond, [&](int block) { return block == blocks[18]; },
        [&](int block) { return block >= blocks[static_cast<std::size_t>(first_known)]; }, &walk);
    std::vector<int> others = walk.graph.factor(walk.map_errors.front().factors[18]).blocks;
    others.pop_back();
    return others;
  };
  EXPECT_EQ(given(0).front(), blocks[2]);    // a round ago, in this very place
  EXPECT_EQ(given(10).front(), blocks[17]);  // that has left
}

}  // namespace
}  // namespace walkgraph
