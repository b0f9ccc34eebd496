// `walkgraph evaluate` and `smooth` from end to end on the embedded sample.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <nlohmann/json.hpp>
#include <set>

#include "eval/run_program.h"

namespace walkgraph {
namespace {

using testing::HasSubstr;

const std::string kSurvey = std::string(WALKGRAPH_SOURCE_DIR) + "/data/samples/survey";
const std::string kTest = std::string(WALKGRAPH_SOURCE_DIR) + "/data/samples/test";

std::vector<std::string> EvaluateSample(const std::string& out, int workers) {
  return {"evaluate",     "--train=" + kSurvey,     "--test=" + kTest,
          "--out=" + out, "--methods=wknn,viterbi", "--workers=" + std::to_string(workers)};
}

TEST(Evaluate, GivesTheSameBytesForAnyNumberOfWorkers) {
  const std::string one = FreshPath("one"), two = FreshPath("two");
  ASSERT_EQ(RunWalkgraph(EvaluateSample(one, 1)).exit_code, 0);
  ASSERT_EQ(RunWalkgraph(EvaluateSample(two, 2)).exit_code, 0);
  const auto files = ResultFiles(one);
  EXPECT_EQ(files, ResultFiles(two));
  EXPECT_TRUE(files.contains("trajectories/walk_01.viterbi.csv"));
  EXPECT_TRUE(files.contains("walks/walk_04.json"));
  EXPECT_TRUE(files.contains("building.json"));
}

TEST(Evaluate, AWalkThatChangesFloorsIsNotHeldOnOneThatIsGiven) {
  const std::string sim = FreshPath("sim"), out = FreshPath("out");
  ASSERT_EQ(RunWalkgraph({"simulate", "--out=" + sim, "--scenario=office", "--floors=2", "--seed=3",
                          "--survey=4", "--test=2", "--duration_s=150", "--rate_hz=50"})
                .exit_code,
            0);
  ASSERT_EQ(RunWalkgraph({"evaluate", "--train=" + sim + "/survey", "--test=" + sim + "/test",
                          "--out=" + out, "--methods=viterbi", "--floor=given"})
                .exit_code,
            0);
  int changing = 0;
  for (const std::string walk : {"walk_01", "walk_02"}) {
    const auto json = nlohmann::json::parse(ReadText(out + "/walks/" + walk + ".json"));
    std::set<int> floors;
    for (const auto& waypoint : json.at("waypoints"))
      floors.insert(waypoint.at("floor").get<int>());
    const bool noted =
        json.dump().find("changes floors, so that none is given") != std::string::npos;
    EXPECT_EQ(noted, floors.size() > 1) << walk;
    if (noted) ++changing;
  }
  EXPECT_GT(changing, 0);
  // Held on the first waypoint's floor it would be wrong at every waypoint of the other.
  const auto summary = nlohmann::json::parse(ReadText(out + "/summary.json"));
  EXPECT_GT(summary.at("sections").at("pooled").at("viterbi").at("floor_accuracy"), 0.95);
}

TEST(Evaluate, ScoresHaveARowPerWalkAndMethodThatAddsUpToTheSummary) {
  const std::string out = FreshPath("out");
  ASSERT_EQ(RunWalkgraph(EvaluateSample(out, 2)).exit_code, 0);
  std::istringstream scores(ReadText(out + "/scores.csv"));
  std::string line;
  std::getline(scores, line);
  EXPECT_EQ(line,
            "walk,method,fold,n,mean_m,rmse_m,median_m,p75_m,p90_m,p95_m,max_m,floor_accuracy,"
            "coverage50,coverage95,nees,survey_distance_m,duration_s,status");
  std::map<std::string, std::pair<double, int>> totals;  // sum of errors and waypoints by method
  int rows = 0;
  while (std::getline(scores, line)) {
    std::istringstream fields(line);
    std::string walk, method, fold, n, mean;
    for (std::string* field : {&walk, &method, &fold, &n, &mean}) std::getline(fields, *field, ',');
    totals[method].first += std::stod(mean) * std::stoi(n);
    totals[method].second += std::stoi(n);
    ++rows;
  }
  EXPECT_EQ(rows, 4 * 2);
  const auto summary = nlohmann::json::parse(ReadText(out + "/summary.json"));
  for (const auto& [method, total] : totals) {
    const auto& row = summary.at("sections").at("pooled").at(method);
    EXPECT_EQ(row.at("n"), total.second);
    EXPECT_NEAR(row.at("mean_m").get<double>(), total.first / total.second, 1e-3);
  }
  EXPECT_EQ(summary.at("checksums").size(), 4u + 14u);
}

TEST(Smooth, AnchorsPullTheTrajectoryAndAreNotScored) {
  const std::string site = FreshPath("site"), free = FreshPath("free"), tied = FreshPath("tied");
  ASSERT_EQ(RunWalkgraph({"survey", "--dataset=" + kSurvey, "--out=" + site}).exit_code, 0);
  const std::string walk = kTest + "/walk_01";
  const std::string site_flag = "--site=" + site;
  ASSERT_EQ(RunWalkgraph({"smooth", site_flag, "--out=" + free, "--method=batch", walk}).exit_code,
            0);
  ASSERT_EQ(RunWalkgraph({"smooth", site_flag, "--out=" + tied, "--method=batch",
                          "--use_waypoints=every:2", walk})
                .exit_code,
            0);
  const auto Errors = [](const std::string& out) {
    const auto json = nlohmann::json::parse(ReadText(out + "/walks/walk_01.json"));
    return json.at("methods").at("batch").at("errors_m").get<std::vector<double>>();
  };
  const std::vector<double> free_errors = Errors(free), tied_errors = Errors(tied);
  ASSERT_EQ(tied_errors.size(), free_errors.size() / 2);
  double free_sum = 0, tied_sum = 0;
  for (std::size_t i = 0; i < tied_errors.size(); ++i) {
    free_sum += free_errors[2 * i + 1];  // the same waypoints
    tied_sum += tied_errors[i];
  }
  EXPECT_LT(tied_sum, free_sum);
}

TEST(Smooth, ABrokenRecordingIsARowNotTheEnd) {
  const std::string site = FreshPath("site"), out = FreshPath("out"), bad = FreshPath("bad.txt");
  ASSERT_EQ(RunWalkgraph({"survey", "--dataset=" + kSurvey, "--out=" + site}).exit_code, 0);
  std::ofstream(bad) << "no recording\n";
  const ProgramResult result = RunWalkgraph(
      {"smooth", "--site=" + site, "--out=" + out, "--method=wknn", bad, kTest + "/walk_02"});
  EXPECT_EQ(result.exit_code, 0);
  const std::string scores = ReadText(out + "/scores.csv");
  EXPECT_THAT(scores, HasSubstr(",input_error\n"));
  EXPECT_THAT(scores, HasSubstr("walk_02,wknn,0,"));
}

}  // namespace
}  // namespace walkgraph
