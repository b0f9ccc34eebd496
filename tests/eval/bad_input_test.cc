// The program on input that it cannot use: the message has the place and what was expected, the
// exit code is the documented one, and nothing is half written.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "eval/run_program.h"

namespace walkgraph {
namespace {

using testing::AllOf;
using testing::HasSubstr;

constexpr int kUsage = 2, kBadInput = 3;
const std::string kSample = std::string(WALKGRAPH_SOURCE_DIR) + "/data/samples";

bool Exists(const std::string& path) { return std::filesystem::exists(path); }

TEST(BadInput, NoVerbAndUnknownVerb) {
  EXPECT_EQ(RunWalkgraph({}).exit_code, kUsage);
  const ProgramResult result = RunWalkgraph({"evalute"});
  EXPECT_EQ(result.exit_code, kUsage);
  EXPECT_THAT(result.output, HasSubstr("did you mean \"evaluate\"?"));
}

TEST(BadInput, UnknownFlagAndWrongValue) {
  const ProgramResult result = RunWalkgraph({"evaluate", "--datset=x"});
  EXPECT_EQ(result.exit_code, kUsage);
  EXPECT_THAT(result.output, AllOf(HasSubstr("--datset"), HasSubstr("did you mean \"dataset\"?")));
  const ProgramResult value = RunWalkgraph({"evaluate", "--folds=many"});
  EXPECT_EQ(value.exit_code, kUsage);
  EXPECT_THAT(value.output, HasSubstr("--folds=many"));
  // A flag of another verb is not silently accepted.
  EXPECT_EQ(RunWalkgraph({"version", "--folds=3"}).exit_code, kUsage);
}

TEST(BadInput, UnknownMethod) {
  const std::string out = FreshPath("out");
  const ProgramResult result =
      RunWalkgraph({"evaluate", "--dataset=" + kSample, "--methods=wknn,bacth", "--out=" + out});
  EXPECT_EQ(result.exit_code, kUsage);
  EXPECT_THAT(result.output, HasSubstr("unknown method \"bacth\", did you mean \"batch\"?"));
  EXPECT_FALSE(Exists(out));
}

TEST(BadInput, MissingRecording) {
  const ProgramResult result = RunWalkgraph({"inspect", "/nowhere/walk.txt"});
  EXPECT_EQ(result.exit_code, kBadInput);
  EXPECT_THAT(result.output, AllOf(HasSubstr("/nowhere/walk.txt"), HasSubstr("expected")));
}

TEST(BadInput, WrongFormat) {
  const std::string path = FreshPath("letter.txt");
  std::ofstream(path) << "Dear walker,\nthis is no recording.\n";
  const ProgramResult result = RunWalkgraph({"inspect", path});
  EXPECT_EQ(result.exit_code, kBadInput);
  EXPECT_THAT(result.output, AllOf(HasSubstr(path), HasSubstr("expected")));
}

TEST(BadInput, MisspeltKeyInTheConfiguration) {
  const std::string config = FreshPath("config.yaml"), out = FreshPath("out");
  std::ofstream(config) << "noise:\n  step:\n    sigma_alog_m: 0.2\n";
  const ProgramResult result = RunWalkgraph(
      {"evaluate", "--dataset=" + kSample, "--methods=wknn", "--out=" + out, "--config=" + config});
  EXPECT_EQ(result.exit_code, kBadInput);
  EXPECT_THAT(result.output, AllOf(HasSubstr(config + ":3: "),
                                   HasSubstr("did you mean \"noise.step.sigma_along_m\"?")));
  EXPECT_FALSE(Exists(out));
}

TEST(BadInput, MisspeltKeyOnTheCommandLine) {
  const ProgramResult result = RunWalkgraph({"config", "--set", "noise.step.sigma_alog_m=0.2"});
  EXPECT_EQ(result.exit_code, kUsage);
  EXPECT_THAT(result.output, HasSubstr("did you mean \"noise.step.sigma_along_m\"?"));
}

TEST(BadInput, EmptyAndMissingDataset) {
  const std::string dataset = FreshPath("dataset"), out = FreshPath("out");
  for (const bool exists : {false, true}) {
    if (exists) std::filesystem::create_directories(dataset);
    for (const std::string verb : {"evaluate", "survey", "calibrate"}) {
      std::vector<std::string> words = {verb, "--dataset=" + dataset, "--out=" + out};
      if (verb == "evaluate") words.push_back("--methods=wknn");
      const ProgramResult result = RunWalkgraph(words);
      EXPECT_EQ(result.exit_code, kBadInput);
      EXPECT_THAT(result.output, AllOf(HasSubstr(dataset), HasSubstr("expected")));
      EXPECT_FALSE(Exists(out));
    }
  }
}

TEST(BadInput, SiteFileThatIsMissingCutOrNoSite) {
  const std::string site = FreshPath("site"), out = FreshPath("out");
  const std::string walk = kSample + "/test/walk_01";
  const std::vector<std::string> smooth = {"smooth", "--site=" + site, "--out=" + out, walk};
  EXPECT_EQ(RunWalkgraph(smooth).exit_code, kBadInput);

  std::ofstream(site) << "WALKGRAPHSITE\n";
  const ProgramResult short_file = RunWalkgraph(smooth);
  EXPECT_EQ(short_file.exit_code, kBadInput);
  EXPECT_THAT(short_file.output, AllOf(HasSubstr(site), HasSubstr("expected")));

  ASSERT_EQ(RunWalkgraph({"survey", "--dataset=" + kSample + "/survey", "--out=" + site}).exit_code,
            0);
  std::filesystem::resize_file(site, std::filesystem::file_size(site) / 2);
  const ProgramResult cut = RunWalkgraph(smooth);
  EXPECT_EQ(cut.exit_code, kBadInput);
  EXPECT_THAT(cut.output, AllOf(HasSubstr(site), HasSubstr("expected")));
  EXPECT_FALSE(Exists(out));
}

TEST(BadInput, AFolderWithOtherThingsIsNotOverwritten) {
  const std::string out = FreshPath("home");
  std::filesystem::create_directories(out);
  std::ofstream(out + "/thesis.tex") << "precious";
  const ProgramResult result = RunWalkgraph(
      {"evaluate", "--dataset=" + kSample + "/test", "--methods=wknn", "--out=" + out});
  EXPECT_EQ(result.exit_code, kUsage);
  EXPECT_THAT(result.output, HasSubstr("thesis.tex"));
  EXPECT_EQ(ReadText(out + "/thesis.tex"), "precious");
}

}  // namespace
}  // namespace walkgraph
