#include "data/formats/time_order.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace walkgraph {
namespace {

using testing::ElementsAre;

std::vector<TimeNs> Seconds(const std::vector<double>& seconds) {
  std::vector<TimeNs> times;
  for (const double s : seconds) times.push_back(DurationNs(s));
  return times;
}

TEST(OrderByTime, LeavesOrderedTimesAlone) {
  ReadReport report;
  EXPECT_FALSE(OrderByTime(Seconds({1, 2, 3}), EqualTimes::kDrop, &report).has_value());
  EXPECT_FALSE(OrderByTime(Seconds({1, 1, 3}), EqualTimes::kKeep, &report).has_value());
  EXPECT_TRUE(report.hazards.empty());
}

TEST(OrderByTime, SortsALateSampleIntoItsPlace) {
  ReadReport report;
  const auto order = OrderByTime(Seconds({1.0, 1.2, 1.1, 1.3}), EqualTimes::kDrop, &report);
  EXPECT_THAT(order.value(), ElementsAre(0, 2, 1, 3));
  EXPECT_EQ(report.HazardCount("reordered"), 1);
}

TEST(OrderByTime, AWildTimeCostsOneSampleWhicheverWayItPoints) {
  for (const double wild : {-5000.0, 5000.0}) {
    ReadReport report;
    const auto order = OrderByTime(Seconds({1, 2, wild, 3, 4}), EqualTimes::kDrop, &report);
    EXPECT_THAT(order.value(), ElementsAre(0, 1, 3, 4));
    EXPECT_EQ(report.HazardCount("backward_time"), 1);
  }
}

// A clock that is set back by ten seconds says some times twice: one of the two passages goes, and
// what is left runs forward.
TEST(OrderByTime, AClockSetBackLosesThePassageThatItRepeats) {
  std::vector<TimeNs> times;
  for (int i = 0; i < 300; ++i) times.push_back(DurationNs(0.1 * i));
  for (int i = 200; i < 600; ++i) times.push_back(DurationNs(0.1 * i) + 1);
  ReadReport report;
  const auto order = OrderByTime(times, EqualTimes::kDrop, &report);
  ASSERT_TRUE(order.has_value());
  EXPECT_GT(order->size(), 580U);
  EXPECT_EQ(order->size() + static_cast<std::size_t>(report.HazardCount("backward_time")),
            times.size());
  for (std::size_t i = 1; i < order->size(); ++i) {
    EXPECT_LT(times[(*order)[i - 1]], times[(*order)[i]]);
  }
}

TEST(OrderByTime, KeepsTheFirstOfEqualTimes) {
  ReadReport report;
  const auto order = OrderByTime(Seconds({1, 2, 2, 2, 3}), EqualTimes::kDrop, &report);
  EXPECT_THAT(order.value(), ElementsAre(0, 1, 4));
  EXPECT_EQ(report.HazardCount("duplicate_time"), 2);
}

}  // namespace
}  // namespace walkgraph
