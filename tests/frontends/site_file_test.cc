#include "frontends/radio_map/site_file.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cstddef>
#include <filesystem>
#include <string>
#include <utility>

#include "data/input_error.h"
#include "data/temporary_folder.h"

namespace walkgraph {
namespace {

using ::testing::AllOf;
using ::testing::HasSubstr;
using ::testing::StartsWith;

// A site with something in every member.
Site SmallSite() {
  Site site;
  site.building.name = "hall";
  site.building.origin = GeoReference{41.38, 2.17, 0.3};
  Floor floor;
  floor.number = -1;
  floor.name = "B1";
  floor.height_m = -4.5;
  floor.max_corner = {20, 16};
  floor.outline = {{{0, 0}, {20, 0}, {20, 16}, {0, 16}}};
  floor.ways = {{{1, 2}, {5, 2}, {5, 8}}, {{0, 1}, {1, 2}}};
  floor.obstacles = {{{5, 5}, {6, 5}, {6, 6}}, {{9, 9}, {9.5, 9}, {9.5, 10}}};
  floor.image = {"plan.png", {-1, -1}, {21, 17}};
  site.building.floors = {floor};
  site.building.connectors = {{"lift", ConnectorKind::kLift, {{-1, {3, 4}}, {0, {3, 4}}}, 1.5}};
  site.transmitters = {{Radio::kWifi, "ap"}, {Radio::kBeacon, "uuid_1_2_mac"}};
  site.path = {{{1, 2}, -1, 0}, {{2, 2}, -1, 0}};
  site.scans = {{1'560'000'000'000'000'007,
                 3,
                 2,
                 -1,
                 Radio::kBeacon,
                 {{1, -71.5F, 0.25F, {1.5F, 2.0F}, 0.75F, -1.5F}},
                 -2.5F}};
  site.magnetic = {{{1.5F, 2.5F}, -1, 3, 2, 43.5F, 1.0F}};
  RadioMap map;
  map.floor = -1;
  map.radio = Radio::kBeacon;
  map.grid = {{-8, -8}, 4.0, 4, 5};
  map.sigma_min_db = 4.25;
  map.n_eff = 3;
  map.hear_weight = 0.4;
  map.map_error_sigma_m = 1.4;
  map.map_error_growth = 0.35;
  map.body_shadow_db = 1.75;
  map.fields = {{1, 1, 2, 2, 1, -90.0F, 2.5F, -6.0F, {-60, -61}, {1.5F, 1.6F}, {0.5F, -0.5F}, {6, 7}}};
  map.silence_nats.assign(20, 1.25F);
  map.survey_distance_m.assign(20, 7.5F);
  site.maps = {map};
  MagneticMap magnetic;
  magnetic.floor = -1;
  magnetic.grid = {{-2, -2}, 1.0, 5, 4};
  for (MagneticMap::Component& component : magnetic.components) {
    component = {std::vector<float>(20, 30.0F), std::vector<float>(20, 0.5F)};
  }
  magnetic.sigma_min_ut = 1.5;
  magnetic.correlation_s = 2.5;
  magnetic.map_error_sigma_m = 0.7;
  site.magnetic_maps = {magnetic};
  site.barometric_offsets = {{"phone", 1'560'000'000'000'000'000, 314.25, 0.2}};
  site.loudness = {{"phone", Radio::kBeacon, -2.5, 1.25}};
  return site;
}

// The message of the InputError that reading these bytes throws; empty where nothing is thrown.
std::string Complaint(const std::string& bytes) {
  try {
    ParseSite(bytes, "hall.site");
  } catch (const InputError& error) {
    return error.what();
  }
  return {};
}

TEST(SiteFileTest, ReadAndWrittenAgainHasTheSameBytes) {
  const std::string bytes = SerializeSite(SmallSite());
  EXPECT_EQ(SerializeSite(ParseSite(bytes, "hall.site")), bytes);
  const std::string empty = SerializeSite(Site());
  EXPECT_EQ(SerializeSite(ParseSite(empty, "empty.site")), empty);
}

TEST(SiteFileTest, KeepsEveryMember) {
  const Site before = SmallSite();
  const Site site = ParseSite(SerializeSite(before), "hall.site");
  EXPECT_EQ(site.building.name, "hall");
  ASSERT_TRUE(site.building.origin.has_value());
  EXPECT_EQ(site.building.origin->rotation_rad, 0.3);
  const Floor* floor = site.building.FindFloor(-1);
  ASSERT_NE(floor, nullptr);
  EXPECT_EQ(floor->obstacles, before.building.floors[0].obstacles);
  ASSERT_EQ(site.building.connectors.size(), 1U);
  EXPECT_EQ(site.building.connectors[0].stops[1].position, Eigen::Vector2d(3, 4));
  EXPECT_EQ(site.building.connectors[0].radius_m, 1.5);
  EXPECT_EQ(floor->ways.nodes, before.building.floors[0].ways.nodes);
  EXPECT_EQ(floor->ways.links, before.building.floors[0].ways.links);
  EXPECT_EQ(floor->image.max_corner, Eigen::Vector2d(21, 17));
  EXPECT_EQ(site.transmitters, before.transmitters);
  EXPECT_EQ(site.path.back().position_m, Eigen::Vector2d(2, 2));
  ASSERT_EQ(site.scans.size(), 1U);
  EXPECT_EQ(site.scans[0].printed_ns, 1'560'000'000'000'000'007);
  EXPECT_EQ(site.scans[0].readings[0].age_s, 0.25F);
  EXPECT_EQ(site.scans[0].readings[0].heading_rad, 0.75F);
  EXPECT_EQ(site.scans[0].readings[0].shadow_db, -1.5F);
  EXPECT_EQ(site.scans[0].device_offset_db, -2.5F);
  ASSERT_EQ(site.magnetic.size(), 1U);
  EXPECT_EQ(site.magnetic[0].norm_ut, 43.5F);
  ASSERT_NE(site.FindMagneticMap(-1), nullptr);
  EXPECT_EQ(site.FindMagneticMap(-1)->components[1].log_sigma[19], 0.5F);
  EXPECT_EQ(site.FindMagneticMap(0), nullptr);
  const RadioMap* map = site.FindMap(-1, Radio::kBeacon);
  ASSERT_NE(map, nullptr);
  EXPECT_EQ(map->hear_weight, 0.4);
  EXPECT_EQ(map->map_error_sigma_m, 1.4);
  EXPECT_EQ(map->map_error_growth, 0.35);
  EXPECT_EQ(map->body_shadow_db, 1.75);
  EXPECT_EQ(map->fields[0].source_m, Eigen::Vector2f(6, 7));
  EXPECT_EQ(site.FindLoudness("phone", Radio::kWifi), nullptr);
  EXPECT_EQ(site.FindLoudness("", Radio::kBeacon), nullptr);
  ASSERT_NE(site.FindLoudness("phone", Radio::kBeacon), nullptr);
  EXPECT_EQ(site.FindLoudness("phone", Radio::kBeacon)->mean_db, -2.5);
  EXPECT_EQ(site.FindLoudness("phone", Radio::kBeacon)->sigma_db, 1.25);
  EXPECT_EQ(map->survey_distance_m, before.maps[0].survey_distance_m);
  EXPECT_EQ(map->fields[0].logit_hear, before.maps[0].fields[0].logit_hear);
}

// Two sites that differ in any one member must not look alike.
TEST(SiteFileTest, DifferentSitesHaveDifferentBytes) {
  const std::string bytes = SerializeSite(SmallSite());
  Site other = SmallSite();
  other.maps[0].n_eff = 4;
  EXPECT_NE(SerializeSite(other), bytes);
  other = SmallSite();
  other.building.origin.reset();
  EXPECT_NE(SerializeSite(other), bytes);
  other = SmallSite();
  other.scans[0].walk = 4;
  EXPECT_NE(SerializeSite(other), bytes);
}

TEST(SiteFileTest, NoticesEveryCut) {
  const std::string bytes = SerializeSite(SmallSite());
  for (std::size_t length = 0; length < bytes.size(); ++length) {
    ASSERT_THAT(Complaint(bytes.substr(0, length)), StartsWith("hall.site: ")) << length;
  }
  EXPECT_THAT(Complaint(bytes + '\0'), StartsWith("hall.site: "));
}

TEST(SiteFileTest, NoticesEveryFlippedByte) {
  const std::string bytes = SerializeSite(SmallSite());
  for (std::size_t at = 0; at < bytes.size(); ++at) {
    for (const int mask : {0x01, 0x80, 0xff}) {
      std::string damaged = bytes;
      damaged[at] = static_cast<char>(damaged[at] ^ mask);
      ASSERT_THAT(Complaint(damaged), StartsWith("hall.site: ")) << at;
    }
  }
}

TEST(SiteFileTest, NamesTheVersionThatItCannotRead) {
  std::string bytes = SerializeSite(SmallSite());
  bytes[std::string("WALKGRAPHSITE\n").size()] = 99;
  EXPECT_THAT(Complaint(bytes), AllOf(HasSubstr("version 99"), HasSubstr("expected version 9")));
}

TEST(SiteFileTest, TellsWhatIsNoSite) {
  for (const std::string& text : {std::string(), std::string("x,y\n1,2\n"), std::string(500, '\0'),
                                  std::string("WALKGRAPHSITE")}) {
    EXPECT_THAT(Complaint(text), HasSubstr("not a site file"));
  }
}

// Sizes that do not fit each other would be read past their end by a query: the checksum of such a
// file is right when whoever wrote it was wrong.
TEST(SiteFileTest, RefusesInconsistentFields) {
  Site site = SmallSite();
  site.maps[0].fields[0].mean_dbm.pop_back();
  EXPECT_THAT(Complaint(SerializeSite(site)), HasSubstr("sizes do not fit"));
  site = SmallSite();
  site.maps[0].silence_nats.pop_back();
  EXPECT_THAT(Complaint(SerializeSite(site)), HasSubstr("sizes do not fit"));
  site = SmallSite();
  site.maps[0].survey_distance_m.pop_back();
  EXPECT_THAT(Complaint(SerializeSite(site)), HasSubstr("sizes do not fit"));
  site = SmallSite();
  site.maps[0].fields[0].transmitter = 2;
  EXPECT_THAT(Complaint(SerializeSite(site)), HasSubstr("sizes do not fit"));
  site = SmallSite();
  site.scans[0].readings[0].transmitter = 7;
  EXPECT_THAT(Complaint(SerializeSite(site)), HasSubstr("sizes do not fit"));
  site = SmallSite();
  site.maps[0].fields[0].column = 2'147'483'647;
  EXPECT_THAT(Complaint(SerializeSite(site)), HasSubstr("sizes do not fit"));
}

TEST(SiteFileTest, WritesWholeFilesOnly) {
  const TemporaryFolder folder;
  const std::string path = folder.Path("hall.site");
  WriteSiteFile(SmallSite(), path);
  WriteSiteFile(SmallSite(), path);  // over the first
  EXPECT_EQ(SerializeSite(ReadSiteFile(path)), SerializeSite(SmallSite()));
  int files = 0;
  for (const auto& entry : std::filesystem::directory_iterator(folder.Path())) {
    EXPECT_EQ(entry.path().string(), path);
    ++files;
  }
  EXPECT_EQ(files, 1);
  EXPECT_THROW(WriteSiteFile(SmallSite(), folder.Path("missing/hall.site")), std::runtime_error);
}

TEST(SiteFileTest, UnreadablePathsAreBadInput) {
  const TemporaryFolder folder;
  EXPECT_THROW(ReadSiteFile(folder.Path("missing.site")), InputError);
  EXPECT_THROW(ReadSiteFile(folder.Path()), InputError);  // a folder
}

}  // namespace
}  // namespace walkgraph
