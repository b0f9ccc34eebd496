#include "frontends/radio_map/reading_lag.h"

#include <gtest/gtest.h>

#include "frontends/radio_map/site_file.h"

namespace walkgraph {
namespace {

TEST(ReadingLagTest, MovesReadingsOfItsRadioAndKeepsTheirAge) {
  Site site;
  site.reading_lag_s = {0.5, -0.25};
  Evidence evidence;
  evidence.transmitters = {{Radio::kWifi, "ap"}, {Radio::kBeacon, "tag"}};
  const TimeNs at = 1'560'000'000 * kNsPerSecond;
  evidence.readings = {{at, at + kNsPerSecond, 0, -60.0F}, {at + 1, at + 1, 1, -70.0F}};
  const Evidence aligned = AlignReadings(site, evidence);
  ASSERT_EQ(aligned.readings.size(), 2U);
  // In order of the new times: the beacon comes first.
  EXPECT_EQ(aligned.readings[0].transmitter, 1U);
  EXPECT_EQ(aligned.readings[0].heard_ns, at + 1 - kNsPerSecond / 4);
  EXPECT_EQ(aligned.readings[1].heard_ns, at + kNsPerSecond / 2);
  EXPECT_EQ(aligned.readings[1].printed_ns - aligned.readings[1].heard_ns, kNsPerSecond);
}

TEST(ReadingLagTest, IsKeptInTheSiteFile) {
  Site site;
  site.reading_lag_s = {1.25, -0.5};
  EXPECT_EQ(ParseSite(SerializeSite(site), "site").reading_lag_s, site.reading_lag_s);
}

}  // namespace
}  // namespace walkgraph
