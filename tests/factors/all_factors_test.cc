// One suite over every registered factor: what any factor owes to a solver and to a reader of its
// covariance. A new type joins by its line in the registry and a Scenario.
#include <ceres/dynamic_numeric_diff_cost_function.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <set>
#include <string_view>

#include "factors/radio_scenarios.h"
#include "factors/scenarios.h"

namespace walkgraph::testing {
namespace {

using RowMajor = Eigen::Matrix<double, Eigen::Dynamic, Eigen::Dynamic, Eigen::RowMajor>;

struct Evaluation {
  bool ok = false;
  Eigen::VectorXd residual;
  std::vector<RowMajor> jacobians;
};

Evaluation Evaluate(const ceres::CostFunction& cost, const Blocks& blocks) {
  Evaluation e;
  e.residual.resize(cost.num_residuals());
  std::vector<const double*> x;
  std::vector<double*> j;
  for (const auto& block : blocks) {
    x.push_back(block.data());
    e.jacobians.emplace_back(cost.num_residuals(), block.size());
  }
  for (auto& jacobian : e.jacobians) j.push_back(jacobian.data());
  e.ok = cost.Evaluate(x.data(), e.residual.data(), j.data());
  return e;
}

// Central differences.
std::vector<RowMajor> NumericJacobians(const ceres::CostFunction& cost, Blocks blocks) {
  std::vector<RowMajor> jacobians;
  constexpr double kStep = 1e-6;
  for (auto& block : blocks) {
    RowMajor jacobian(cost.num_residuals(), block.size());
    for (Eigen::Index i = 0; i < block.size(); ++i) {
      const double value = block[i];
      block[i] = value + kStep;
      const Eigen::VectorXd up = Evaluate(cost, blocks).residual;
      block[i] = value - kStep;
      jacobian.col(i) = (up - Evaluate(cost, blocks).residual) / (2 * kStep);
      block[i] = value;
    }
    jacobians.push_back(jacobian);
  }
  return jacobians;
}

Blocks RandomBlocks(const std::vector<BlockKind>& kinds, Random* random) {
  Blocks blocks;
  for (const BlockKind kind : kinds) {
    switch (kind) {
      case BlockKind::kPosition:
        blocks.emplace_back(RandomPlace(random));
        break;
      case BlockKind::kHeading:
        blocks.push_back(Scalar(RandomHeading(random)));
        break;
      case BlockKind::kMapError:
      case BlockKind::kMagneticError:
        blocks.emplace_back(Eigen::Vector2d(Normal(random), Normal(random)));
        break;
      default:
        blocks.push_back(Scalar(Normal(random)));
    }
  }
  return blocks;
}

Blocks MoveBlocks(const std::vector<BlockKind>& kinds, Blocks blocks, const Motion& motion) {
  for (std::size_t i = 0; i < kinds.size(); ++i) {
    if (kinds[i] == BlockKind::kPosition) blocks[i] = motion.Move(blocks[i]);
    if (kinds[i] == BlockKind::kMapError || kinds[i] == BlockKind::kMagneticError)
      blocks[i] = motion.Turn(blocks[i]);
    if (kinds[i] == BlockKind::kHeading) blocks[i][0] += motion.angle_rad();
  }
  return blocks;
}

template <typename Factor>
class AllFactorsTest : public ::testing::Test {
 protected:
  Random random_{7};
};

template <typename List>
struct AsTypes;
template <typename... Factors>
struct AsTypes<FactorList<Factors...>> {
  using Types = ::testing::Types<Factors...>;
  static std::vector<std::string_view> Names() { return {Factors::kName...}; }
};
TYPED_TEST_SUITE(AllFactorsTest, AsTypes<RegisteredFactors>::Types);

TYPED_TEST(AllFactorsTest, ResidualVanishesAtItsOwnPrediction) {
  if constexpr (!Scenario<TypeParam>::kGaussian) {
    GTEST_SKIP() << "a likelihood without a prediction";
  } else {
    for (int i = 0; i < 200; ++i) {
      const Scenario<TypeParam> scenario(&this->random_);
      const Blocks blocks = scenario.Predicted(&this->random_);
      EXPECT_LT(Evaluate(*scenario.Cost(), blocks).residual.norm(), 1e-11);
    }
  }
}

TYPED_TEST(AllFactorsTest, JacobianEqualsAutomaticAndNumericDifferentiation) {
  for (int i = 0; i < 50; ++i) {
    const Scenario<TypeParam> scenario(&this->random_);
    const Blocks blocks = RandomBlocks(scenario.kinds(), &this->random_);
    const auto cost = scenario.Cost();
    const Evaluation used = Evaluate(*cost, blocks);
    const Evaluation twin = Evaluate(*scenario.Twin(), blocks);
    const std::vector<RowMajor> numeric = NumericJacobians(*cost, blocks);
    ASSERT_TRUE(used.ok && twin.ok);
    EXPECT_LT((used.residual - twin.residual).norm(), 1e-9 * (1 + twin.residual.norm()));
    for (std::size_t b = 0; b < blocks.size(); ++b) {
      const double scale = 1 + twin.jacobians[b].norm();
      EXPECT_LT((used.jacobians[b] - twin.jacobians[b]).norm(), 1e-9 * scale) << "block " << b;
      EXPECT_LT((used.jacobians[b] - numeric[b]).norm(), 1e-6 * scale * (1 + used.residual.norm()))
          << "block " << b;
    }
  }
}

TYPED_TEST(AllFactorsTest, NothingChangesWhenEverythingMovesTogether) {
  for (int quarters = 0; quarters < 4; ++quarters) {
    const Motion motion{quarters, {12.5, -70.25}};
    const Scenario<TypeParam> scenario(&this->random_);
    const Blocks blocks = RandomBlocks(scenario.kinds(), &this->random_);
    const auto here = Evaluate(*scenario.Cost(), blocks).residual;
    const auto there =
        Evaluate(*scenario.Moved(motion).Cost(), MoveBlocks(scenario.kinds(), blocks, motion))
            .residual;
    EXPECT_NEAR(here.norm(), there.norm(), 1e-9 * (1 + here.norm())) << quarters;
  }
}

TYPED_TEST(AllFactorsTest, StaysFiniteForExtremeInput) {
  for (const double extreme : {0.0, -1e9, 1e9, 1e-300}) {
    const Scenario<TypeParam> scenario(&this->random_);
    Blocks blocks = RandomBlocks(scenario.kinds(), &this->random_);
    for (auto& block : blocks) block.setConstant(extreme);
    const Evaluation e = Evaluate(*scenario.Cost(), blocks);
    EXPECT_TRUE(e.ok);
    EXPECT_TRUE(e.residual.allFinite()) << extreme;
    for (const RowMajor& jacobian : e.jacobians) EXPECT_TRUE(jacobian.allFinite()) << extreme;
  }
}

TYPED_TEST(AllFactorsTest, SimulatedResidualsHaveVarianceOne) {
  if constexpr (!Scenario<TypeParam>::kGaussian) {
    GTEST_SKIP() << "not a Gaussian factor: see radio_likelihood_test.cc";
  } else {
    constexpr int kSamples = 4000;
    double sum = 0;
    int rows = 0;
    for (int i = 0; i < kSamples; ++i) {
      const Scenario<TypeParam> scenario(&this->random_);
      const auto residual = Evaluate(*scenario.Cost(), scenario.Sampled(&this->random_)).residual;
      sum += residual.squaredNorm();
      rows += static_cast<int>(residual.size());
    }
    // Four standard deviations of a mean of squared standard normals.
    EXPECT_NEAR(sum / rows, 1.0, 4 * std::sqrt(2.0 / rows));
  }
}

TEST(FactorRegistryTest, NamesEveryRegisteredFactorOnce) {
  std::vector<std::string_view> described;
  for (const FactorInfo& info : FactorRegistry()) described.push_back(info.name);
  EXPECT_EQ(described, AsTypes<RegisteredFactors>::Names());
  EXPECT_EQ(std::set<std::string_view>(described.begin(), described.end()).size(),
            described.size());
}

}  // namespace
}  // namespace walkgraph::testing
