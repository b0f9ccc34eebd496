#include "graph/marginalization.h"

#include <gtest/gtest.h>

#include <Eigen/QR>
#include <Eigen/SVD>
#include <algorithm>
#include <cmath>
#include <limits>
#include <stdexcept>
#include <utility>
#include <vector>

#include "graph/linear_problems.h"
#include "graph/walk_problem.h"

namespace walkgraph {
namespace {

using Eigen::MatrixXd;
using Eigen::VectorXd;

// What the marginal must be, in extended precision so that the normal equations may be used:
// information, gradient and constant of min over the first `eliminated` columns of |J d + r|^2.
struct Quadratic {
  MatrixXd information;
  VectorXd gradient;
  double constant;
};
using MatrixXld = Eigen::Matrix<long double, Eigen::Dynamic, Eigen::Dynamic>;

Quadratic DenseMarginal(const MatrixXd& jacobian, const VectorXd& residual, int eliminated) {
  const MatrixXld all =
      (MatrixXld(jacobian.rows(), jacobian.cols() + 1) << jacobian.cast<long double>(),
       residual.cast<long double>())
          .finished();
  const auto kept = all.cols() - eliminated;
  const MatrixXld basis = Eigen::HouseholderQR<MatrixXld>(all.leftCols(eliminated)).householderQ();
  const MatrixXld rows = (basis.transpose() * all).bottomRightCorner(all.rows() - eliminated, kept);
  const MatrixXd squares = (rows.transpose() * rows).cast<double>();
  return {squares.topLeftCorner(kept - 1, kept - 1), squares.col(kept - 1).head(kept - 1),
          squares(kept - 1, kept - 1)};
}

double RelativeError(const MatrixXd& value, const MatrixXd& expected) {
  return (value - expected).norm() / expected.norm();
}

double ConditionNumber(const MatrixXd& matrix) {
  const VectorXd values = Eigen::JacobiSVD<MatrixXd>(matrix).singularValues();
  return values(0) / values(values.size() - 1);
}

// det of the whole information = det of what left given what stays * det of the marginal: windows
// in different modes are weighed by it.
TEST(MarginalizationTest, DeterminantsOfWhatLeftAndOfWhatStaysMakeTheWhole) {
  const auto log_det = [](const MatrixXd& jacobian) {
    return 2.0 * Eigen::JacobiSVD<MatrixXd>(jacobian).singularValues().array().log().sum();
  };
  RandomProblems random(8);
  for (int trial = 0; trial < 20; ++trial) {
    const LinearSystem system = random.Connected(8, 1e-2);
    double left = 0;
    const LinearFactor prior = MarginalizeBlocks(system, {0, 1, 2}, &left).value();
    LinearSystem rest{{system.block_sizes.begin() + 3, system.block_sizes.end()}, {}};
    const auto keep = [&rest](LinearFactor factor) {
      for (int& block : factor.blocks) block -= 3;
      rest.factors.push_back(std::move(factor));
    };
    keep(prior);
    for (const LinearFactor& factor : system.factors) {
      if (*std::min_element(factor.blocks.begin(), factor.blocks.end()) >= 3) keep(factor);
    }
    EXPECT_NEAR(left + log_det(ToDense(rest).jacobian), log_det(ToDense(system).jacobian), 1e-8);
  }
}

TEST(MarginalizationTest, EqualsDenseMarginalUpToConditionOneMillion) {
  RandomProblems random(7);
  double worst_condition = 0;
  for (int trial = 0; trial < 60; ++trial) {
    const LinearSystem system = random.Connected(12, 1e-6);
    const DenseSystem dense = ToDense(system);
    const double condition = ConditionNumber(dense.jacobian);
    if (condition > 1e6) continue;
    worst_condition = std::max(worst_condition, condition);

    const int first_kept = 6;
    LinearSystem touching{system.block_sizes, {}};
    for (const LinearFactor& factor : system.factors) {
      if (*std::min_element(factor.blocks.begin(), factor.blocks.end()) < first_kept) {
        touching.factors.push_back(factor);
      }
    }
    const auto prior = MarginalizeBlocks(system, {0, 1, 2, 3, 4, 5});
    ASSERT_TRUE(prior.has_value());
    LinearSystem marginal{system.block_sizes, {*prior}};
    const std::vector<int> offsets = ColumnOffsets(system.block_sizes);
    const DenseSystem answer = ToDense(marginal);
    const DenseSystem batch = ToDense(touching);
    const Quadratic expected = DenseMarginal(batch.jacobian, batch.residual, offsets[first_kept]);
    const MatrixXd kept = answer.jacobian.rightCols(offsets.back() - offsets[first_kept]);
    EXPECT_LT(RelativeError(kept.transpose() * kept, expected.information), 1e-9);
    EXPECT_LT(RelativeError(kept.transpose() * answer.residual, expected.gradient), 1e-9);
    EXPECT_NEAR(answer.residual.squaredNorm(), expected.constant, 1e-9 * expected.constant);
  }
  EXPECT_GT(worst_condition, 1e5) << "the problems were too easy to mean anything";
}

// Eliminating one by one, in any grouping, and then solving for the rest gives the batch solution
// and the batch cost: to the accuracy of the square-root form also where J^T J would have lost it
// all.
TEST(MarginalizationTest, NewestEstimateAndCostEqualBatchAfterEveryUpdate) {
  RandomProblems random(11);
  for (int trial = 0; trial < 20; ++trial) {
    LinearSystem window{{2}, {}};
    AddFactor({0}, {std::pow(10.0, random.Uniform(-6, 0)) * MatrixXd::Identity(2, 2)},
              random.Matrix(2, 1), window);
    LinearSystem batch = window;
    for (int step = 1; step <= 30; ++step) {
      const MatrixXd back = random.Matrix(2, 2);
      const MatrixXd ahead = random.Matrix(2, 2);
      const VectorXd residual = random.Matrix(2, 1);
      batch.block_sizes.push_back(2);
      AddFactor({step - 1, step}, {back, ahead}, residual, batch);
      if (step % 5 == 0) AddFactor({step}, {random.Matrix(1, 2)}, random.Matrix(1, 1), batch);
      const DenseSystem dense = ToDense(batch);
      if (ConditionNumber(dense.jacobian) > 1e6) break;

      window.block_sizes.push_back(2);
      AddFactor({0, 1}, {back, ahead}, residual, window);
      if (step % 5 == 0) {
        window.factors.push_back(
            {{1}, batch.factors.back().jacobian, batch.factors.back().residual});
      }
      const DenseSystem now = ToDense(window);
      const VectorXd newest =
          Eigen::ColPivHouseholderQR<MatrixXd>(now.jacobian).solve(-now.residual);
      const VectorXd whole =
          Eigen::ColPivHouseholderQR<MatrixXd>(dense.jacobian).solve(-dense.residual);
      EXPECT_LT((newest.tail(2) - whole.tail(2)).norm(), 1e-9 * whole.norm());
      const double cost = (dense.jacobian * whole + dense.residual).squaredNorm();
      EXPECT_NEAR((now.jacobian * newest + now.residual).squaredNorm(), cost,
                  1e-9 * dense.residual.squaredNorm());

      LinearFactor prior = MarginalizeBlocks(window, {0}).value();
      LinearSystem next{{2}, {}};
      for (int& block : prior.blocks) block -= 1;
      next.factors.push_back(prior);
      if (step % 5 == 0)
        next.factors.push_back(
            {{0}, window.factors.back().jacobian, window.factors.back().residual});
      window = next;
    }
  }
}

// A walk of relative factors only, a thousand nodes marginalised one at a time at fixed
// linearisation points: what the prior says about moving or turning the whole must stay nothing.
TEST(MarginalizationTest, NoInformationAppearsAlongGaugeAfterAThousandMarginalizations) {
  // Per node xy and heading; the window holds two nodes. Steps of 0.7 m along a winding path.
  LinearSystem window{{2, 1}, {}};
  double heading_rad = 0.3;
  const MatrixXd one = MatrixXd::Identity(1, 1);
  const MatrixXd two = MatrixXd::Identity(2, 2);
  RandomProblems random(3);
  double carried = 0;
  for (int i = 0; i < 1000; ++i) {
    const Eigen::Vector2d step =
        0.7 * Eigen::Vector2d(std::cos(heading_rad), std::sin(heading_rad));
    window.block_sizes = {2, 1, 2, 1};
    AddFactor({0, 2, 1}, {-two / 0.1, two / 0.1, -Eigen::Vector2d(-step.y(), step.x()) / 0.1},
              random.Matrix(2, 1), window);
    AddFactor({1, 3}, {-one / 0.02, one / 0.02}, random.Matrix(1, 1), window);
    AddFactor({0, 2, 3}, {-two / 0.3, two / 0.3, -Eigen::Vector2d(-step.y(), step.x()) / 0.3},
              random.Matrix(2, 1), window);
    heading_rad += 0.01 * std::sin(0.03 * i);

    LinearFactor prior = MarginalizeBlocks(window, {0, 1}).value();
    for (int& block : prior.blocks) block -= 2;
    window = {{2, 1}, {prior}};
    // The relative measurements of the two nodes have nothing to say about the newer one alone.
    carried = std::max(carried, prior.jacobian.size() > 0 ? prior.jacobian.norm() : 0.0);
  }
  EXPECT_EQ(carried, 0.0) << "rounding must be dropped, not carried along";
}

// As above with slow states in the separator, so that the prior has much to carry beside the gauge.
TEST(MarginalizationTest, GaugeStaysFreeWhileSlowStatesAreLearnt) {
  WalkProblem walk =
      MakeWalk({.nodes = 1001, .nodes_per_knot = 2000, .positions = false, .headings = false});
  LinearSystem system = walk.system;
  // Stride and gyroscope are observed against the magnetic field's turn rate and a surveyed length.
  for (int i = 0; i + 1 < walk.nodes; ++i) {
    AddFactor({walk.heading[i], walk.heading[i + 1]},
              {-MatrixXd::Identity(1, 1), MatrixXd::Identity(1, 1)}, VectorXd::Constant(1, 0.1),
              system);
    AddFactor({walk.position[i], walk.position[i + 1], walk.heading[i]},
              {walk.system.factors[3 + 2 * i].jacobian.leftCols(2) * 0.2,
               walk.system.factors[3 + 2 * i].jacobian.middleCols(2, 2) * 0.2,
               walk.system.factors[3 + 2 * i].jacobian.middleCols(4, 1) * 0.2},
              VectorXd::Constant(2, 0.1), system);
  }
  std::vector<char> gone(system.block_sizes.size(), 0);
  for (int i = 0; i < 1000; ++i) {
    const std::vector<int> eliminated{walk.position[i], walk.heading[i]};
    const LinearFactor prior = MarginalizeBlocks(system, eliminated).value();
    for (const int block : eliminated) gone[block] = 1;
    std::erase_if(system.factors, [&](const LinearFactor& factor) {
      return std::any_of(factor.blocks.begin(), factor.blocks.end(),
                         [&](int block) { return gone[block] != 0; });
    });
    system.factors.push_back(prior);

    double trace = prior.jacobian.squaredNorm();
    double along_gauge = 0;
    int column = 0;
    for (const int block : prior.blocks) {
      if (block == walk.position[i + 1]) {
        along_gauge += prior.jacobian.middleCols(column, 2).squaredNorm();
      }
      if (block == walk.heading[i + 1]) along_gauge += prior.jacobian.col(column).squaredNorm();
      column += system.block_sizes[block];
    }
    ASSERT_GT(trace, 0);
    // Position and heading of the one node left are exactly the gauge.
    EXPECT_LT(along_gauge, 1e-9 * trace) << "after " << i + 1 << " marginalisations";
  }
}

TEST(MarginalizationTest, InnerVariablesMayBeEliminated) {
  const WalkProblem walk = MakeWalk({.nodes = 9});
  const auto prior = MarginalizeBlocks(
      walk.system, {walk.position[4], walk.heading[4], walk.position[6], walk.heading[6]});
  ASSERT_TRUE(prior.has_value());
  LinearSystem rest{walk.system.block_sizes, {*prior}};
  const std::vector<int> gone{walk.position[4], walk.heading[4], walk.position[6], walk.heading[6]};
  for (const LinearFactor& factor : walk.system.factors) {
    if (std::none_of(factor.blocks.begin(), factor.blocks.end(), [&](int block) {
          return std::find(gone.begin(), gone.end(), block) != gone.end();
        })) {
      rest.factors.push_back(factor);
    }
  }
  const DenseSystem before = ToDense(walk.system);
  const DenseSystem after = ToDense(rest);
  const VectorXd full = before.jacobian.householderQr().solve(-before.residual);
  const VectorXd reduced =
      Eigen::CompleteOrthogonalDecomposition<MatrixXd>(after.jacobian).solve(-after.residual);
  const std::vector<int> offsets = ColumnOffsets(walk.system.block_sizes);
  for (int block = 0; block < static_cast<int>(walk.system.block_sizes.size()); ++block) {
    if (std::find(gone.begin(), gone.end(), block) != gone.end()) continue;
    const int size = walk.system.block_sizes[block];
    EXPECT_LT((full - reduced).segment(offsets[block], size).norm(), 1e-10 * full.norm());
  }
  EXPECT_NEAR((before.jacobian * full + before.residual).squaredNorm(),
              (after.jacobian * reduced + after.residual).squaredNorm(), 1e-10);
}

TEST(MarginalizationTest, BlockThatNobodyTouchesLeavesNothing) {
  LinearSystem system{{2, 3}, {}};
  AddFactor({0}, {MatrixXd::Identity(2, 2)}, VectorXd::Ones(2), system);
  const auto prior = MarginalizeBlocks(system, {1});
  ASSERT_TRUE(prior.has_value());
  EXPECT_TRUE(prior->blocks.empty());
  EXPECT_EQ(prior->residual.size(), 0);
}

TEST(MarginalizationTest, EmptySeparatorKeepsTheConstant) {
  LinearSystem system{{1}, {}};
  AddFactor({0}, {MatrixXd::Ones(2, 1)}, Eigen::Vector2d(1, 3), system);
  const auto prior = MarginalizeBlocks(system, {0});
  ASSERT_TRUE(prior.has_value());
  EXPECT_TRUE(prior->blocks.empty());
  EXPECT_EQ(prior->jacobian.cols(), 0);
  EXPECT_NEAR(prior->residual.squaredNorm(), 2, 1e-14);  // both one away from their mean
}

TEST(MarginalizationTest, DifferenceOfUnobservableBlocksSaysNothingOfOne) {
  LinearSystem system{{2, 2}, {}};
  AddFactor({0, 1}, {-MatrixXd::Identity(2, 2), MatrixXd::Identity(2, 2)}, VectorXd::Ones(2),
            system);
  const auto prior = MarginalizeBlocks(system, {0});
  ASSERT_TRUE(prior.has_value());
  EXPECT_EQ(prior->jacobian.rows(), 0);
}

TEST(MarginalizationTest, NonFiniteInputGivesNoPrior) {
  LinearSystem system{{1, 1}, {}};
  AddFactor({0, 1}, {MatrixXd::Ones(1, 1), MatrixXd::Ones(1, 1)}, VectorXd::Zero(1), system);
  system.factors[0].jacobian(0, 1) = std::numeric_limits<double>::quiet_NaN();
  EXPECT_FALSE(MarginalizeBlocks(system, {0}).has_value());
}

TEST(MarginalizationTest, MalformedSystemsAreRefused) {
  LinearSystem system{{2}, {}};
  AddFactor({0}, {MatrixXd::Identity(2, 2)}, VectorXd::Ones(2), system);
  EXPECT_THROW(MarginalizeBlocks(system, {1}), std::invalid_argument);
  EXPECT_THROW(MarginalizeBlocks(system, {0, 0}), std::invalid_argument);
  system.factors[0].jacobian.resize(2, 3);
  EXPECT_THROW(MarginalizeBlocks(system, {0}), std::invalid_argument);
}

}  // namespace
}  // namespace walkgraph
