#include "eval/report/report.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>
#include <iterator>
#include <nlohmann/json.hpp>
#include <string>

#include "data/input_error.h"
#include "eval/report/result_folder.h"

namespace walkgraph {
namespace {

using Json = nlohmann::ordered_json;
using testing::HasSubstr;
using testing::Not;
namespace fs = std::filesystem;

class ReportTest : public testing::Test {
 protected:
  ReportTest()
      : dir_(fs::path(testing::TempDir()) /
             testing::UnitTest::GetInstance()->current_test_info()->name()) {
    fs::remove_all(dir_);
    fs::create_directories(dir_ / "out/walks");
    fs::create_directories(dir_ / "out/trajectories");
    Write("plan.png", "\x89PNG plan");
    Write("out/building.json",
          R"({"name": "Mall", "floors": [{"number": 0, "name": "F1", "height_m": 0,
              "min_corner_m": [0, 0], "max_corner_m": [40, 20], "outline_m": [], "obstacles_m": [],
              "image": {"path": ")" +
              (dir_ / "plan.png").string() +
              R"(", "min_corner_m": [0, 0], "max_corner_m": [40, 20]}}]})");
    Write("out/walks/a.b.json",
          R"({"walk": "a.b", "fold": 0, "survey_distance_m": null, "waypoints":
              [{"time_ns": 1500000000000000000, "x_m": 1.5, "y_m": 2, "floor": 0},
               {"time_ns": 1500000004000000000, "x_m": 5, "y_m": 2, "floor": 0}],
              "methods": {"batch": {"status": "ok", "messages": ["</script><b>"], "errors_m": [1, 2]},
                          "pdr": {"status": "unsupported", "messages": [], "errors_m": []}}})");
    Write("out/trajectories/a.b.batch.csv",
          std::string(kHeader) +
              "1500000000000000000,1.0001,2,0,0,0.1,0.25,0.01,0.5,,0.01,1\n"
              "1500000002500000000,3,2.1,0,0,0.1,,,,,,1\n");
  }
  ~ReportTest() override { fs::remove_all(dir_); }

  void Write(const std::string& name, const std::string& text) const {
    std::ofstream(dir_ / name, std::ios::binary) << text;
  }
  std::string Out() const { return (dir_ / "out").string(); }
  std::string Page() const {
    WriteReport({Out()}, (dir_ / "page.html").string());
    std::ifstream stream(dir_ / "page.html", std::ios::binary);
    return {std::istreambuf_iterator<char>(stream), {}};
  }

  static constexpr const char* kHeader =
      "time_ns,x_m,y_m,z_m,floor,heading_rad,cov_xx,cov_xy,cov_yy,cov_zz,cov_hh,modes\n";
  fs::path dir_;
};

TEST_F(ReportTest, PageNeedsNothingElseAndHoldsTheFolder) {
  const std::string page = Page();
  for (const char* outside : {"src=\"", "<link rel=\"stylesheet", "@import", "fetch(", "@DATA@"}) {
    EXPECT_THAT(page, Not(HasSubstr(outside)));
  }
  // The only addresses are the name of the SVG format and what the plotting library's comment says
  // of its origin: nobody fetches them.
  std::size_t addresses = 0;
  for (std::size_t at = 0; (at = page.find("http", at)) != std::string::npos; ++at) {
    EXPECT_TRUE(page.compare(at, 26, "http://www.w3.org/2000/svg") == 0 ||
                page.compare(at - 4, 40, "/*! https://github.com/leeoniya/uPlot (v") == 0)
        << page.substr(at, 60);
    ++addresses;
  }
  EXPECT_GE(addresses, 1u);
  EXPECT_THAT(page, HasSubstr("The MIT License"));
  EXPECT_THAT(page, HasSubstr("data:image/png;base64," + Base64("\x89PNG plan")));

  const std::string begin = "<script type=\"application/json\" id=\"data\">";
  const std::size_t from = page.find(begin) + begin.size();
  const Json data = Json::parse(page.substr(from, page.find("</script>", from) - from));
  Json run = data["runs"][0];
  ASSERT_GE(run["figures"].size(), 2u);
  for (const Json& figure : run["figures"]) {
    EXPECT_THAT(figure.get<std::string>(), HasSubstr("(1 walk, 2 waypoints)"));
  }
  run.erase("figures");
  EXPECT_EQ(run, ReadResultFolder(Out()));
  EXPECT_EQ(data["runs"][0]["walks"][0]["methods"]["batch"]["messages"][0], "</script><b>");
}

