// Ctrl-C: what is finished stays and is usable, nothing is half written, the exit code is 130.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <csignal>
#include <set>
#include <sstream>

#include "eval/run_program.h"

namespace walkgraph {
namespace {

constexpr int kOk = 0, kInterrupted = 130;
const std::string kSurvey = std::string(WALKGRAPH_SOURCE_DIR) + "/data/samples/survey";
const std::string kTest = std::string(WALKGRAPH_SOURCE_DIR) + "/data/samples/test";

// Runs the program and interrupts it once its output says `when`.
ProgramResult Interrupt(const std::vector<std::string>& arguments, const std::string& when) {
  bool sent = false;
  return RunWalkgraph(arguments, [&](pid_t child, const std::string& output) {
    if (sent || output.find(when) == std::string::npos) return;
    kill(child, SIGINT);
    sent = true;
  });
}

// Walks with a row in scores.csv.
std::set<std::string> ScoredWalks(const std::string& out) {
  std::istringstream scores(ReadText(out + "/scores.csv"));
  std::set<std::string> walks;
  std::string line;
  std::getline(scores, line);
  EXPECT_EQ(line.compare(0, 5, "walk,"), 0);
  while (std::getline(scores, line)) walks.insert(line.substr(0, line.find(',')));
  return walks;
}

// Every scored walk has its files, whole to the last line, the report shows them, and no file of a
// write in progress is left.
void ExpectUsable(const std::string& out, const std::string& method) {
  const std::set<std::string> walks = ScoredWalks(out);
  EXPECT_FALSE(walks.empty());
  for (const std::string& walk : walks) {
    const std::string trajectory = ReadText(out + "/trajectories/" + walk + "." + method + ".csv");
    ASSERT_FALSE(trajectory.empty()) << walk;
    EXPECT_EQ(trajectory.back(), '\n');
    EXPECT_GT(std::count(trajectory.begin(), trajectory.end(), '\n'), 10);
    EXPECT_FALSE(ReadText(out + "/walks/" + walk + ".json").empty());
  }
  for (const auto& [name, content] : ResultFiles(out)) {
    EXPECT_FALSE(name.ends_with(".tmp")) << name;
    EXPECT_FALSE(content.empty()) << name;
  }
  const std::string page = out + "_page.html";
  EXPECT_EQ(RunWalkgraph({"report", out, "--out=" + page}).exit_code, kOk);
  const std::string html = ReadText(page);
  for (const std::string& walk : walks) EXPECT_THAT(html, ::testing::HasSubstr(walk));
}

TEST(Interrupt, EvaluateLeavesFinishedWalks) {
  const std::string out = FreshPath("out");
  const ProgramResult result = Interrupt({"evaluate", "--train=" + kSurvey, "--test=" + kTest,
                                          "--out=" + out, "--methods=wknn,viterbi", "--workers=1"},
                                         " walks done:");
  EXPECT_EQ(result.exit_code, kInterrupted);
  ExpectUsable(out, "viterbi");
}

TEST(Interrupt, SmoothLeavesFinishedWalks) {
  const std::string site = FreshPath("site"), out = FreshPath("out");
  ASSERT_EQ(RunWalkgraph({"survey", "--dataset=" + kSurvey, "--out=" + site}).exit_code, kOk);
  const ProgramResult result = Interrupt(
      {"smooth", "--site=" + site, "--out=" + out, "--method=batch", "--workers=1", kTest},
      " walks done:");
  EXPECT_EQ(result.exit_code, kInterrupted);
  ExpectUsable(out, "batch");
}

TEST(Interrupt, LearningWritesNothing) {
  const std::string out = FreshPath("out");
  for (const std::string verb : {"survey", "calibrate"}) {
    const ProgramResult result = Interrupt(
        {verb, "--dataset=" + kSurvey, "--out=" + out, "--workers=1"}, " walks read done:");
    EXPECT_EQ(result.exit_code, kInterrupted) << verb;
    EXPECT_FALSE(std::filesystem::exists(out));
    EXPECT_FALSE(std::filesystem::exists(out + ".tmp"));
  }
}

}  // namespace
}  // namespace walkgraph
