// The program on input that it cannot use: the message has the place and what was expected, the
// exit code is the documented one, and nothing is half written.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cstdint>

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

TEST(BadInput, UnknownMethodOfSmooth) {
  const std::string out = FreshPath("out");
  const ProgramResult result = RunWalkgraph(
      {"smooth", "--site=unused", "--method=vitrebi", "--out=" + out, kSample + "/test/walk_01"});
  EXPECT_EQ(result.exit_code, kUsage);
  EXPECT_THAT(result.output, HasSubstr("unknown method \"vitrebi\", did you mean \"viterbi\"?"));
  EXPECT_FALSE(Exists(out));
}

// A survey would silently do without them.
TEST(BadInput, SurveyWithFlagsOfItsUpdate) {
  const std::string out = FreshPath("site");
  for (const std::string flag : {"method=viterbi", "floor=given"}) {
    const ProgramResult result =
        RunWalkgraph({"survey", "--dataset=" + kSample + "/survey", "--out=" + out, "--" + flag});
    EXPECT_EQ(result.exit_code, kUsage);
    EXPECT_THAT(result.output, AllOf(HasSubstr("is for --update"), HasSubstr("expected")));
  }
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

// Smoothing has to see that there is nothing to smooth before it makes its folder.
TEST(BadInput, NothingToSmooth) {
  const std::string site = FreshPath("site"), out = FreshPath("out");
  const std::string missing = FreshPath("missing.txt"), letter = FreshPath("letter.txt");
  std::ofstream(letter) << "Dear walker,\nthis is no recording.\n";
  ASSERT_EQ(RunWalkgraph({"survey", "--dataset=" + kSample + "/survey", "--out=" + site}).exit_code,
            0);
  for (const std::string& path : {missing, letter}) {
    const ProgramResult result = RunWalkgraph({"smooth", "--site=" + site, "--out=" + out, path});
    EXPECT_EQ(result.exit_code, kBadInput);
    EXPECT_THAT(result.output, AllOf(HasSubstr(path), HasSubstr("expected")));
    EXPECT_FALSE(Exists(out));
  }
}

TEST(BadInput, ADatasetOfOtherFiles) {
  const std::string dataset = FreshPath("letters"), out = FreshPath("out");
  std::filesystem::create_directories(dataset);
  std::ofstream(dataset + "/letter.txt") << "Dear walker,\nthis is no recording.\n";
  for (const std::string verb : {"survey", "calibrate", "evaluate"}) {
    std::vector<std::string> words = {verb, "--dataset=" + dataset, "--out=" + out};
    if (verb == "evaluate") words.push_back("--methods=wknn");
    const ProgramResult result = RunWalkgraph(words);
    EXPECT_EQ(result.exit_code, kBadInput) << verb;
    EXPECT_THAT(result.output, AllOf(HasSubstr(dataset), HasSubstr("expected")));
    EXPECT_FALSE(Exists(out));
  }
}

TEST(BadInput, MissingConfigurationAndNoYaml) {
  const std::string config = FreshPath("config.yaml"), out = FreshPath("out");
  const std::vector<std::string> evaluate = {"evaluate", "--dataset=" + kSample, "--out=" + out,
                                             "--methods=wknn", "--config=" + config};
  for (const bool exists : {false, true}) {
    if (exists) std::ofstream(config) << "noise: [unclosed\n";
    const ProgramResult result = RunWalkgraph(evaluate);
    EXPECT_EQ(result.exit_code, kBadInput);
    EXPECT_THAT(result.output, AllOf(HasSubstr(config), HasSubstr("expected")));
    EXPECT_FALSE(Exists(out));
  }
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

TEST(BadInput, MisspeltKeyOrValueOnTheCommandLine) {
  const std::string out = FreshPath("out");
  const auto evaluate_with = [&](const std::string& assignment) {
    return RunWalkgraph({"evaluate", "--dataset=" + kSample, "--methods=wknn", "--out=" + out,
                         "--set", assignment});
  };
  const ProgramResult key = evaluate_with("noise.step.sigma_alog_m=0.2");
  EXPECT_EQ(key.exit_code, kUsage);
  EXPECT_THAT(key.output, HasSubstr("did you mean \"noise.step.sigma_along_m\"?"));
  const ProgramResult value = evaluate_with("radio_map.positions=smother");
  EXPECT_EQ(value.exit_code, kUsage);
  EXPECT_THAT(value.output, AllOf(HasSubstr("radio_map.positions is \"smother\""),
                                  HasSubstr("expected walked_distance or smoother")));
  EXPECT_FALSE(Exists(out));
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

TEST(BadInput, SiteFileThatIsMissingOrNoSite) {
  const std::string site = FreshPath("site"), out = FreshPath("out");
  for (const bool exists : {false, true}) {
    if (exists) std::ofstream(site) << "WALKGRAPHSITE\n";
    const ProgramResult result =
        RunWalkgraph({"smooth", "--site=" + site, "--out=" + out, kSample + "/test/walk_01"});
    EXPECT_EQ(result.exit_code, kBadInput);
    EXPECT_THAT(result.output, AllOf(HasSubstr(site), HasSubstr("expected")));
    EXPECT_FALSE(Exists(out));
  }
}

// Wherever a copy broke off, down to the last byte.
TEST(BadInput, SiteFileThatIsCut) {
  const std::string site = FreshPath("site"), out = FreshPath("out");
  ASSERT_EQ(RunWalkgraph({"survey", "--dataset=" + kSample + "/survey", "--out=" + site}).exit_code,
            0);
  const std::uintmax_t whole = std::filesystem::file_size(site);
  for (const std::uintmax_t size :
       {whole - 1, whole * 7 / 8, whole / 2, whole / 8, std::uintmax_t{20}, std::uintmax_t{0}}) {
    std::filesystem::resize_file(site, size);
    const ProgramResult result =
        RunWalkgraph({"smooth", "--site=" + site, "--out=" + out, kSample + "/test/walk_01"});
    EXPECT_EQ(result.exit_code, kBadInput) << size;
    EXPECT_THAT(result.output, AllOf(HasSubstr(site), HasSubstr("expected"))) << size;
    EXPECT_FALSE(Exists(out));
  }
}

TEST(BadInput, ReportOfNoResults) {
  const std::string results = FreshPath("results"), page = FreshPath("page.html");
  for (const bool exists : {false, true}) {
    if (exists) std::filesystem::create_directories(results);
    const ProgramResult result = RunWalkgraph({"report", results, "--out=" + page});
    EXPECT_EQ(result.exit_code, kBadInput);
    EXPECT_THAT(result.output, AllOf(HasSubstr("results/building.json"), HasSubstr("expected")));
    EXPECT_FALSE(Exists(page));
  }
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

// A page named after the results puts its tables and figures among them; they go with the results.
// The same names in a folder that holds no results are somebody's own.
TEST(BadInput, ResultsWithTheirReportAreReplacedAndOthersFiguresAreNot) {
  const std::string out = FreshPath("results");
  const auto evaluate = [&out] {
    return RunWalkgraph({"evaluate", "--train=" + kSample + "/survey",
                         "--test=" + kSample + "/test", "--methods=wknn", "--out=" + out});
  };
  ASSERT_EQ(evaluate().exit_code, 0);
  ASSERT_EQ(RunWalkgraph({"report", out, "--out=" + out + ".html"}).exit_code, 0);
  ASSERT_TRUE(Exists(out + "/figures"));
  const ProgramResult again = evaluate();
  EXPECT_EQ(again.exit_code, 0) << again.output;
  EXPECT_FALSE(Exists(out + "/figures"));
  std::filesystem::remove_all(out);
  std::filesystem::create_directories(out + "/figures");
  const ProgramResult strangers = evaluate();
  EXPECT_EQ(strangers.exit_code, kUsage);
  EXPECT_THAT(strangers.output, HasSubstr("holds \"figures\""));
  EXPECT_TRUE(Exists(out + "/figures"));
}

}  // namespace
}  // namespace walkgraph
