#include "solvers/baselines/reference_points.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <stdexcept>

namespace walkgraph {
namespace {

// A floor of 30 x 20 m with one shop, surveyed along y = 10.
Site MakeSite() {
  Site site;
  Floor floor;
  floor.number = 2;
  floor.max_corner = {30, 20};
  floor.outline = {{{0, 0}, {30, 0}, {30, 20}, {0, 20}}};
  floor.obstacles = {{{9, 0}, {21, 0}, {21, 8}, {9, 8}}};
  site.building.floors.push_back(floor);
  for (double x = 2; x <= 28; ++x) site.path.push_back({{x, 10}, 2, 0});
  return site;
}

double DistanceToPath(const Eigen::Vector2d& position) {
  return (position - Eigen::Vector2d(std::clamp(position.x(), 2.0, 28.0), 10)).norm();
}

TEST(ReferencePoints, CoverTheSurveyAndNothingElse) {
  const ReferencePoints points(MakeSite(), 2, {ReferenceArea::kSurveyed, 1.0, 3.0});
  for (const Eigen::Vector2d& position : points.positions_m()) {
    // The path is a row of points 1 m apart.
    EXPECT_LE(DistanceToPath(position), 3.0);
  }
  int expected = 0;
  for (double y = 0.5; y < 20; ++y) {
    for (double x = 0.5; x < 30; ++x) expected += DistanceToPath({x, y}) <= 2.9 ? 1 : 0;
  }
  EXPECT_GE(static_cast<int>(points.size()), expected);
}

TEST(ReferencePoints, WalkableAreaIsTheOutlineWithoutItsShops) {
  const ReferencePoints points(MakeSite(), 2, {ReferenceArea::kWalkable, 1.0, 3.0});
  EXPECT_EQ(points.size(), 30U * 20U - 12U * 8U);
  Site unknown = MakeSite();
  unknown.building.floors.clear();
  const ReferencePoints surveyed(unknown, 2, {ReferenceArea::kWalkable, 1.0, 3.0});
  ASSERT_FALSE(surveyed.empty());
  for (const Eigen::Vector2d& position : surveyed.positions_m()) {
    EXPECT_LE(DistanceToPath(position), 3.0);
  }
}

TEST(ReferencePoints, KnowTheirCellsAndNeighbours) {
  const ReferencePoints points(MakeSite(), 2, {ReferenceArea::kWalkable, 3.0, 3.0});
  for (std::size_t i = 0; i < points.size(); ++i) {
    EXPECT_EQ(points.IndexAt(points.cell(i)), static_cast<int>(i));
  }
  EXPECT_EQ(points.IndexAt({-1, 0}), -1);
  EXPECT_EQ(points.IndexAt({1000, 0}), -1);
  const Eigen::Vector2d at(5.2, 12.1);
  int visited = 0;
  points.ForNear(at, 4.5, [&](int i) {
    EXPECT_LE((points.positions_m()[static_cast<std::size_t>(i)] - at).norm(), 4.5);
    ++visited;
  });
  const auto near =
      std::count_if(points.positions_m().begin(), points.positions_m().end(),
                    [&](const Eigen::Vector2d& position) { return (position - at).norm() <= 4.5; });
  EXPECT_EQ(visited, near);
}

TEST(ReferencePoints, AreNoneWhereNobodySurveyed) {
  EXPECT_TRUE(ReferencePoints(MakeSite(), 7, {}).empty());
  EXPECT_THROW(ReferencePoints(MakeSite(), 2, {ReferenceArea::kSurveyed, 0.0, 3.0}),
               std::invalid_argument);
}

}  // namespace
}  // namespace walkgraph
