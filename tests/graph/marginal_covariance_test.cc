#include "graph/marginal_covariance.h"

#include <ceres/ceres.h>
#include <gtest/gtest.h>

#include <Eigen/Dense>
#include <algorithm>
#include <cmath>
#include <limits>
#include <memory>
#include <stdexcept>
#include <vector>

#include "graph/linear_problems.h"
#include "graph/marginalization.h"
#include "graph/walk_problem.h"

namespace walkgraph {
namespace {

using Eigen::MatrixXd;
using Eigen::VectorXd;
using MatrixXld = Eigen::Matrix<long double, Eigen::Dynamic, Eigen::Dynamic>;

MatrixXd DenseInverse(const LinearSystem& system) {
  const MatrixXld jacobian = ToDense(system).jacobian.cast<long double>();
  const MatrixXld identity = MatrixXld::Identity(jacobian.cols(), jacobian.cols());
  return (jacobian.transpose() * jacobian).ldlt().solve(identity).cast<double>();
}

// A linear factor as Ceres sees it: constant Jacobian.
class CeresLinear : public ceres::CostFunction {
 public:
  CeresLinear(const LinearSystem& system, const LinearFactor& factor) : factor_(factor) {
    set_num_residuals(static_cast<int>(factor.residual.size()));
    for (const int block : factor.blocks) {
      mutable_parameter_block_sizes()->push_back(system.block_sizes[block]);
    }
  }
  bool Evaluate(double const* const* /*parameters*/, double* residuals,
                double** jacobians) const override {
    VectorXd::Map(residuals, factor_.residual.size()) = factor_.residual;
    if (jacobians == nullptr) return true;
    Eigen::Index from = 0;
    for (size_t i = 0; i < factor_.blocks.size(); ++i) {
      const int size = parameter_block_sizes()[i];
      if (jacobians[i] != nullptr) {
        using RowMajor = Eigen::Matrix<double, Eigen::Dynamic, Eigen::Dynamic, Eigen::RowMajor>;
        Eigen::Map<RowMajor>(jacobians[i], num_residuals(), size) =
            factor_.jacobian.middleCols(from, size);
      }
      from += size;
    }
    return true;
  }

