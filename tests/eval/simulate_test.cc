// `walkgraph simulate` as scripts call it.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <filesystem>
#include <fstream>
#include <sstream>
#include <string>
#include <vector>

#include "data/dataset.h"
#include "eval/run_program.h"

namespace walkgraph {
namespace {

using testing::HasSubstr;

constexpr int kOk = 0, kUsage = 2, kBadInput = 3;

std::string Content(const std::filesystem::path& path) {
  std::ostringstream text;
  text << std::ifstream(path, std::ios::binary).rdbuf();
  return text.str();
}

// Names and contents of all files below a folder, in order.
std::string Everything(const std::string& folder) {
  std::vector<std::filesystem::path> paths;
  for (const auto& entry : std::filesystem::recursive_directory_iterator(folder)) {
    if (entry.is_regular_file()) paths.push_back(entry.path());
  }
  std::sort(paths.begin(), paths.end());
  std::string all;
  for (const auto& path : paths) {
    all += path.lexically_relative(folder).string() + "\n" + Content(path);
  }
  return all;
}

ProgramResult Simulate(const std::string& out, std::vector<std::string> flags) {
  std::vector<std::string> words = {"simulate", "--out=" + out, "--survey=2", "--test=1",
                                    "--duration_s=40"};
  words.insert(words.end(), flags.begin(), flags.end());
  return RunWalkgraph(words);
}

TEST(Simulate, GivesTheSameBytesForTheSameSeed) {
  for (const char* format : {"csv", "ilc20", "getsensordata"}) {
    const std::vector<std::string> flags = {"--scenario=office", std::string("--format=") + format};
    const std::string one = FreshPath("one");
    const std::string two = FreshPath("two");
    ASSERT_EQ(Simulate(one, flags).exit_code, kOk);
    ASSERT_EQ(Simulate(two, flags).exit_code, kOk);
    EXPECT_TRUE(Everything(one) == Everything(two)) << format;
    EXPECT_EQ(OpenDataset(one + "/survey").walks.size(), 2U);
    EXPECT_EQ(OpenDataset(one + "/test").walks.front().format, format);
  }
}

TEST(Simulate, RecordsTheSettingsThatItUsed) {
  const std::string out = FreshPath("out");
  ASSERT_EQ(Simulate(out, {"--scenario=hall", "--rate_hz=50", "--set", "barometer.unit=kpa",
                           "--set", "gait.weinberg_k=0.5"})
                .exit_code,
            kOk);
  const std::string settings = Content(out + "/simulation.yaml");
  EXPECT_THAT(settings, HasSubstr("scenario hall, seed 1"));
  EXPECT_THAT(settings, HasSubstr("  rate_hz: 50 "));
  EXPECT_THAT(settings, HasSubstr("  unit: kpa "));
  EXPECT_THAT(settings, HasSubstr("  weinberg_k: 0.5 "));
  EXPECT_THAT(settings, HasSubstr("  duration_s: 40 "));
}

TEST(Simulate, WalksInAGivenPlan) {
  const std::string out = FreshPath("out");
  const std::string plan = std::string(WALKGRAPH_SOURCE_DIR) + "/data/samples/building.json";
  ASSERT_EQ(
      Simulate(out, {"--scenario=office", "--plan=" + plan, "--set", "building.grid_spacing_m=1.2"})
          .exit_code,
      kOk);
  EXPECT_EQ(OpenDataset(out + "/test").building.name, "sample office");
  EXPECT_EQ(Simulate(out, {"--scenario=office", "--plan=/nowhere.json"}).exit_code, kBadInput);
}

TEST(Simulate, RefusesWhatItDoesNotKnow) {
  const std::string out = FreshPath("out");
  const auto refuse = [&out](const std::vector<std::string>& flags, const char* message) {
    const ProgramResult result = Simulate(out, flags);
    EXPECT_EQ(result.exit_code, kUsage);
    EXPECT_THAT(result.output, HasSubstr(message));
  };
  refuse({"--scenario=offce"}, "did you mean \"office\"?");
  refuse({"--scenario=office", "--format=xml"}, "expected csv, ilc20 or getsensordata");
  refuse({"--scenario=office", "--set", "barometer.nois_hpa=1"},
         "did you mean \"barometer.noise_hpa\"?");
  refuse({"--scenario=office", "--set", "barometer.noise_hpa=-1"}, "not negative");
  refuse({"--scenario=office", "--floors=0"}, "a positive number");
  refuse({"--scenario=office", "--rate_hz=fast"}, "a number");
  refuse({"--scenario=office", "--duration_s=7200"}, "an hour");
  refuse({}, "--scenario=sample takes --out and --seed alone");
  EXPECT_FALSE(std::filesystem::exists(out));
}

}  // namespace
}  // namespace walkgraph
