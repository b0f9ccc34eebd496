#include "data/dataset.h"

#include <gtest/gtest.h>

#include <string>

#include "data/input_error.h"
#include "data/temporary_folder.h"

namespace walkgraph {
namespace {

constexpr char kIlc20[] =
    "#\tstartTime:1574559495255\n1574559495263\tTYPE_WAYPOINT\t81.3\t93.3\n"
    "1574559495401\tTYPE_ACCELEROMETER\t0\t0\t9.8\t2\n";
constexpr char kGetSensorData[] = "ACCE;0.5;9600.5;-2.0;7.5;5.75;3\n";
constexpr char kCsv[] = "time_s,x_mps2,y_mps2,z_mps2\n1.5,0,0,9.8\n";

TEST(Dataset, RecognisesEachFormatByItsContent) {
  const TemporaryFolder folder;
  folder.Write("set/a/x_Trial07_b.txt", kGetSensorData);
  folder.Write("set/b.txt", kIlc20);
  folder.Write("set/c/accelerometer.csv", kCsv);
  folder.Write("set/c/walk.json", R"({"device":"phone","trial":"T1"})");
  folder.Write("set/notes.txt", "bring batteries\n");
  folder.Write("set/picture.png", "not looked at");
  const Dataset dataset = OpenDataset(folder.Path("set"));
  ASSERT_EQ(dataset.walks.size(), 3U);
  EXPECT_EQ(dataset.walks[0].id, "a__x_Trial07_b");
  EXPECT_EQ(dataset.walks[0].format, "getsensordata");
  EXPECT_EQ(dataset.walks[0].trial, "Trial07");
  EXPECT_EQ(dataset.walks[1].id, "b");
  EXPECT_EQ(dataset.walks[1].format, "ilc20");
  EXPECT_EQ(dataset.walks[1].trial, "b");
  EXPECT_EQ(dataset.walks[2].id, "c");
  EXPECT_EQ(dataset.walks[2].format, "csv");
  EXPECT_EQ(dataset.walks[2].trial, "T1");
  ASSERT_EQ(dataset.unrecognised.size(), 1U);
  EXPECT_TRUE(dataset.unrecognised[0].ends_with("notes.txt"));
  for (const WalkFile& file : dataset.walks) {
    const Walk walk = ReadWalk(file);
    EXPECT_EQ(walk.recording.accelerometer_mps2.size(), 1U) << file.id;
    EXPECT_EQ(walk.recording.id, file.id);
    EXPECT_EQ(walk.report.format, file.format);
  }
}

TEST(Dataset, FindsTheBuildingBesideOrAboveTheWalks) {
  const TemporaryFolder folder;
  folder.Write(
      "set/building.json",
      R"({"name":"house","floors":[{"number":0,"height_m":0,"min_corner":[0,0],"max_corner":[9,9]}]})");
  folder.Write("set/test/c/accelerometer.csv", kCsv);
  EXPECT_EQ(OpenDataset(folder.Path("set")).building.name, "house");
  EXPECT_EQ(OpenDataset(folder.Path("set/test")).building.name, "house");
  EXPECT_EQ(OpenDataset(folder.Path("set/test/")).walks.at(0).id, "c");
}

TEST(Dataset, TakesTheFloorOfAnIlc20WalkFromItsFolder) {
  const TemporaryFolder folder;
  folder.Write("site/B2/floor_info.json", R"({"map_info":{"height":20,"width":40}})");
  folder.Write("site/B2/path_data_files/w.txt", kIlc20);
  const Dataset site = OpenDataset(folder.Path("site"));
  ASSERT_EQ(site.building.floors.size(), 1U);
  EXPECT_EQ(site.building.floors[0].number, -2);
  EXPECT_EQ(site.walks.at(0).id, "B2__path_data_files__w");
  EXPECT_EQ(ReadWalk(site.walks[0]).truth.waypoints.at(0).floor, -2);
  const WalkFile alone = IdentifyWalk(folder.Path("site/B2/path_data_files/w.txt"));
  EXPECT_EQ(alone.id, "w");
  EXPECT_EQ(alone.floor, -2);
}

TEST(Dataset, SaysWhatIsMissing) {
  const TemporaryFolder folder;
  folder.Write("empty/readme.md", "nothing");
  folder.Write("notes.txt", "bring batteries\n");
  folder.Write("nothing.txt", "");
  EXPECT_THROW(OpenDataset(folder.Path("missing")), InputError);
  EXPECT_THROW(OpenDataset(folder.Path("empty")), InputError);
  EXPECT_THROW(OpenDataset(folder.Path("notes.txt")), InputError);
  EXPECT_THROW(IdentifyWalk(folder.Path("missing.txt")), InputError);
  EXPECT_THROW(IdentifyWalk(folder.Path("notes.txt")), InputError);
  EXPECT_THROW(IdentifyWalk(folder.Path("nothing.txt")), InputError);
  EXPECT_THROW(ReadWalk({.path = folder.Path("missing.txt"),
                         .format = "ilc20",
                         .id = "",
                         .trial = "",
                         .floor = {}}),
               InputError);
  EXPECT_THROW(
      ReadWalk(
          {.path = folder.Path("notes.txt"), .format = "gpx", .id = "", .trial = "", .floor = {}}),
      InputError);
}

}  // namespace
}  // namespace walkgraph