 private:
  LinearFactor factor_;
};

TEST(MarginalCovarianceTest, EqualsCeresOnAWalk) {
  const WalkProblem walk = MakeWalk({.nodes = 90, .nodes_per_knot = 20});
  const LinearSystem& system = walk.system;
  const auto covariance = MarginalCovariance::Compute(system);
  ASSERT_TRUE(covariance.has_value());

  std::vector<VectorXd> values;
  for (const int size : system.block_sizes) values.push_back(VectorXd::Zero(size));
  ceres::Problem problem;
  std::vector<std::pair<const double*, const double*>> wanted;
  for (const LinearFactor& factor : system.factors) {
    std::vector<double*> parameters;
    for (const int block : factor.blocks) parameters.push_back(values[block].data());
    problem.AddResidualBlock(new CeresLinear(system, factor), nullptr, parameters);
  }
  for (const VectorXd& value : values) wanted.emplace_back(value.data(), value.data());
  wanted.emplace_back(values[walk.position[40]].data(), values[walk.heading[40]].data());
  ceres::Covariance reference{ceres::Covariance::Options()};
  ASSERT_TRUE(reference.Compute(wanted, &problem));

  for (size_t i = 0; i < values.size(); ++i) {
    const int size = system.block_sizes[i];
    MatrixXd expected(size, size);  // symmetric: row-major or not is the same
    reference.GetCovarianceBlock(values[i].data(), values[i].data(), expected.data());
    EXPECT_TRUE(covariance->block(static_cast<int>(i)).observable());
    EXPECT_LT((covariance->block(static_cast<int>(i)).covariance - expected).norm(),
              1e-9 * expected.norm());
  }
  Eigen::Vector2d cross;
  reference.GetCovarianceBlock(values[walk.position[40]].data(), values[walk.heading[40]].data(),
                               cross.data());
  const auto joint = covariance->Joint(walk.position[40], walk.heading[40]);
  ASSERT_TRUE(joint.has_value());
  EXPECT_LT((joint->covariance.topRightCorner(2, 1) - cross).norm(), 1e-9 * cross.norm());
}

TEST(MarginalCovarianceTest, EqualsDenseInverseAndDeterminantUpToConditionOneMillion) {
  RandomProblems random(21);
  double worst = 0;
  for (int trial = 0; trial < 60; ++trial) {
    const LinearSystem system = random.Connected(15, 1e-6);
    const MatrixXd dense = ToDense(system).jacobian;
    const VectorXd singular = Eigen::JacobiSVD<MatrixXd>(dense).singularValues();
    const double condition = singular(0) / singular(singular.size() - 1);
    if (condition > 1e6) continue;
    worst = std::max(worst, condition);
    const MatrixXd inverse = DenseInverse(system);
    const auto covariance = MarginalCovariance::Compute(system);
    ASSERT_TRUE(covariance.has_value());
    const std::vector<int> offsets = ColumnOffsets(system.block_sizes);
    for (int block = 0; block < 15; ++block) {
      const int size = system.block_sizes[block];
      const MatrixXd expected = inverse.block(offsets[block], offsets[block], size, size);
      EXPECT_LT((covariance->block(block).covariance - expected).norm(), 1e-9 * expected.norm());
    }
    ASSERT_TRUE(covariance->log_determinant().has_value());
    EXPECT_NEAR(*covariance->log_determinant(), 2 * singular.array().log().sum(), 1e-9);
  }
  EXPECT_GT(worst, 1e5) << "the problems were too easy to mean anything";
}

TEST(MarginalCovarianceTest, NamedPairsAreJoinedHoweverFarApart) {
  const WalkProblem walk = MakeWalk({.nodes = 60});
  const int first = walk.position[2];
  const int last = walk.position[57];
  EXPECT_FALSE(MarginalCovariance::Compute(walk.system)->Joint(first, last).has_value());
  const auto covariance = MarginalCovariance::Compute(walk.system, {{last, first}});
  const auto joint = covariance->Joint(first, last);
  ASSERT_TRUE(joint.has_value());
  const MatrixXd inverse = DenseInverse(walk.system);
  const std::vector<int> offsets = ColumnOffsets(walk.system.block_sizes);
  const MatrixXd cross = inverse.block(offsets[first], offsets[last], 2, 2);
  EXPECT_LT((joint->covariance.topRightCorner(2, 2) - cross).norm(), 1e-9 * cross.norm());
  const auto swapped = covariance->Joint(last, first);
  ASSERT_TRUE(swapped.has_value());
  EXPECT_EQ(swapped->covariance.topRightCorner(2, 2), joint->covariance.bottomLeftCorner(2, 2));
}

// ceres 777, fuse pull 33: the first update, before anything absolute has arrived.
TEST(MarginalCovarianceTest, RankDeficientAtTheStartIsAnsweredWithInfiniteVariance) {
  const WalkProblem walk = MakeWalk({.nodes = 30, .positions = false});
  LinearSystem system = walk.system;
  const auto covariance = MarginalCovariance::Compute(system);
  ASSERT_TRUE(covariance.has_value());
  EXPECT_EQ(covariance->nullity(), 2);  // absolute headings fix the rotation
  EXPECT_FALSE(covariance->log_determinant().has_value());
  for (int i = 0; i < walk.nodes; ++i) {
    EXPECT_EQ(covariance->block(walk.position[i]).unobservable.cols(), 2);
    EXPECT_TRUE(covariance->block(walk.heading[i]).observable());
  }
  EXPECT_TRUE(covariance->block(walk.step_scale).observable());

  // What is observable must not depend on the gauge: pin the walk anywhere, the rest stays the
  // same.
  for (const int pinned : {3, 29}) {
    LinearSystem fixed = system;
    AddFactor({walk.position[pinned]}, {MatrixXd::Identity(2, 2)}, VectorXd::Zero(2), fixed);
    const MatrixXd inverse = DenseInverse(fixed);
    const std::vector<int> offsets = ColumnOffsets(system.block_sizes);
    for (int i = 0; i < walk.nodes; ++i) {
      const double expected = inverse(offsets[walk.heading[i]], offsets[walk.heading[i]]);
      EXPECT_NEAR(covariance->block(walk.heading[i]).covariance(0, 0), expected, 1e-9 * expected);
    }
  }
}

TEST(MarginalCovarianceTest, PositionWithoutHeadingsTurnsToo) {
  const WalkProblem walk = MakeWalk({.nodes = 30, .positions = false, .headings = false});
  const auto covariance = MarginalCovariance::Compute(walk.system);
  ASSERT_TRUE(covariance.has_value());
  EXPECT_EQ(covariance->nullity(), 3);
  EXPECT_FALSE(covariance->block(walk.heading[7]).observable());
  EXPECT_TRUE(covariance->block(walk.bias[0]).observable());
  EXPECT_TRUE(covariance->block(walk.map_error[0]).observable());
}

TEST(MarginalCovarianceTest, OneUnknownDirectionOfABlockLeavesTheOtherFinite) {
  // A wall at 30 degrees: only the distance along its normal is measured, with sigma 0.2.
  const Eigen::Vector2d normal(std::cos(0.5), std::sin(0.5));
  LinearSystem system{{2}, {}};
  AddFactor({0}, {normal.transpose() / 0.2}, VectorXd::Zero(1), system);
  const auto covariance = MarginalCovariance::Compute(system);
  ASSERT_TRUE(covariance.has_value());
  const BlockMarginal& block = covariance->block(0);
  ASSERT_EQ(block.unobservable.cols(), 1);
  EXPECT_NEAR(block.unobservable.col(0).dot(normal), 0, 1e-12);
  EXPECT_NEAR(normal.dot(block.covariance * normal), 0.04, 1e-12);
  EXPECT_NEAR((block.covariance - 0.04 * normal * normal.transpose()).norm(), 0, 1e-12);
}

TEST(MarginalCovarianceTest, JointOfUnobservableBlocksKeepsTheirDifference) {
  LinearSystem system{{1, 1}, {}};
  AddFactor({0, 1}, {-MatrixXd::Ones(1, 1), MatrixXd::Ones(1, 1)}, VectorXd::Zero(1), system);
  const auto joint = MarginalCovariance::Compute(system)->Joint(0, 1);
  ASSERT_TRUE(joint.has_value());
  ASSERT_EQ(joint->unobservable.cols(), 1);
  const Eigen::Vector2d difference(-1, 1);
  EXPECT_NEAR(difference.dot(joint->covariance * difference), 1, 1e-12);
}

TEST(MarginalCovarianceTest, UntouchedBlockIsUnobservableAndAlone) {
  LinearSystem system{{2, 1, 3}, {}};
  AddFactor({0}, {MatrixXd::Identity(2, 2)}, VectorXd::Zero(2), system);
  const auto covariance = MarginalCovariance::Compute(system);
  ASSERT_TRUE(covariance.has_value());
  EXPECT_EQ(covariance->nullity(), 4);
  EXPECT_TRUE(covariance->block(0).observable());
  EXPECT_EQ(covariance->block(2).unobservable.cols(), 3);
  EXPECT_TRUE(MarginalCovariance::Compute({{}, {}}).has_value());
}

// colmap pull 1557: there is nothing to read after a failure.
TEST(MarginalCovarianceTest, ReadingAfterFailedComputeIsImpossible) {
  for (const double bad :
       {std::numeric_limits<double>::quiet_NaN(), std::numeric_limits<double>::infinity()}) {
    LinearSystem system{{1}, {}};
    AddFactor({0}, {MatrixXd::Constant(1, 1, bad)}, VectorXd::Zero(1), system);
    EXPECT_FALSE(MarginalCovariance::Compute(system).has_value());
  }
}

// gtsam 1638: marginalising an inner variable, and asking for covariances afterwards.
TEST(MarginalCovarianceTest, InnerVariableMarginalisedLeavesTheOthersAsTheyWere) {
  const WalkProblem walk = MakeWalk({.nodes = 12});
  const int gone = walk.position[5];
  LinearSystem rest{walk.system.block_sizes, {*MarginalizeBlocks(walk.system, {gone})}};
  for (const LinearFactor& factor : walk.system.factors) {
    if (std::find(factor.blocks.begin(), factor.blocks.end(), gone) == factor.blocks.end()) {
      rest.factors.push_back(factor);
    }
  }
  const auto before = MarginalCovariance::Compute(walk.system);
  const auto after = MarginalCovariance::Compute(rest);
  ASSERT_TRUE(before.has_value() && after.has_value());
  EXPECT_EQ(after->nullity(), 2);  // the block that is gone, and nothing else
  for (int block = 0; block < static_cast<int>(rest.block_sizes.size()); ++block) {
    if (block == gone) continue;
    const MatrixXd& expected = before->block(block).covariance;
    EXPECT_TRUE(after->block(block).observable());
    EXPECT_LT((after->block(block).covariance - expected).norm(), 1e-10 * expected.norm());
  }
}

// okvis pull 83: a weight in the linearised factor must reach the covariance.
TEST(MarginalCovarianceTest, RobustWeightsWidenTheCovariance) {
  LinearSystem system{{1}, {}};
  const double weight = 0.25;
  AddFactor({0}, {std::sqrt(weight) * MatrixXd::Ones(1, 1)}, VectorXd::Zero(1), system);
  EXPECT_NEAR(MarginalCovariance::Compute(system)->block(0).covariance(0, 0), 4, 1e-12);
}

TEST(MarginalCovarianceTest, ChangeOfUnitsChangesUnitsOnly) {
  const WalkProblem walk = MakeWalk({.nodes = 40, .positions = false});
  LinearSystem millimetres = walk.system;
  for (LinearFactor& factor : millimetres.factors) {
    Eigen::Index from = 0;
    for (const int block : factor.blocks) {
      const int size = millimetres.block_sizes[block];
      if (size == 2) factor.jacobian.middleCols(from, size) *= 1e-3;
      from += size;
    }
  }
  const auto metre = MarginalCovariance::Compute(walk.system);
  const auto milli = MarginalCovariance::Compute(millimetres);
  EXPECT_EQ(metre->nullity(), milli->nullity());
  for (int i = 0; i < walk.nodes; ++i) {
    EXPECT_EQ(milli->block(walk.position[i]).unobservable.cols(), 2);
    const double expected = metre->block(walk.heading[i]).covariance(0, 0);
    EXPECT_NEAR(milli->block(walk.heading[i]).covariance(0, 0), expected, 1e-10 * expected);
  }
  const MatrixXd& map_error = metre->block(walk.map_error[0]).covariance;
  EXPECT_LT((milli->block(walk.map_error[0]).covariance - 1e6 * map_error).norm(),
            1e-3 * map_error.norm());
}

TEST(MarginalCovarianceTest, LongWalkKeepsItsGaugeAndItsPrecision) {
  const WalkProblem walk = MakeWalk({.nodes = 7200, .positions = false, .headings = false});
  const auto covariance = MarginalCovariance::Compute(walk.system);
  ASSERT_TRUE(covariance.has_value());
  EXPECT_EQ(covariance->nullity(), 3);
  for (const int bias : walk.bias) EXPECT_TRUE(covariance->block(bias).observable());
  for (int i = 0; i < walk.nodes; i += 100) {
    EXPECT_EQ(covariance->block(walk.position[i]).unobservable.cols(), 2);
    EXPECT_EQ(covariance->block(walk.heading[i]).unobservable.cols(), 1);
  }
}

TEST(MarginalCovarianceTest, MalformedPairsAreRefused) {
  const LinearSystem system{{1, 1}, {}};
  EXPECT_THROW(MarginalCovariance::Compute(system, {{0, 2}}), std::invalid_argument);
  EXPECT_THROW(MarginalCovariance::Compute(system, {{1, 1}}), std::invalid_argument);
}

}  // namespace
}  // namespace walkgraph
