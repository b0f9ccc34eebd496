#include "frontends/readings.h"

#include <gtest/gtest.h>

namespace walkgraph {
namespace {

Recording WithRows(std::vector<RadioRow> rows) {
  Recording recording;
  recording.begin_ns = 100;
  recording.end_ns = 1000;
  recording.transmitters = {{Radio::kWifi, "aa"}, {Radio::kWifi, "bb"}, {Radio::kBeacon, "cc"}};
  recording.radio_rows = std::move(rows);
  return recording;
}

TEST(Readings, EachOnceAtTheTimeItWasHeard) {
  const Recording recording = WithRows({
      {.printed_ns = 200, .heard_ns = 190, .transmitter = 1, .rssi_dbm = -60},
      {.printed_ns = 200, .heard_ns = 150, .transmitter = 0, .rssi_dbm = -50},
      {.printed_ns = 300, .heard_ns = 150, .transmitter = 0, .rssi_dbm = -50},
      {.printed_ns = 300, .heard_ns = 290, .transmitter = 1, .rssi_dbm = -70},
      {.printed_ns = 400, .heard_ns = 150, .transmitter = 0, .rssi_dbm = -50},
      {.printed_ns = 400, .heard_ns = 190, .transmitter = 2, .rssi_dbm = -80},
  });
  std::map<std::string, std::int64_t> counts;
  const auto readings = UniqueReadings(recording, &counts);
  ASSERT_EQ(readings.size(), 4u);
  EXPECT_EQ(readings[0].transmitter, 0u);
  EXPECT_EQ(readings[0].heard_ns, 150);
  EXPECT_EQ(readings[0].printed_ns, 200);
  EXPECT_EQ(readings[1].transmitter, 1u);
  EXPECT_EQ(readings[2].transmitter, 2u);  // same time, larger transmitter
  EXPECT_EQ(readings[3].heard_ns, 290);
  EXPECT_EQ(counts.at("wifi_repeat"), 2);
  EXPECT_EQ(counts.count("beacon_repeat"), 0u);
}

TEST(Readings, ThoseFromBeforeTheRecordingAreDroppedOnceEach) {
  const Recording recording = WithRows({
      {.printed_ns = 110, .heard_ns = 99, .transmitter = 0, .rssi_dbm = -50},
      {.printed_ns = 120, .heard_ns = 99, .transmitter = 0, .rssi_dbm = -50},
      {.printed_ns = 120, .heard_ns = 100, .transmitter = 2, .rssi_dbm = -50},
  });
  std::map<std::string, std::int64_t> counts;
  const auto readings = UniqueReadings(recording, &counts);
  ASSERT_EQ(readings.size(), 1u);
  EXPECT_EQ(readings[0].transmitter, 2u);
  EXPECT_EQ(counts.at("wifi_before_begin"), 1);
  EXPECT_EQ(counts.at("wifi_repeat"), 1);
}

TEST(Readings, ClocksThatDisagreeAreCounted) {
  const Recording recording =
      WithRows({{.printed_ns = 200, .heard_ns = 260, .transmitter = 2, .rssi_dbm = -50}});
  std::map<std::string, std::int64_t> counts;
  const auto readings = UniqueReadings(recording, &counts);
  ASSERT_EQ(readings.size(), 1u);
  EXPECT_EQ(readings[0].heard_ns, 200);
  EXPECT_EQ(counts.at("beacon_heard_after_printed"), 1);
}

TEST(Readings, EveryRowIsAReadingOrACount) {
  std::vector<RadioRow> rows;
  for (int i = 0; i < 300; ++i) {
    rows.push_back({.printed_ns = 100 + i,
                    .heard_ns = 90 + (i * 7) % 40,
                    .transmitter = static_cast<std::uint32_t>(i % 3),
                    .rssi_dbm = -60});
  }
  std::map<std::string, std::int64_t> counts;
  const auto readings = UniqueReadings(WithRows(rows), &counts);
  std::size_t total = readings.size();
  for (const auto& [name, count] : counts) {
    if (name.find("heard_after") == std::string::npos) total += static_cast<std::size_t>(count);
  }
  EXPECT_EQ(total, rows.size());
}

}  // namespace
}  // namespace walkgraph
