#include "graph/variance_component.h"

#include <gtest/gtest.h>

#include <Eigen/Dense>
#include <cmath>
#include <random>
#include <vector>

#include "graph/linear_problems.h"
#include "graph/marginal_covariance.h"

namespace walkgraph {
namespace {

using Eigen::MatrixXd;
using Eigen::VectorXd;

MatrixXd Scalar(double value) { return MatrixXd::Constant(1, 1, value); }

// The system linearised again where its squares are smallest.
LinearSystem AtSolution(LinearSystem system) {
  const DenseSystem dense = ToDense(system);
  const VectorXd step = -dense.jacobian.colPivHouseholderQr().solve(dense.residual);
  const VectorXd residual = dense.residual + dense.jacobian * step;
  Eigen::Index row = 0;
  for (LinearFactor& factor : system.factors) {
    factor.residual = residual.segment(row, factor.residual.size());
    row += factor.residual.size();
  }
  return system;
}

VarianceComponent Estimate(const LinearSystem& system, const std::vector<bool>& in_group) {
  return EstimateVarianceComponent(system, in_group, *MarginalCovariance::Compute(system));
}

// A stationary Gauss-Markov process of `knots` states and claimed variance one, each state seen
// with unit noise against a state of its own that is anchored elsewhere: what a map error is to a
// walk.
LinearSystem ProcessAndWalk(int knots, double process_sigma, std::mt19937_64* generator) {
  std::normal_distribution<double> normal;
  const double kept = 0.6, fresh = std::sqrt(1 - kept * kept);
  LinearSystem system;
  system.block_sizes.assign(static_cast<std::size_t>(2 * knots), 1);
  double state = process_sigma * normal(*generator);
  AddFactor({0}, {Scalar(1)}, Scalar(0), system);
  for (int k = 0; k < knots; ++k) {
    if (k > 0) {
      state = kept * state + process_sigma * fresh * normal(*generator);
      AddFactor({k - 1, k}, {Scalar(-kept / fresh), Scalar(1 / fresh)}, Scalar(0), system);
    }
    const double where = 3 * normal(*generator);
    const double seen = where + state + 0.5 * normal(*generator);
    AddFactor({k, knots + k}, {Scalar(2), Scalar(2)}, Scalar(-2 * seen), system);
    AddFactor({knots + k}, {Scalar(4)}, Scalar(-4 * (where + 0.25 * normal(*generator))), system);
  }
  return AtSolution(system);
}

std::vector<bool> FirstOf(int count, int total) {
  std::vector<bool> in_group(static_cast<std::size_t>(total), false);
  std::fill_n(in_group.begin(), count, true);
  return in_group;
}

TEST(VarianceComponent, IsTheSampleVarianceOfRepeatedMeasurements) {
  LinearSystem system;
  system.block_sizes = {1};
  const std::vector<double> measured{2, 4, 4, 5, 5, 7, 9, 12};  // mean 6, squares about it 72
  for (const double value : measured) AddFactor({0}, {Scalar(1)}, Scalar(-value), system);
  const VarianceComponent component = Estimate(AtSolution(system), {true});
  EXPECT_NEAR(component.squares, 72.0, 1e-12);
  EXPECT_NEAR(component.redundancy, 7.0, 1e-12);
  EXPECT_NEAR(component.Inflation(0.05), 72.0 / 7.0, 1e-12);
}

// chi-squared of 7 degrees of freedom exceeds 14.067 in 5 of 100 cases (any table).
TEST(VarianceComponent, InflatesOnlyBeyondTheQuantile) {
  EXPECT_EQ((VarianceComponent{14.06, 7}.Inflation(0.05)), 1.0);
  EXPECT_NEAR((VarianceComponent{14.08, 7}.Inflation(0.05)), 14.08 / 7, 1e-12);
  EXPECT_EQ((VarianceComponent{0.1, 7}.Inflation(0.05)), 1.0);
  EXPECT_EQ((VarianceComponent{1e6, 7}.Inflation(0.0)), 1.0);
}

TEST(VarianceComponent, TellsNothingWhereTheFitTookAllFreedom) {
  LinearSystem system;
  system.block_sizes = {1, 1};
  AddFactor({0}, {Scalar(1)}, Scalar(-3), system);
  AddFactor({0, 1}, {Scalar(1), Scalar(1)}, Scalar(-1), system);
  const VarianceComponent component = Estimate(AtSolution(system), {true, true});
  EXPECT_NEAR(component.redundancy, 0.0, 1e-12);
  EXPECT_EQ(component.Inflation(0.05), 1.0);
}

TEST(VarianceComponent, RejectsARightModelAsOftenAsItsLevelSays) {
  constexpr int kWalks = 2000, kKnots = 12;
  std::mt19937_64 generator(5);
  double squares = 0, redundancy = 0;
  int rejected = 0;
  for (int walk = 0; walk < kWalks; ++walk) {
    const VarianceComponent component =
        Estimate(ProcessAndWalk(kKnots, 1.0, &generator), FirstOf(kKnots, 2 * kKnots));
    squares += component.squares;
    redundancy += component.redundancy;
    rejected += component.Inflation(0.05) > 1.0 ? 1 : 0;
  }
  EXPECT_NEAR(squares / redundancy, 1.0, 0.03);
  EXPECT_NEAR(rejected / static_cast<double>(kWalks), 0.05, 0.025);
}

TEST(VarianceComponent, SeesAProcessThreeTimesAsLarge) {
  constexpr int kWalks = 200, kKnots = 12;
  std::mt19937_64 generator(6);
  int rejected = 0;
  for (int walk = 0; walk < kWalks; ++walk) {
    const VarianceComponent component =
        Estimate(ProcessAndWalk(kKnots, 3.0, &generator), FirstOf(kKnots, 2 * kKnots));
    rejected += component.Inflation(0.05) > 2.0 ? 1 : 0;
  }
  EXPECT_GT(rejected, 180);
}

TEST(VarianceComponent, InflatesTheGroupAlone) {
  std::mt19937_64 generator(7);
  const LinearSystem system = ProcessAndWalk(3, 1.0, &generator);
  LinearSystem inflated = system;
  InflateVariance(4.0, FirstOf(3, 6), &inflated);
  const MarginalCovariance before = *MarginalCovariance::Compute(system);
  const MarginalCovariance after = *MarginalCovariance::Compute(inflated);
  for (int block = 0; block < 6; ++block) {
    EXPECT_GT(after.block(block).covariance(0, 0), before.block(block).covariance(0, 0));
  }
  for (std::size_t i = 0; i < system.factors.size(); ++i) {
    const bool of_group = system.factors[i].blocks.back() < 3;
    const double expected = of_group ? 0.5 : 1.0;
    EXPECT_TRUE(inflated.factors[i].jacobian.isApprox(expected * system.factors[i].jacobian));
  }
}

// x + e = z with noise 0.5, e of standard deviation 2: x has 0.25 + (ratio 2)^2.
TEST(WidenBlocks, MultipliesTheStandardDeviationOfTheBlock) {
  LinearSystem system;
  system.block_sizes = {1, 1};
  AddFactor({0}, {Scalar(0.5)}, Scalar(0), system);
  AddFactor({0, 1}, {Scalar(2), Scalar(2)}, Scalar(1), system);
  WidenBlocks({3.0, 1.0}, {true, false}, &system);
  const MarginalCovariance marginals = *MarginalCovariance::Compute(system);
  EXPECT_NEAR(marginals.block(0).covariance(0, 0), 36.0, 1e-9);
  EXPECT_NEAR(marginals.block(1).covariance(0, 0), 36.25, 1e-9);
}

// Two places of one process, one of them off the survey: their correlation stays.
TEST(WidenBlocks, KeepsCorrelations) {
  LinearSystem system;
  system.block_sizes = {1, 1};
  AddFactor({0}, {Scalar(1)}, Scalar(0), system);
  AddFactor({0, 1}, {Scalar(-0.6 / 0.8), Scalar(1 / 0.8)}, Scalar(0), system);
  WidenBlocks({1.0, 4.0}, {true, true}, &system);
  const MarginalCovariance marginals = *MarginalCovariance::Compute(system);
  EXPECT_NEAR(marginals.block(1).covariance(0, 0), 16.0, 1e-9);
  EXPECT_NEAR(marginals.Joint(0, 1)->covariance(0, 1), 4 * 0.6, 1e-9);
}

}  // namespace
}  // namespace walkgraph
