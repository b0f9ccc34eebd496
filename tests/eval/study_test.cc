// `walkgraph ablate`: resumes, shards, refuses what does not belong together.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <csignal>
#include <cstdlib>

#include "eval/run_program.h"

namespace walkgraph {
namespace {

using testing::HasSubstr;

const std::string kDataset = std::string(WALKGRAPH_SOURCE_DIR) + "/data/samples/survey";

std::vector<std::string> Ablate(const std::string& out, std::vector<std::string> more = {}) {
  std::vector<std::string> words = {"ablate", "--dataset=" + kDataset, "--out=" + out, "--folds=2",
                                    "--factors=step,fingerprint,map_error"};
  for (std::string& word : more) words.push_back(std::move(word));
  return words;
}

// Result files without the walks' own, to compare shards' summaries.
std::map<std::string, std::string> Summaries(const std::string& dir) {
  std::map<std::string, std::string> files = ResultFiles(dir);
  std::erase_if(files, [](const auto& file) { return file.first.rfind("cells/", 0) == 0; });
  return files;
}

std::string SomeCellFile(const std::string& out) { return out + "/cells/survey/base/walk_03.json"; }

TEST(Ablate, GivesTheSameBytesForAnyNumberOfWorkers) {
  const std::string one = FreshPath("one"), two = FreshPath("two");
  ASSERT_EQ(RunWalkgraph(Ablate(one, {"--workers=1"})).exit_code, 0);
  ASSERT_EQ(RunWalkgraph(Ablate(two, {"--workers=2"})).exit_code, 0);
  const auto files = ResultFiles(one);
  EXPECT_EQ(files, ResultFiles(two));
  EXPECT_EQ(std::count_if(files.begin(), files.end(),
                          [](const auto& f) { return f.first.rfind("cells/", 0) == 0; }),
            14);
  EXPECT_TRUE(files.contains("tables/contributions.tex"));
}

TEST(Ablate, KilledAtAnyMomentItResumesToTheSameBytes) {
  const std::string whole = FreshPath("whole"), killed = FreshPath("killed");
  ASSERT_EQ(RunWalkgraph(Ablate(whole, {"--workers=1"})).exit_code, 0);
  int kills = 0;
  for (int walk = 1; walk <= 10; ++walk) {
    // Each run is killed with no chance to tidy up as soon as it says that a walk is done.
    RunWalkgraph(Ablate(killed, {"--workers=2"}), [&](pid_t child, const std::string& output) {
      if (output.find(" done: ") == std::string::npos) return;
      kills += kill(child, SIGKILL) == 0 ? 1 : 0;
    });
  }
  EXPECT_GT(kills, 3);
  ASSERT_EQ(RunWalkgraph(Ablate(killed)).exit_code, 0);
  EXPECT_EQ(ResultFiles(whole), ResultFiles(killed));
}

TEST(Ablate, ADamagedCellIsReportedAndComputedAgain) {
  const std::string out = FreshPath("out");
  ASSERT_EQ(RunWalkgraph(Ablate(out)).exit_code, 0);
  const auto files = ResultFiles(out);
  std::string text = ReadText(SomeCellFile(out));
  const std::size_t digit = text.find("\"error_m\":[") + 11;
  text[digit] = text[digit] == '1' ? '2' : '1';  // still JSON, and wrong
  std::ofstream(SomeCellFile(out)) << text;
  const ProgramResult result = RunWalkgraph(Ablate(out));
  EXPECT_EQ(result.exit_code, 0);
  EXPECT_THAT(result.output, HasSubstr("walk_03.json: damaged"));
  EXPECT_EQ(files, ResultFiles(out));
}

TEST(Ablate, OnlyNewCellsAreComputedWhenAStudyGrows) {
  const std::string out = FreshPath("out"), fresh = FreshPath("fresh");
  ASSERT_EQ(RunWalkgraph(Ablate(out)).exit_code, 0);
  std::vector<std::string> wider = Ablate(out);
  wider.back() = "--factors=step,fingerprint,map_error,step_scale";
  ASSERT_EQ(RunWalkgraph(wider).exit_code, 0);
  std::vector<std::string> at_once = Ablate(fresh);
  at_once.back() = wider.back();
  ASSERT_EQ(RunWalkgraph(at_once).exit_code, 0);
  EXPECT_EQ(ResultFiles(out), ResultFiles(fresh));
}

TEST(Ablate, RefusesAFolderOfOtherInputsAndSaysWhatDiffers) {
  const std::string out = FreshPath("out");
  ASSERT_EQ(RunWalkgraph(Ablate(out)).exit_code, 0);
  const auto files = ResultFiles(out);
  const ProgramResult other = RunWalkgraph(Ablate(out, {"--set=solver.hypotheses=2"}));
  EXPECT_EQ(other.exit_code, 2);
  EXPECT_THAT(other.output, HasSubstr("solver.hypotheses"));
  std::string record = ReadText(out + "/study.json");
  const std::string version = "\"version\": \"";
  record.insert(record.find(version) + version.size(), "0.0.");
  std::ofstream(out + "/study.json") << record;
  const ProgramResult older = RunWalkgraph(Ablate(out));
  EXPECT_EQ(older.exit_code, 2);
  EXPECT_THAT(older.output, HasSubstr("version 0.0."));
  auto kept = ResultFiles(out);
  kept["study.json"] = files.at("study.json");
  EXPECT_EQ(kept, files);  // nothing lost
}

TEST(Ablate, RefusesAFolderOfSomethingElse) {
  const std::string out = FreshPath("out");
  std::filesystem::create_directories(out);
  std::ofstream(out + "/thesis.tex") << "years of work";
  const ProgramResult result = RunWalkgraph(Ablate(out));
  EXPECT_EQ(result.exit_code, 2);
  EXPECT_THAT(result.output, HasSubstr("thesis.tex"));
}

TEST(Ablate, ShardsInOneFolderEndAsOneProcessDoes) {
  const std::string whole = FreshPath("whole"), shared = FreshPath("shared");
  ASSERT_EQ(RunWalkgraph(Ablate(whole)).exit_code, 0);
  for (const char* shard : {"--shard=3/3", "--shard=1/3"}) {
    const ProgramResult part = RunWalkgraph(Ablate(shared, {shard}));
    ASSERT_EQ(part.exit_code, 0);
    EXPECT_THAT(part.output, HasSubstr("walks of the study are missing"));
  }
  EXPECT_FALSE(std::filesystem::exists(shared + "/summary.json"));
  ASSERT_EQ(RunWalkgraph(Ablate(shared, {"--shard=2/3"})).exit_code, 0);
  EXPECT_EQ(ResultFiles(whole), ResultFiles(shared));
}

TEST(Ablate, ReportMergesShardsOfTheirOwnFolders) {
  const std::string whole = FreshPath("whole"), merged = FreshPath("merged");
  ASSERT_EQ(RunWalkgraph(Ablate(whole)).exit_code, 0);
  std::vector<std::string> report = {"report", "--out=" + merged + "/study.html"};
  for (const char* i : {"1", "2"}) {
    const std::string part = FreshPath(std::string("part") + i);
    ASSERT_EQ(RunWalkgraph(Ablate(part, {"--shard=" + std::string(i) + "/2"})).exit_code, 0);
    report.push_back(part);
  }
  ASSERT_EQ(RunWalkgraph(report).exit_code, 0);
  auto summaries = Summaries(whole);
  summaries.erase("study.json");
  auto found = Summaries(merged + "/study");
  std::erase_if(found, [](const auto& file) { return file.first.rfind("figures/", 0) == 0; });
  EXPECT_EQ(summaries, found);
  EXPECT_THAT(ReadText(merged + "/study.html"), HasSubstr("batch:all"));
}

TEST(Ablate, ReportRefusesShardsThatAreNotAllThere) {
  const std::string part = FreshPath("part");
  ASSERT_EQ(RunWalkgraph(Ablate(part, {"--shard=1/2"})).exit_code, 0);
  const ProgramResult result = RunWalkgraph({"report", part, "--out=" + FreshPath("p.html")});
  EXPECT_EQ(result.exit_code, 3);
  EXPECT_THAT(result.output, HasSubstr("7 walks are missing"));
}

TEST(Ablate, AStudyFileIsCheckedWithItsLine) {
  const std::string study = FreshPath("study.yaml"), out = FreshPath("out");
  const auto Output = [&](const std::string& text) {
    std::ofstream(study) << "datasets: [" + kDataset + "]\n" + text;
    return RunWalkgraph({"ablate", "--study=" + study, "--out=" + out}).output;
  };
  EXPECT_THAT(Output("metods: [wknn]\n"), HasSubstr(":2: unknown key \"metods\", did you mean"));
  EXPECT_THAT(Output("grids:\n- method: wknn\n  keys: {baselines.wknn.kk: [1]}\n"),
              HasSubstr(":4: "));
  EXPECT_THAT(Output("factors: {list: [step, stepp]}\n"), HasSubstr("unknown factor \"stepp\""));
  EXPECT_THAT(Output("methods: [wknn, wknn]\n"), HasSubstr("twice"));
  EXPECT_THAT(Output("methods: [wknn]\nreference: batch\n"), HasSubstr("expected one of"));
}

TEST(Ablate, WhatAStudyFileDeclaresIsNoFlagBesideIt) {
  const std::string study = FreshPath("study.yaml"), out = FreshPath("out");
  std::ofstream(study) << "datasets: [" + kDataset + "]\nmethods: [wknn]\n";
  for (const char* flag : {"--folds=3", "--split=trial", "--floor=unknown", "--methods=nn"}) {
    const ProgramResult result = RunWalkgraph({"ablate", "--study=" + study, "--out=" + out, flag});
    EXPECT_EQ(result.exit_code, 2) << flag;
    EXPECT_THAT(result.output, HasSubstr("not beside it")) << flag;
  }
  EXPECT_FALSE(std::filesystem::exists(out));
}

TEST(Ablate, AGridIsEveryCombinationAndANewMapIsTrainedWhereItMatters) {
  const std::string study = FreshPath("study.yaml"), out = FreshPath("out");
  std::ofstream(study) << "datasets: {s: " << kDataset << "}\nfolds: 2\nmethods: [wknn]\ngrids:\n"
                       << "- method: wknn\n  keys: {baselines.wknn.k: [5, 1], "
                       << "radio_map.positions: [smoother, walked_distance]}\n";
  ASSERT_EQ(RunWalkgraph({"ablate", "--study=" + study, "--out=" + out}).exit_code, 0);
  const std::string csv = ReadText(out + "/tables/cells.csv");
  const auto RowOf = [&](const std::string& cell) {
    const std::size_t begin = csv.find("\n" + cell + ",") + 1;
    return csv.substr(begin + cell.size(), csv.find('\n', begin) - begin - cell.size());
  };
  // As configured anyway: the same numbers by another way, and no difference to test.
  const std::string grid = "wknn[baselines.wknn.k=";
  EXPECT_THAT(RowOf(grid + "5 radio_map.positions=smoother]"),
              HasSubstr(",0.0000,0.0000 .. 0.0000,-"));
  EXPECT_NE(RowOf(grid + "5 radio_map.positions=walked_distance]"),
            RowOf(grid + "5 radio_map.positions=smoother]"));
  EXPECT_NE(RowOf(grid + "1 radio_map.positions=smoother]"),
            RowOf(grid + "5 radio_map.positions=smoother]"));
}

TEST(Ablate, AFullDiskIsAClearMessageAndLosesNothing) {
  const std::string out = FreshPath("out");
  ASSERT_EQ(RunWalkgraph(Ablate(out)).exit_code, 0);
  std::filesystem::remove(SomeCellFile(out));
  const auto before = ResultFiles(out);
  // A limit on the size of files, whose signal is ignored, fails a write as a full disk does.
  std::string command = "trap '' XFSZ; ulimit -f 1; exec " WALKGRAPH_BINARY;
  for (const std::string& word : Ablate(out)) command += " '" + word + "'";
  const int status = std::system((command + " >/dev/null 2>" + out + "_errors").c_str());
  EXPECT_NE(status, 0);
  EXPECT_THAT(ReadText(out + "_errors"), HasSubstr("cannot be written"));
  EXPECT_EQ(ResultFiles(out), before);
}

}  // namespace
}  // namespace walkgraph
