#include "eval/cross_validation.h"

#include <gtest/gtest.h>

#include <array>
#include <set>

namespace walkgraph {
namespace {

Truth Between(double begin_s, const Eigen::Vector2d& from, double end_s,
              const Eigen::Vector2d& to) {
  return {TruthFrame::kBuilding, {{DurationNs(begin_s), from, 0}, {DurationNs(end_s), to, 0}}};
}

TEST(CrossValidation, SessionsAreChainsInTimeAndPlace) {
  const Truth first = Between(0, {0, 0}, 30, {10, 0});
  const Truth second = Between(80, {10.5, 0}, 120, {20, 0});  // 50 s and 0.5 m later
  const Truth third = Between(130, {20, 0.9}, 150, {30, 0});  // continues the second
  const Truth far = Between(155, {33, 0}, 170, {40, 0});      // 3 m from the third's end
  const Truth late = Between(240, {40, 0}, 260, {50, 0});     // 70 s after `far`
  const std::vector<WalkToSplit> walks = {{"e", "", "", &late},
                                          {"c", "", "", &third},
                                          {"a", "", "", &first},
                                          {"d", "", "", &far},
                                          {"b", "", "", &second}};
  EXPECT_EQ(GroupWalks(walks, SplitBy::kSession),
            (std::vector<std::string>{"e", "a", "a", "d", "a"}));
}

TEST(CrossValidation, SessionsStayOnTheirFloor) {
  const Truth first = Between(0, {0, 0}, 30, {10, 0});
  Truth above = Between(40, {10, 0}, 60, {20, 0});
  for (Waypoint& waypoint : above.waypoints) waypoint.floor = 1;
  EXPECT_EQ(GroupWalks({{"a", "", "", &first}, {"b", "", "", &above}}, SplitBy::kSession),
            (std::vector<std::string>{"a", "b"}));
}

TEST(CrossValidation, GroupsByTrialPhoneAndBlock) {
  const Truth here = Between(0, {1, 1}, 9, {17, 3});
  const Truth near = Between(0, {30, 2}, 9, {2, 20});   // mean (16, 11): the same square
  const Truth away = Between(0, {21, 1}, 9, {25, 19});  // the square to the right
  const Truth nowhere;
  const std::vector<WalkToSplit> walks = {{"a", "t1", "p", &here},
                                          {"b", "t1", "q", &near},
                                          {"c", "t2", "p", &away},
                                          {"d", "t2", "p", &nowhere}};
  EXPECT_EQ(GroupWalks(walks, SplitBy::kTrial), (std::vector<std::string>{"t1", "t1", "t2", "t2"}));
  EXPECT_EQ(GroupWalks(walks, SplitBy::kPhone), (std::vector<std::string>{"p", "q", "p", "p"}));
  const std::vector<std::string> blocks = GroupWalks(walks, SplitBy::kBlock);
  EXPECT_EQ(blocks[0], blocks[1]);
  EXPECT_NE(blocks[0], blocks[2]);
  EXPECT_EQ(blocks[3], "d");
}

TEST(CrossValidation, FoldsAreOfAboutEqualSize) {
  constexpr int kFolds = 5, kGroups = 5000;
  std::array<int, kFolds> sizes{};
  for (int i = 0; i < kGroups; ++i) ++sizes[FoldOfGroup("walk " + std::to_string(i), kFolds)];
  // 1000 expected, standard deviation 28.
  for (const int size : sizes) EXPECT_NEAR(size, kGroups / kFolds, 4 * 28);
}

Evidence Heard(const std::string& transmitter, Radio radio, std::vector<TimeNs> times) {
  Evidence evidence;
  evidence.transmitters = {{radio, "unheard"}, {radio, transmitter}};
  for (const TimeNs time : times) evidence.readings.push_back({time, time, 1, -60});
  return evidence;
}

TEST(CrossValidation, RemovesOnlyReadingsOfTheSameTransmitterAndTime) {
  HeardReadings heard;
  heard.Add(Heard("x", Radio::kWifi, {100, 200}));
  heard.Freeze();
  Evidence same = Heard("x", Radio::kWifi, {50, 200, 300});
  EXPECT_EQ(heard.RemoveFrom(&same), 1);
  ASSERT_EQ(same.readings.size(), 2u);
  EXPECT_EQ(same.readings[0].heard_ns, 50);
  EXPECT_EQ(same.readings[1].heard_ns, 300);
  Evidence other = Heard("y", Radio::kWifi, {100, 200});
  EXPECT_EQ(heard.RemoveFrom(&other), 0);
  Evidence other_radio = Heard("x", Radio::kBeacon, {100, 200});
  EXPECT_EQ(heard.RemoveFrom(&other_radio), 0);
}

}  // namespace
}  // namespace walkgraph
