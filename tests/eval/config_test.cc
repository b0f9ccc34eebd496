#include "eval/config.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <fstream>

#include "data/input_error.h"
#include "eval/suggest.h"
#include "eval/usage_error.h"

namespace walkgraph {
namespace {

using testing::AllOf;
using testing::HasSubstr;

std::string WriteConfig(const std::string& text) {
  // A file per test: they run at the same time.
  const std::string path = testing::TempDir() + "/walkgraph_config_" +
                           testing::UnitTest::GetInstance()->current_test_info()->name() +
                           "_test.yaml";
  std::ofstream(path) << text;
  return path;
}

std::string ErrorOf(const std::string& text) {
  try {
    ReadConfigFile(WriteConfig(text));
  } catch (const InputError& error) {
    return error.what();
  }
  return "no error";
}

std::string SetErrorOf(const std::string& assignment) {
  try {
    ParseSetFlag(assignment);
  } catch (const UsageError& error) {
    return error.what();
  }
  return "no error";
}

TEST(Config, ThePrintedReferenceReadsBackToTheSameSettings) {
  Settings settings;
  settings.factors.step.sigma_along_m = 0.1 + 0.2;  // needs all 17 digits
  settings.factors.gyro_bias.mode = StateMode::kAbsent;
  settings.factors.absolute_heading.loss.kind = LossKind::kCauchy;
  const std::string printed = PrintConfig(settings);
  Settings read;
  ApplyOverrides(ReadConfigFile(WriteConfig(printed)), &read);
  EXPECT_EQ(PrintConfig(read), printed);
  EXPECT_EQ(read.factors.step.sigma_along_m, 0.1 + 0.2);
  EXPECT_EQ(read.factors.gyro_bias.mode, StateMode::kAbsent);
  EXPECT_EQ(read.factors.absolute_heading.loss.kind, LossKind::kCauchy);
}

TEST(Config, AFileSetsWhatItNamesAndNothingElse) {
  Settings settings;
  ApplyOverrides(ReadConfigFile(WriteConfig("noise:\n  step:\n    sigma_along_m: 0.25\n")),
                 &settings);
  const auto changes = ChangedValues(Settings(), settings);
  ASSERT_EQ(changes.size(), 1u);
  EXPECT_EQ(changes.at("noise.step.sigma_along_m"), "0.25");
}

TEST(Config, PrintedChangesReadBackToTheChangedSettings) {
  Settings changed;
  changed.factors.gyro_bias.mode = StateMode::kFixed;
  changed.factors.map_error.sigma_m = 2.5;
  const std::string printed = PrintChanges(Settings(), changed);
  EXPECT_THAT(printed, testing::Not(HasSubstr("sigma_along_m")));
  Settings read;
  ApplyOverrides(ReadConfigFile(WriteConfig(printed)), &read);
  EXPECT_EQ(PrintConfig(read), PrintConfig(changed));
}

TEST(Config, AMisspeltKeyNamesItsLineAndTheNearestKey) {
  EXPECT_THAT(ErrorOf("noise:\n  step:\n    sigma_alog_m: 0.25\n"),
              AllOf(HasSubstr("test.yaml:3: "), HasSubstr("noise.step.sigma_alog_m"),
                    HasSubstr("did you mean \"noise.step.sigma_along_m\"?")));
  EXPECT_THAT(ErrorOf("noise:\n  stepp:\n    sigma_along_m: 0.25\n"),
              AllOf(HasSubstr("test.yaml:2: "), HasSubstr("did you mean \"noise.step\"?")));
}

TEST(Config, RejectsValuesOutOfRangeWithWhatWasExpected) {
  EXPECT_THAT(ErrorOf("noise:\n  step:\n    sigma_along_m: -0.1\n"),
              AllOf(HasSubstr("test.yaml:3: "), HasSubstr("expected a positive number")));
  EXPECT_THAT(ErrorOf("noise:\n  step:\n    sigma_along_m: 0\n"),
              HasSubstr("expected a positive number"));
  EXPECT_THAT(ErrorOf("noise:\n  step:\n    sigma_along_m: nan\n"),
              HasSubstr("expected a finite number"));
  EXPECT_THAT(ErrorOf("noise:\n  step:\n    sigma_along_m: wide\n"),
              HasSubstr("expected a number"));
  EXPECT_THAT(ErrorOf("factors:\n  step:\n    enabled: 1\n"), HasSubstr("expected true or false"));
  EXPECT_THAT(ErrorOf("factors:\n  gyro_bias:\n    mode: off\n"),
              HasSubstr("expected active, fixed or absent"));
}

TEST(Config, ZeroIsAllowedWhereItMeansTheSitesValue) {
  EXPECT_EQ(ErrorOf("noise:\n  map_error:\n    sigma_m: 0\n"), "no error");
  EXPECT_THAT(ErrorOf("noise:\n  map_error:\n    sigma_m: -1\n"),
              HasSubstr("expected a number that is not negative"));
}

TEST(Config, RejectsWhatIsNotATreeOfKeys) {
  EXPECT_THAT(ErrorOf("noise: [\n"), HasSubstr("expected YAML"));
  EXPECT_THAT(ErrorOf("- 1\n"), HasSubstr("not a group of keys"));
  EXPECT_THAT(ErrorOf("noise:\n  step:\n    sigma_along_m: [1]\n"), HasSubstr("not a value"));
  EXPECT_THAT(
      ErrorOf("noise:\n  step:\n    sigma_along_m: 0.1\n    sigma_along_m: 0.2\n"),
      AllOf(HasSubstr("test.yaml:4: "), HasSubstr("given twice"), HasSubstr("test.yaml:3")));
  EXPECT_THROW(ReadConfigFile("/nowhere/config.yaml"), InputError);
}

TEST(Config, TheLastOverrideWins) {
  Settings settings;
  ApplyOverrides(
      {ParseSetFlag("noise.step.sigma_along_m=0.3"), ParseSetFlag("noise.step.sigma_along_m=0.4")},
      &settings);
  EXPECT_EQ(settings.factors.step.sigma_along_m, 0.4);
}

TEST(Config, SetFlagsAreCheckedLikeTheFile) {
  EXPECT_THAT(SetErrorOf("noise.stp.sigma_along_m=0.3"),
              HasSubstr("did you mean \"noise.step.sigma_along_m\"?"));
  EXPECT_THAT(SetErrorOf("noise.step.sigma_along_m"), HasSubstr("KEY=VALUE"));
  EXPECT_THAT(SetErrorOf("noise.step.sigma_along_m=-1"), HasSubstr("positive number"));
}

TEST(Suggest, DistanceCountsSingleEdits) {
  EXPECT_EQ(EditDistance("kitten", "sitting"), 3);
  EXPECT_EQ(EditDistance("", "abc"), 3);
  EXPECT_EQ(EditDistance("same", "same"), 0);
}

TEST(Suggest, OffersNothingForAWordUnlikeAny) {
  EXPECT_EQ(DidYouMean("zebra", {"batch", "wknn"}), "");
  EXPECT_EQ(DidYouMean("wkn", {"batch", "wknn"}), ", did you mean \"wknn\"?");
}

}  // namespace
}  // namespace walkgraph
