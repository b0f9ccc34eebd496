#include "data/formats/java_date.h"

#include <gtest/gtest.h>

namespace walkgraph {
namespace {

TEST(JavaDate, IsUnixTime) {
  // `date -u -d 'Wed Jun 14 08:00:58 UTC 2023' +%s`
  EXPECT_EQ(ParseJavaDate("Wed Jun 14 10:00:58 GMT+02:00 2023"), 1'686'729'658 * kNsPerSecond);
  EXPECT_EQ(ParseJavaDate("Wed Jun 14 03:30:58 GMT-04:30 2023"), 1'686'729'658 * kNsPerSecond);
  EXPECT_EQ(ParseJavaDate("Thu Jan 01 00:00:00 GMT+00:00 1970"), 0);
  EXPECT_EQ(ParseJavaDate("Wed Jun 14 08:00:58 UTC 2023"), 1'686'729'658 * kNsPerSecond);
}

TEST(JavaDate, IsNoneOfAnythingElse) {
  for (const char* text :
       {"", "2023-06-14", "Wed Jun", "Wed unJ 14 10:00:58 GMT 2023", "Wed Jun 31 10:00:58 GMT 2023",
        "Wed Jun 14 25:00:58 GMT 2023", "Wed Jun 14 10:00 GMT 2023",
        "Wed Jun 14 10:00:58 GMT+02:00", "Wed JunJul 14 10:00:58 GMT 2023"}) {
    EXPECT_FALSE(ParseJavaDate(text).has_value()) << text;
  }
}

}  // namespace
}  // namespace walkgraph
