// `survey --update`: which method locates the walks that a site learns from.
#include <gtest/gtest.h>

#include <fstream>
#include <iterator>

#include "eval/run_program.h"

namespace walkgraph {
namespace {

const std::string kSample = std::string(WALKGRAPH_SOURCE_DIR) + "/data/samples";

std::string Bytes(const std::string& path) {
  std::ifstream in(path, std::ios::binary);
  return {std::istreambuf_iterator<char>(in), std::istreambuf_iterator<char>()};
}

class SiteUpdateProgram : public testing::Test {
 protected:
  void SetUp() override {
    site_ = FreshPath("site");
    ASSERT_EQ(
        RunWalkgraph({"survey", "--dataset=" + kSample + "/survey", "--out=" + site_}).exit_code,
        0);
  }

  // The site's bytes after an update with one round.
  std::string Updated(const std::vector<std::string>& flags) const {
    const std::string out = FreshPath("updated");
    std::vector<std::string> arguments = {"survey", "--dataset=" + kSample + "/test",
                                          "--site=" + site_, "--out=" + out,
                                          "--set=map_change.rounds=1"};
    arguments.insert(arguments.end(), flags.begin(), flags.end());
    const ProgramResult result = RunWalkgraph(arguments);
    EXPECT_EQ(result.exit_code, 0) << result.output;
    return Bytes(out);
  }

  std::string site_;
};

TEST_F(SiteUpdateProgram, KrigingLocatesByViterbiAndTheGraphByItself) {
  const std::string kriging = Updated({"--update=kriging"});
  EXPECT_EQ(kriging, Updated({"--update=kriging", "--method=viterbi"}));
  EXPECT_NE(kriging, Updated({"--update=kriging", "--method=batch"}));
  const std::string graph = Updated({"--update=graph"});
  EXPECT_EQ(graph, Updated({"--update=graph", "--method=batch"}));
  EXPECT_NE(graph, Updated({"--update=graph", "--method=viterbi"}));
}

}  // namespace
}  // namespace walkgraph
