// The whole way on one recorded floor: every walk gets a row, and the graph is worth its cost.
#include <gtest/gtest.h>

#include <algorithm>
#include <cstdlib>
#include <nlohmann/json.hpp>

#include "eval/run_program.h"

namespace walkgraph {
namespace {

TEST(EvaluateRecorded, EveryWalkHasARowAndTheGraphBeatsNearestNeighbours) {
  const char* root = std::getenv("WALKGRAPH_REAL_DATA");
  if (root == nullptr) GTEST_SKIP() << "WALKGRAPH_REAL_DATA is not set";
  const std::string floor = std::string(root) + "/ilc20/data/site1/F2";
  if (!std::filesystem::is_directory(floor)) GTEST_SKIP() << "no folder " << floor;

  const std::string out = FreshPath("out");
  const ProgramResult run =
      RunWalkgraph({"evaluate", "--dataset=" + floor, "--methods=wknn,viterbi,batch", "--folds=3",
                    "--out=" + out});
  ASSERT_EQ(run.exit_code, 0) << run.output;

  int walks = 0;
  for (const auto& entry : std::filesystem::directory_iterator(floor + "/path_data_files")) {
    walks += entry.path().extension() == ".txt" ? 1 : 0;
  }
  const std::string scores = ReadText(out + "/scores.csv");
  EXPECT_EQ(std::count(scores.begin(), scores.end(), '\n'), 1 + 3 * walks);

  const auto summary = nlohmann::json::parse(ReadText(out + "/summary.json"));
  const auto& pooled = summary.at("sections").at("pooled");
  EXPECT_GT(pooled.at("wknn").at("walks").get<int>(), walks * 9 / 10);
  for (const char* method : {"viterbi", "batch"}) {
    // The upper end of the paired 95 % interval: better than chance could make it.
    EXPECT_LT(pooled.at(method).at("minus").at("wknn").at("interval_m").at(1).get<double>(), 0)
        << method;
  }
  // An ellipse that holds less or more than this is not honest (95 % of about 600 waypoints, which
  // come in walks of one error each).
  EXPECT_GT(pooled.at("batch").at("coverage95").get<double>(), 0.80);
  EXPECT_LT(pooled.at("batch").at("coverage95").get<double>(), 0.995);
}

}  // namespace
}  // namespace walkgraph
