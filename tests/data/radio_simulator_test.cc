#include <gtest/gtest.h>

#include <cmath>

#include "data/simulator/office_plan.h"
#include "data/simulator/radio.h"
#include "data/simulator/random.h"

namespace walkgraph {
namespace {

TEST(Random, NormalHasItsMoments) {
  Random random(11);
  constexpr int kCount = 200000;
  double sum = 0;
  double squares = 0;
  double fourth = 0;
  for (int i = 0; i < kCount; ++i) {
    const double x = random.Normal();
    sum += x;
    squares += x * x;
    fourth += x * x * x * x;
  }
  EXPECT_NEAR(sum / kCount, 0.0, 0.01);
  EXPECT_NEAR(squares / kCount, 1.0, 0.015);
  EXPECT_NEAR(fourth / kCount, 3.0, 0.12);
}

TEST(Random, ForksDifferFromEachOther) {
  const Random random(1);
  Random a = random.Fork(0);
  Random b = random.Fork(1);
  Random again = random.Fork(0);
  const double first = a.Uniform();
  EXPECT_NE(first, b.Uniform());
  EXPECT_EQ(first, again.Uniform());
}

// Over many fields: variance one, and correlation exp(-d / length) at one length and at three.
TEST(ShadowField, HasTheCorrelationItPromises) {
  Random random(5);
  constexpr int kFields = 4000;
  constexpr double kLengthM = 6.0;
  double variance = 0;
  double near = 0;
  double far = 0;
  for (int i = 0; i < kFields; ++i) {
    const ShadowField field = ShadowField::Planar(kLengthM, &random);
    const double here = field.At({3.0, 4.0, 0.0});
    variance += here * here;
    near += here * field.At({3.0 + kLengthM, 4.0, 0.0});
    far += here * field.At({3.0, 4.0 - 3.0 * kLengthM, 0.0});
  }
  EXPECT_NEAR(variance / kFields, 1.0, 0.07);
  EXPECT_NEAR(near / kFields, std::exp(-1.0), 0.06);
  EXPECT_NEAR(far / kFields, std::exp(-3.0), 0.06);
}

TEST(OfficePlan, CountsTheWallsOfAStraightLine) {
  const Plan plan = MakeSampleOffice();
  EXPECT_EQ(CountWallsBetween(plan, 0, {10.0, 6.2}, {20.0, 6.2}), 0);   // along a corridor
  EXPECT_EQ(CountWallsBetween(plan, 0, {10.0, 6.2}, {10.0, 4.0}), 1);   // into an office
  EXPECT_EQ(CountWallsBetween(plan, 0, {10.0, 6.2}, {10.0, 17.8}), 3);  // through two rooms between
  EXPECT_EQ(CountWallsBetween(plan, 0, {1.0, 2.0}, {43.0, 2.0}),
            7);  // through all southern offices
}

TEST(OfficePlan, CorridorsRunBetweenTheRooms) {
  const Plan plan = MakeSampleOffice();
  const Floor& floor = plan.building.floors.front();
  for (const WayLink& link : plan.links) {
    const Eigen::Vector2d a = plan.Node(link.from).position_m;
    const Eigen::Vector2d b = plan.Node(link.to).position_m;
    EXPECT_EQ(CountWallsBetween(plan, 0, a, b), 0);
    EXPECT_FALSE(InsidePolygons(floor.obstacles, 0.5 * (a + b)));
  }
}

}  // namespace
}  // namespace walkgraph