TEST_F(ReportTest, FolderIsReadWithTimesInSeconds) {
  const Json run = ReadResultFolder(Out() + "/");
  EXPECT_EQ(run["name"], "out");
  EXPECT_TRUE(run["summary"].is_null());
  EXPECT_EQ(run["methods"], Json({"batch", "pdr"}));
  const Json& walk = run["walks"][0];
  EXPECT_EQ(walk["walk"], "a.b");
  EXPECT_EQ(walk["waypoints"][1], Json({4.0, 5, 2, 0}));
  const Json& track = walk["methods"]["batch"]["track"];
  EXPECT_EQ(track["t"], Json({0.0, 2.5}));
  EXPECT_EQ(track["x"], Json({1.0, 3.0}));
  EXPECT_EQ(track["yy"], Json({0.5, nullptr}));
  EXPECT_FALSE(walk["methods"]["pdr"].contains("track"));
}

TEST_F(ReportTest, WalkWithoutTruthIsStillDrawn) {
  Write("out/trajectories/new.window.csv",
        std::string(kHeader) + "7000000000,1,2,0,0,0,,,,,,1\n8000000000,2,2,0,0,0,,,,,,1\n");
  const Json run = ReadResultFolder(Out());
  ASSERT_EQ(run["walks"].size(), 2u);
  EXPECT_EQ(run["walks"][1]["walk"], "new");
  EXPECT_TRUE(run["walks"][1]["waypoints"].empty());
  EXPECT_EQ(run["walks"][1]["methods"]["window"]["track"]["t"], Json({0.0, 1.0}));
}

TEST_F(ReportTest, MissingPlanLeavesTheOutline) {
  fs::remove(dir_ / "plan.png");
  EXPECT_FALSE(ReadResultFolder(Out())["building"]["floors"][0].contains("image"));
}

TEST_F(ReportTest, SameFolderGivesTheSameBytes) { EXPECT_EQ(Page(), Page()); }

TEST_F(ReportTest, BrokenInputNamesThePlaceAndLeavesNoPage) {
  const auto message = [this](const std::string& dir) -> std::string {
    try {
      WriteReport({dir}, (dir_ / "page.html").string());
    } catch (const InputError& error) {
      return error.what();
    }
    return "";
  };
  EXPECT_THAT(message((dir_ / "nowhere").string()), HasSubstr("building.json"));
  Write("out/trajectories/a.b.batch.csv", std::string(kHeader) + "1,2,x,0,0,0,,,,,,1\n");
  EXPECT_THAT(message(Out()), HasSubstr("a.b.batch.csv:2: "));
  Write("out/trajectories/a.b.batch.csv", "time_ns,x_m\n");
  EXPECT_THAT(message(Out()), HasSubstr("expected y_m"));
  fs::remove(dir_ / "out/trajectories/a.b.batch.csv");
  Write("out/walks/a.b.json", "{\"walk\": 3");
  EXPECT_THAT(message(Out()), HasSubstr("a.b.json"));
  Write("out/walks/a.b.json", "{\"walk\": 3}");
  EXPECT_THAT(message(Out()), HasSubstr("waypoints"));
  EXPECT_FALSE(fs::exists(dir_ / "page.html"));
}

// RFC 4648, section 10.
TEST(Base64Test, TestVectors) {
  EXPECT_EQ(Base64(""), "");
  EXPECT_EQ(Base64("f"), "Zg==");
  EXPECT_EQ(Base64("fo"), "Zm8=");
  EXPECT_EQ(Base64("foo"), "Zm9v");
  EXPECT_EQ(Base64("foobar"), "Zm9vYmFy");
}

}  // namespace
}  // namespace walkgraph
