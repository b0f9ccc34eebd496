#include "solvers/baselines/way_graph.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cstdint>
#include <vector>

namespace walkgraph {
namespace {

using Eigen::Vector2d;

// A crossing at (10, 0) with arms of 10 m west, 20 m east, and 6 m north.
WayNetwork Crossing() { return {{{0, 0}, {10, 0}, {30, 0}, {10, 6}}, {{0, 1}, {1, 2}, {1, 3}}}; }

std::vector<Vector2d> ReachFrom(const WayGraph& graph, const Vector2d& from, double distance_m) {
  std::vector<Vector2d> places;
  for (const WayCandidate& candidate : graph.Reach(graph.Project(from), distance_m)) {
    places.push_back(graph.PositionOf(candidate.at));
    EXPECT_NEAR(candidate.direction.norm(), 1, 1e-12);
  }
  std::sort(places.begin(), places.end(), [](const Vector2d& a, const Vector2d& b) {
    return a.x() != b.x() ? a.x() < b.x() : a.y() < b.y();
  });
  return places;
}

void ExpectPlaces(const std::vector<Vector2d>& found, const std::vector<Vector2d>& expected) {
  ASSERT_EQ(found.size(), expected.size());
  for (std::size_t i = 0; i < found.size(); ++i) {
    EXPECT_NEAR((found[i] - expected[i]).norm(), 0, 1e-9) << found[i].transpose();
  }
}

TEST(WayGraph, OffersTwoPlacesOnALinkAndOnePerLinkBeyondACrossing) {
  const WayGraph graph(Crossing());
  ExpectPlaces(ReachFrom(graph, {5, 1}, 2), {{3, 0}, {7, 0}});
  ExpectPlaces(ReachFrom(graph, {8, 0}, 5), {{3, 0}, {10, 3}, {13, 0}});
  // At the crossing itself: one per link.
  ExpectPlaces(ReachFrom(graph, {10, 0}, 2), {{8, 0}, {10, 2}, {12, 0}});
  // Past the crossing to the dead end in the north.
  ExpectPlaces(ReachFrom(graph, {8, 0}, 9), {{0, 0}, {10, 6}, {17, 0}});
}

TEST(WayGraph, StaysWhereNobodyMoves) {
  const WayGraph graph(Crossing());
  for (const Vector2d& place : ReachFrom(graph, {5, 0}, 0))
    EXPECT_NEAR((place - Vector2d(5, 0)).norm(), 0, 1e-12);
}

TEST(WayGraph, ComesToAnEndOnARing) {
  const WayGraph ring({{{0, 0}, {4, 0}, {4, 4}, {0, 4}}, {{0, 1}, {1, 2}, {2, 3}, {3, 0}}});
  ExpectPlaces(ReachFrom(ring, {2, 0}, 5), {{0, 3}, {4, 3}});
  EXPECT_LE(ring.Reach(ring.Project({2, 0}), 1000).size(), 8U);
}

TEST(WayGraph, ProjectsOntoTheNearestLink) {
  const WayGraph graph(Crossing());
  EXPECT_NEAR((graph.PositionOf(graph.Project({12, 5})) - Vector2d(10, 5)).norm(), 0, 1e-12);
  EXPECT_NEAR((graph.PositionOf(graph.Project({40, 3})) - Vector2d(30, 0)).norm(), 0, 1e-12);
}

void AddWalk(const Vector2d& from, const Vector2d& to, std::uint32_t walk,
             std::vector<SurveyPoint>* path) {
  const int metres = static_cast<int>((to - from).norm());
  for (int m = 0; m <= metres; ++m) path->push_back({from + m * (to - from) / metres, 1, walk});
}

TEST(WaysFromSurvey, FindTheCrossingOfTwoStraightWalks) {
  std::vector<SurveyPoint> path;
  AddWalk({0, 0}, {40, 0}, 0, &path);
  AddWalk({20, -20}, {20, 20}, 1, &path);
  AddWalk({20, 0.5}, {0, 0.5}, 2, &path);  // back along the first: no new way
  const WayNetwork ways = WaysFromSurvey(path, 1, 3, 0.35);
  const WayGraph graph(ways);
  // Every survey point lies on or beside a way, and from the crossing there are four ways.
  for (const SurveyPoint& point : path) {
    const Vector2d at = graph.PositionOf(graph.Project(point.position_m));
    EXPECT_LT((at - point.position_m).norm(), 2);
  }
  std::vector<std::size_t> degree(ways.nodes.size(), 0);
  for (const auto& [from, to] : ways.links) {
    ++degree[static_cast<std::size_t>(from)];
    ++degree[static_cast<std::size_t>(to)];
  }
  EXPECT_EQ(std::count(degree.begin(), degree.end(), 1U), 4);
  EXPECT_EQ(std::count(degree.begin(), degree.end(), 4U), 1);
  EXPECT_LE(ways.links.size(), 8U);
}

TEST(WaysFromSurvey, WalksThatOnlyFollowEachOtherInTheListAreNotLinked) {
  std::vector<SurveyPoint> path;
  AddWalk({0, 0}, {20, 0}, 0, &path);
  AddWalk({0, 30}, {20, 30}, 1, &path);
  path.push_back({{50, 50}, 2, 2});  // another floor
  const WayNetwork ways = WaysFromSurvey(path, 1, 3, 0.35);
  EXPECT_EQ(ways.nodes.size(), 4U);
  EXPECT_EQ(ways.links.size(), 2U);
  EXPECT_TRUE(WaysFromSurvey(path, 3, 3, 0.35).empty());
}

TEST(FindWays, PrefersWhatTheBuildingKnows) {
  Site site;
  AddWalk({0, 0}, {20, 0}, 0, &site.path);
  EXPECT_EQ(FindWays(site, 1, 3, 0.35).links.size(), 1U);
  site.building.floors.resize(1);
  site.building.floors[0].number = 1;
  site.building.floors[0].ways = Crossing();
  EXPECT_EQ(FindWays(site, 1, 3, 0.35).links.size(), 3U);
}

}  // namespace
}  // namespace walkgraph
