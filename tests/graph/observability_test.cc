#include "graph/observability.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <limits>
#include <stdexcept>
#include <vector>

#include "graph/linear_problems.h"
#include "graph/walk_problem.h"

namespace walkgraph {
namespace {

using Eigen::MatrixXd;
using Eigen::VectorXd;
using testing::ElementsAre;
using testing::IsEmpty;

std::vector<BlockLabel> Labels(const WalkProblem& walk) {
  std::vector<BlockLabel> labels(walk.system.block_sizes.size());
  for (const int block : walk.position) labels[block] = {"position", {"x", "y"}};
  for (const int block : walk.heading) labels[block] = {"heading", {}};
  for (const int block : walk.bias) labels[block] = {"gyro_bias", {}};
  for (const int block : walk.map_error) labels[block] = {"map_error", {"x", "y"}};
  labels[walk.step_scale] = {"step_scale", {}};
  return labels;
}

TEST(ObservabilityTest, WholeWalkIsObservable) {
  const WalkProblem walk = MakeWalk({.nodes = 50});
  const auto report = AnalyzeObservability(walk.system, Labels(walk));
  ASSERT_TRUE(report.has_value());
  EXPECT_EQ(report->nullity, 0);
  EXPECT_THAT(report->directions, IsEmpty());
}

// gtsam 550: the states and the missing factor have names.
TEST(ObservabilityTest, TranslationIsNamedWithTheMissingFactor) {
  const WalkProblem walk = MakeWalk({.nodes = 50, .positions = false});
  const auto report = AnalyzeObservability(walk.system, Labels(walk));
  ASSERT_TRUE(report.has_value());
  EXPECT_EQ(report->nullity, 2);
  ASSERT_EQ(report->directions.size(), 1u);
  const UnobservableDirections& translation = report->directions[0];
  EXPECT_EQ(translation.dimension, 2);
  ASSERT_EQ(translation.movements.size(), 1u);
  EXPECT_NEAR(translation.movements[0].share, 1, 1e-9);
  EXPECT_EQ(translation.movements[0].blocks, 50);
  EXPECT_EQ(translation.movements[0].first_block, walk.position.front());
  EXPECT_EQ(translation.movements[0].last_block, walk.position.back());
  EXPECT_THAT(DescribeObservability(*report, {{"position", {"fingerprint", "position_anchor"}}}),
              ElementsAre("unobservable: position along (x, y); no factor of type fingerprint or "
                          "position_anchor"));
}

TEST(ObservabilityTest, RotationMovesHeadingAndPositionTogether) {
  const WalkProblem walk = MakeWalk({.nodes = 50, .positions = false, .headings = false});
  const auto report = AnalyzeObservability(walk.system, Labels(walk));
  ASSERT_TRUE(report.has_value());
  EXPECT_EQ(report->nullity, 3);
  ASSERT_EQ(report->directions.size(), 2u);
  EXPECT_EQ(report->directions[0].dimension, 2);
  EXPECT_EQ(report->directions[1].dimension, 1);
  std::vector<std::string> kinds;
  for (const KindMovement& movement : report->directions[1].movements) {
    EXPECT_EQ(movement.blocks, 50);
    kinds.push_back(movement.kind);
  }
  EXPECT_THAT(kinds, testing::UnorderedElementsAre("heading", "position"));
}

TEST(ObservabilityTest, SingleAxisIsNamedAlone) {
  LinearSystem system{{2, 2}, {}};
  AddFactor({0, 1}, {-MatrixXd::Identity(2, 2), MatrixXd::Identity(2, 2)}, VectorXd::Zero(2),
            system);
  AddFactor({0}, {Eigen::RowVector2d(5, 0)}, VectorXd::Zero(1), system);
  const auto report =
      AnalyzeObservability(system, {{"position", {"x", "y"}}, {"position", {"x", "y"}}});
  ASSERT_TRUE(report.has_value());
  EXPECT_THAT(DescribeObservability(*report, {}), ElementsAre("unobservable: position along (y)"));
}

TEST(ObservabilityTest, ScaleAndOffsetThatTradeAreNamedTogether) {
  // Only the sum of a height and a barometric offset is measured, at three nodes.
  LinearSystem system{{1, 1, 1, 1}, {}};
  const MatrixXd one = MatrixXd::Ones(1, 1);
  for (int node = 0; node < 3; ++node) {
    AddFactor({node, 3}, {one / 0.1, one / 0.1}, VectorXd::Zero(1), system);
  }
  const auto report = AnalyzeObservability(
      system, {{"height", {}}, {"height", {}}, {"height", {}}, {"baro_offset", {}}});
  ASSERT_TRUE(report.has_value());
  EXPECT_EQ(report->nullity, 1);
  ASSERT_EQ(report->directions.size(), 1u);
  const auto& movements = report->directions[0].movements;
  ASSERT_EQ(movements.size(), 2u);
  // In sigmas: three heights move by 10 each, the offset by 10 sqrt(3).
  EXPECT_NEAR(movements[0].share, 0.5, 1e-9);
  EXPECT_NEAR(movements[1].share, 0.5, 1e-9);
}

TEST(ObservabilityTest, PartOfTheWalkThatHangsLooseIsLocated) {
  // No measurement in the second half, and the step between nodes 24 and 25 is missing.
  WalkProblem walk = MakeWalk({.nodes = 50});
  std::erase_if(walk.system.factors, [&](const LinearFactor& factor) {
    const int first = factor.blocks[0];
    const bool late_position = factor.blocks.size() == 2 && first >= walk.position[25] &&
                               walk.system.block_sizes[first] == 2 && first != walk.map_error[1];
    return late_position || (factor.blocks.size() == 4 && first == walk.position[24]);
  });
  const auto report = AnalyzeObservability(walk.system, Labels(walk));
  ASSERT_TRUE(report.has_value());
  ASSERT_EQ(report->directions.size(), 1u);
  const KindMovement& movement = report->directions[0].movements[0];
  EXPECT_EQ(movement.kind, "position");
  EXPECT_EQ(movement.first_block, walk.position[25]);
  EXPECT_EQ(movement.last_block, walk.position[49]);
  EXPECT_EQ(movement.blocks, 25);
}

TEST(ObservabilityTest, ManyLooseBlocksAreCountedAndEveryKindIsNamed) {
  LinearSystem system;
  std::vector<BlockLabel> labels;
  for (int i = 0; i < 400; ++i) {
    system.block_sizes.push_back(2);
    labels.push_back(i % 2 == 0 ? BlockLabel{"position", {"x", "y"}} : BlockLabel{"map_error", {}});
  }
  const auto report = AnalyzeObservability(system, labels);
  ASSERT_TRUE(report.has_value());
  EXPECT_EQ(report->nullity, 800);
  EXPECT_THAT(DescribeObservability(*report, {}),
              ElementsAre("unobservable: position along (x, y)", "unobservable: map_error"));
}

TEST(ObservabilityTest, NonFiniteAndUnlabelledSystemsAreRefused) {
  LinearSystem system{{1}, {}};
  AddFactor({0}, {MatrixXd::Constant(1, 1, std::numeric_limits<double>::infinity())},
            VectorXd::Zero(1), system);
  EXPECT_FALSE(AnalyzeObservability(system, {{"height", {}}}).has_value());
  EXPECT_THROW(AnalyzeObservability(system, {}), std::invalid_argument);
}

}  // namespace
}  // namespace walkgraph
