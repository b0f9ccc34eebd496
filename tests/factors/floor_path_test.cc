#include "factors/floor_path.h"

#include <gtest/gtest.h>

#include <limits>
#include <stdexcept>
#include <utility>

namespace walkgraph {
namespace {

TEST(FloorPath, OneFloorHoldsForever) {
  const FloorPath path = 3;
  for (const TimeNs time : {TimeNs{0}, std::numeric_limits<TimeNs>::max() / 8}) {
    EXPECT_EQ(path.At(time), 3);
    EXPECT_TRUE(path.OnLevel(time));
  }
  EXPECT_EQ(path.Floors(), std::vector<int>{3});
}

TEST(FloorPath, BetweenStaysTheNearerOneCounts) {
  const FloorPath path(std::vector<FloorStay>{{0, 10, 20}, {-1, 30, 90}, {0, 100, 110}});
  EXPECT_EQ(path.At(0), 0);
  EXPECT_EQ(path.At(24), 0);
  EXPECT_EQ(path.At(25), 0);
  EXPECT_EQ(path.At(26), -1);
  EXPECT_EQ(path.At(1000), 0);
  EXPECT_TRUE(path.OnLevel(20));
  EXPECT_FALSE(path.OnLevel(21));
  EXPECT_FALSE(path.OnLevel(9));
  EXPECT_EQ(path.Floors(), (std::vector<int>{-1, 0}));
  EXPECT_EQ(path.Main(), -1);
}

TEST(FloorPath, KnowsBetweenWhichFloorsTheWayLeads) {
  const FloorPath path(std::vector<FloorStay>{{0, 10, 20}, {-1, 30, 90}, {2, 100, 110}});
  using Floors = std::pair<int, int>;
  EXPECT_EQ(path.Between(5), Floors(0, 0));
  EXPECT_EQ(path.Between(20), Floors(0, 0));
  EXPECT_EQ(path.Between(21), Floors(0, -1));
  EXPECT_EQ(path.Between(29), Floors(0, -1));
  EXPECT_EQ(path.Between(30), Floors(-1, -1));
  EXPECT_EQ(path.Between(95), Floors(-1, 2));
  EXPECT_EQ(path.Between(1000), Floors(2, 2));
}

TEST(FloorPath, RefusesWhatIsNoPath) {
  EXPECT_THROW(FloorPath(std::vector<FloorStay>{}), std::invalid_argument);
  EXPECT_THROW(FloorPath(std::vector<FloorStay>{{0, 20, 10}}), std::invalid_argument);
  EXPECT_THROW(FloorPath(std::vector<FloorStay>{{0, 0, 20}, {1, 20, 30}}), std::invalid_argument);
}

}  // namespace
}  // namespace walkgraph
