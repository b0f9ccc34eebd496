// A museum on three levels, by trial and with unknown floors: nothing of a route is known to the
// map.
#include <gtest/gtest.h>

#include <cstdlib>
#include <filesystem>
#include <nlohmann/json.hpp>
#include <string>

#include "eval/run_program.h"

namespace walkgraph {
namespace {

namespace fs = std::filesystem;

TEST(FloorsRecorded, TheBarometersOffsetTellsFloorsThatFingerprintsDoNot) {
  const char* root = std::getenv("WALKGRAPH_REAL_DATA");
  if (root == nullptr) GTEST_SKIP() << "WALKGRAPH_REAL_DATA is not set";
  const fs::path logs = fs::absolute(fs::path(root) / "ipin2023_t3" / "logs");
  if (!fs::is_directory(logs)) GTEST_SKIP() << "no folder " << logs;

  const fs::path museum = FreshPath("museum");
  fs::create_directories(museum);
  for (const auto& entry : fs::directory_iterator(logs)) {
    fs::create_symlink(entry.path(), museum / entry.path().filename());
  }
  fs::copy_file(fs::path(WALKGRAPH_SOURCE_DIR) / "eval/studies/ipin2023_t3/building.json",
                museum / "building.json");
  const std::string out = FreshPath("out");
  const ProgramResult run =
      RunWalkgraph({"evaluate", "--dataset=" + museum.string(), "--methods=wknn,viterbi",
                    "--split=trial", "--folds=5", "--out=" + out});
  ASSERT_EQ(run.exit_code, 0) << run.output;

  const auto sections = nlohmann::json::parse(ReadText(out + "/summary.json")).at("sections");
  const auto& pooled = sections.at("pooled");
  EXPECT_EQ(pooled.at("viterbi").at("walks").get<int>(), 38);
  // All of them when this was written, 81 % by the nearest neighbours' majority.
  EXPECT_GE(pooled.at("viterbi").at("floor_accuracy").get<double>(), 0.99);
  EXPECT_GT(pooled.at("viterbi").at("floor_accuracy").get<double>(),
            pooled.at("wknn").at("floor_accuracy").get<double>() + 0.1);
  EXPECT_LT(pooled.at("viterbi").at("p75_m").get<double>(),
            0.6 * pooled.at("wknn").at("p75_m").get<double>());
  // The one route to floor -1 is held out, repetitions and all: nobody surveyed it, and only the
  // barometer knows.
  EXPECT_GT(sections.at("floor -1").at("viterbi").at("floor_accuracy").get<double>(), 0.9);
}

}  // namespace
}  // namespace walkgraph
