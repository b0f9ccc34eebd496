#include "factors/area_field.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <optional>
#include <random>

#include "factors/area.h"

namespace walkgraph {
namespace {

double SegmentDistance(const Eigen::Vector2d& p, const Eigen::Vector2d& a,
                       const Eigen::Vector2d& b) {
  const double along = std::clamp((p - a).dot(b - a) / (b - a).squaredNorm(), 0.0, 1.0);
  return (p - a - along * (b - a)).norm();
}

// A room with a pillar.
Floor Room() {
  Floor floor;
  floor.outline = {{{0, 0}, {20, 0}, {20, 10}, {0, 10}}};
  floor.obstacles = {{{8, 4}, {12, 4}, {12, 6}, {8, 6}}};
  return floor;
}

double ExactDistance(const Floor& floor, const Eigen::Vector2d& p) {
  double nearest = std::numeric_limits<double>::infinity();
  for (const auto& rings : {floor.outline, floor.obstacles}) {
    for (const Polygon& ring : rings) {
      for (std::size_t i = 0; i < ring.size(); ++i) {
        nearest = std::min(nearest, SegmentDistance(p, ring[i], ring[(i + 1) % ring.size()]));
      }
    }
  }
  const bool inside = InsidePolygons(floor.outline, p) && !InsidePolygons(floor.obstacles, p);
  return inside ? -nearest : nearest;
}

TEST(AreaField, IsTheSignedDistanceToTheNearestWallWithinASquare) {
  const Floor room = Room();
  std::mt19937 random(3);
  std::uniform_real_distribution<double> x(-4, 24), y(-4, 14);
  double largest = 0;
  for (const double spacing : {0.5, 0.25}) {
    const AreaField field(WalkableRaster(room, spacing));
    for (int i = 0; i < 500; ++i) {
      const Eigen::Vector2d p(x(random), y(random));
      const double error = std::abs(field.At(p.x(), p.y()) - ExactDistance(room, p));
      EXPECT_LT(error, spacing) << p.transpose();
      largest = std::max(largest, error);
    }
  }
  EXPECT_GT(largest, 0);
}

TEST(AreaField, LeadsBackFromFarOutside) {
  const AreaField field(WalkableRaster(Room(), 0.5));
  EXPECT_NEAR(field.At(10.0, -100.0), 100, 0.5);
  EXPECT_NEAR(field.At(1020.0, 5.0), 1000, 0.5);
}

TEST(AreaField, SurveyedAreaEndsAtTheReachOfThePath) {
  std::vector<Eigen::Vector2d> path;
  for (int i = 0; i <= 20; ++i) path.emplace_back(i, 0);
  const AreaField field(PathRaster(path, 3, 0.25));
  EXPECT_NEAR(field.At(10.0, 7.0), 4, 0.25);
  EXPECT_NEAR(field.At(10.0, 3.0), 0, 0.25);
  EXPECT_LT(field.At(10.0, 0.0), -2.5);
  EXPECT_NEAR(field.At(25.0, 0.0), 2, 0.25);
}

TEST(AreaField, NothingKnownIsNoArea) {
  EXPECT_FALSE(HasInside(WalkableRaster({}, 0.5)));
  EXPECT_FALSE(HasInside(PathRaster({}, 3, 0.5)));
  EXPECT_TRUE(HasInside(WalkableRaster(Room(), 0.5)));
}

// Two floors of a room; stairs from (2, 2) on floor 0 to (8, 2) on floor 1, a lift to floor 2.
Site TwoStoreys() {
  Site site;
  for (const int number : {0, 1, 2}) {
    Floor floor = Room();
    floor.number = number;
    site.building.floors.push_back(floor);
  }
  site.building.connectors = {
      {"stairs", ConnectorKind::kStairs, {{0, {2, 2}}, {1, {8, 2}}}, 1.5},
      {"lift", ConnectorKind::kLift, {{0, {15, 5}}, {2, {15, 5}}}, 1.5},
  };
  return site;
}

TEST(WalkAreas, BetweenTwoFloorsIsNearWhatConnectsThem) {
  const Site site = TwoStoreys();
  AreaSettings settings;
  settings.connectors = true;
  const FloorPath path(std::vector<FloorStay>{{0, 0, 10}, {1, 20, 30}, {2, 40, 50}});
  WalkAreas areas(site, settings, path);
  // On a level the room; on the way up the stairs, and not the lift to another floor.
  ASSERT_NE(areas.At(5), nullptr);
  EXPECT_LT(areas.At(5)->At(3.0, 8.0), 0);
  ASSERT_NE(areas.At(15), nullptr);
  EXPECT_LT(areas.At(15)->At(5.0, 2.0), -1);
  EXPECT_NEAR(areas.At(15)->At(5.0, 6.5), 3, 0.5);
  EXPECT_GT(areas.At(15)->At(15.0, 5.0), 4);
  // Nothing is known to lead from floor 1 to floor 2.
  EXPECT_EQ(areas.At(35), nullptr);
  EXPECT_EQ(areas.At(16), areas.At(14));
  // By default a floor's area holds until the way to the next is half done.
  const AreaSettings plain;
  WalkAreas floors_only(site, plain, path);
  EXPECT_LT(floors_only.At(14)->At(3.0, 8.0), 0);
}

// Fields are kept for the next walk: of more floors than are kept, and of floors that differ by a
// wall alone, each still has its own.
TEST(AreaOfFloor, KeptFieldsAreThoseOfTheFloorThatIsAskedFor) {
  Site site;
  for (int number = 0; number < 15; ++number) {
    Floor floor = Room();
    floor.number = number;
    floor.obstacles.push_back({{1.0 + number, 0}, {2.0 + number, 0}, {1.5 + number, 9}});
    site.building.floors.push_back(floor);
  }
  for (const int number : {0, 1, 0, 14, 13, 12, 11, 10, 9, 8, 7, 6, 5, 4, 3, 2, 0, 1}) {
    const Floor* floor = site.building.FindFloor(number);
    const AreaField anew(WalkableRaster(*floor, 0.5));
    const std::optional<AreaField> kept = AreaOfFloor(site, number, {});
    ASSERT_TRUE(kept.has_value());
    for (double x = 0; x < 20; x += 0.7) EXPECT_EQ(kept->At(x, 1.0), anew.At(x, 1.0)) << number;
  }
}

TEST(AreaFactor, SaysNothingInsideAndItsDistanceInSigmasOutside) {
  const AreaFactor factor{AreaField(WalkableRaster(Room(), 0.5)), 2.0};
  const double inside[] = {3, 5}, pillar[] = {10, 5}, outside[] = {10, 14};
  double residual = -1;
  factor(inside, &residual);
  EXPECT_EQ(residual, 0);
  factor(pillar, &residual);
  EXPECT_NEAR(residual, 0.5, 0.125);
  factor(outside, &residual);
  EXPECT_NEAR(residual, 2, 0.125);
}

}  // namespace
}  // namespace walkgraph
