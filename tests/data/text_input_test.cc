#include "data/formats/text_input.h"

#include <gtest/gtest.h>

#include <cmath>
#include <string>
#include <vector>

#include "data/simulator/random.h"

namespace walkgraph {
namespace {

TEST(ParseDouble, RoundsEveryShortDecimalAsStrtodDoes) {
  Random random(7);
  for (int i = 0; i < 200000; ++i) {
    std::string text = random.Uniform() < 0.5 ? "-" : "";
    const int digits = 1 + random.Index(14);
    const int point = random.Index(digits + 1);
    for (int k = 0; k < digits; ++k) {
      if (k == point && k > 0) text += '.';
      text += static_cast<char>('0' + random.Index(10));
    }
    double value = 0;
    ASSERT_TRUE(ParseDouble(text, &value)) << text;
    ASSERT_EQ(value, std::strtod(text.c_str(), nullptr)) << text;
  }
}

TEST(ParseDouble, TakesWhatSensorsPrintAndNothingElse) {
  double value = 0;
  ASSERT_TRUE(ParseDouble("-6.2561035E-4", &value));
  EXPECT_EQ(value, -6.2561035e-4);
  ASSERT_TRUE(ParseDouble("120.07651399999799", &value));
  EXPECT_EQ(value, 120.07651399999799);
  ASSERT_TRUE(ParseDouble("-0", &value));
  EXPECT_TRUE(std::signbit(value));
  ASSERT_TRUE(ParseDouble("NaN", &value));
  EXPECT_TRUE(std::isnan(value));
  ASSERT_TRUE(ParseDouble("-inf", &value));
  EXPECT_TRUE(std::isinf(value));
  ASSERT_TRUE(ParseDouble("1e999", &value));
  EXPECT_FALSE(std::isfinite(value));
  for (const char* text :
       {"", "-", ".", "-.", "1.2.3", "1,5", " 1", "1 ", "+1", "0x10", "1e", "--1"}) {
    EXPECT_FALSE(ParseDouble(text, &value)) << "'" << text << "'";
  }
}

TEST(ParseSecondsNs, IsExactWhereADoubleIsNot) {
  TimeNs time = 0;
  ASSERT_TRUE(ParseSecondsNs("1686739902.999000001", &time));
  EXPECT_EQ(time, 1686739902999000001);
  ASSERT_TRUE(ParseSecondsNs("0.0688", &time));
  EXPECT_EQ(time, 68'800'000);
  ASSERT_TRUE(ParseSecondsNs("-2.5", &time));
  EXPECT_EQ(time, -2'500'000'000);
  ASSERT_TRUE(ParseSecondsNs("-0.25", &time));
  EXPECT_EQ(time, -250'000'000);
  ASSERT_TRUE(ParseSecondsNs("3.1234567899", &time));
  EXPECT_EQ(time, 3'123'456'789);
  ASSERT_TRUE(ParseSecondsNs("61", &time));
  EXPECT_EQ(time, 61 * kNsPerSecond);
}

TEST(ParseTimes, RejectWhatWouldOverflow) {
  TimeNs time = 0;
  EXPECT_TRUE(ParseMillisecondsNs("1574559495260", &time));
  EXPECT_EQ(time, 1574559495260 * kNsPerMs);
  for (const char* text :
       {"9999999999999999", "99999999999999999999", "-9999999999999999", "1.5", ""}) {
    EXPECT_FALSE(ParseMillisecondsNs(text, &time)) << text;
  }
  for (const char* text : {"99999999999", "999999999999999", "1e3", "", "-", "--1", "1.x", ".5"}) {
    EXPECT_FALSE(ParseSecondsNs(text, &time)) << text;
  }
  EXPECT_FALSE(ParseNanosecondsNs("9223372036854775807", &time));
}

TEST(LineReader, EndsLinesAtBothTerminatorsAndKnowsACutOne) {
  LineReader reader("a\r\n\nb");
  std::string_view line;
  std::vector<std::string> lines;
  while (reader.Next(&line)) lines.emplace_back(line);
  EXPECT_EQ(lines, (std::vector<std::string>{"a", "", "b"}));
  EXPECT_EQ(reader.number(), 3);
  EXPECT_FALSE(reader.terminated());
}

TEST(FieldReader, KeepsEmptyFields) {
  FieldReader fields("a;;b;", ';');
  EXPECT_EQ(fields.Next(), "a");
  EXPECT_EQ(fields.Next(), "");
  EXPECT_EQ(fields.Rest(), "b;");
  EXPECT_EQ(fields.Next(), "b");
  EXPECT_FALSE(fields.exhausted());
  EXPECT_EQ(fields.Next(), "");
  EXPECT_TRUE(fields.exhausted());
}

}  // namespace
}  // namespace walkgraph
