#include "frontends/radio_map/map_update.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <string>
#include <utility>
#include <vector>

#include "frontends/radio_map/trainer.h"
#include "solvers/synthetic_site.h"

namespace walkgraph {
namespace {

using testing::SyntheticSite;

// Walks through the hall whose places are known, in a world where one transmitter has another power
// and one is silent.
class LocatedWalks {
 public:
  LocatedWalks(SyntheticSite* site, float altered_db, bool silences) {
    for (int i = 0; i < 8; ++i) {
      std::vector<Eigen::Vector2d> truth;
      evidence_.push_back(site->Walk(
          {{6, 6 + i}, {42, 6 + i}, {42, 30 - i}, {6, 30 - i}, {6, 8 + i}}, 0.1, 2, &truth));
      std::vector<RadioReading>& readings = evidence_.back().readings;
      for (RadioReading& reading : readings) {
        if (reading.transmitter == 0) reading.rssi_dbm += altered_db;
      }
      if (silences) {
        std::erase_if(readings, [](const RadioReading& r) { return r.transmitter == 1; });
      }
      trajectories_.push_back(testing::TrueTrajectory(truth));
    }
    for (std::size_t i = 0; i < evidence_.size(); ++i) {
      walks_.push_back({&evidence_[i], trajectories_[i], "trial" + std::to_string(i)});
    }
  }
  const std::vector<SurveyWalk>& walks() const { return walks_; }

 private:
  std::vector<Evidence> evidence_;
  std::vector<Trajectory> trajectories_;
  std::vector<SurveyWalk> walks_;
};

TEST(MapUpdate, FindsWhatChangedAndNothingElse) {
  SyntheticSite site(51, 12);
  const LocatedWalks located(&site, 8, true);
  for (const TransmitterChange& change :
       FindChanges(site.site, site.site.maps[0], located.walks(), {})) {
    if (change.transmitter == 0) {
      EXPECT_NEAR(change.offset_db, 8, 2);
    } else if (change.transmitter != 1) {
      EXPECT_NEAR(change.offset_db, 0, 3 * change.offset_sigma_db + 1) << change.transmitter;
    }
    EXPECT_EQ(change.vanished, change.transmitter == 1) << change.transmitter;
  }
}

// The survey's readings of what changed follow; what vanished leaves the site.
TEST(MapUpdate, MovesTheSurveyAndForgetsTheVanished) {
  SyntheticSite site(52, 12);
  const LocatedWalks located(&site, 8, true);
  const Site updated = UpdateSite(site.site, located.walks(), {}, {});
  EXPECT_GT(updated.scans.size(), site.site.scans.size());
  EXPECT_GT(updated.path.size(), site.site.path.size());
  for (const SurveyScan& scan : updated.scans) {
    for (const SurveyReading& reading : scan.readings) EXPECT_NE(reading.transmitter, 1U);
  }
  const Eigen::Vector2d at(24, 18);
  const RadioMap& map = updated.maps.at(0);
  const double now = map.EvaluateValue(map.FindField(0), EvaluateBasis(map.grid, at)).mean_dbm;
  EXPECT_NEAR(now - site.MeanDbm(0, at), 8, 3);
}

std::vector<double> MeansOf(const Site& site) {
  const RadioMap& map = site.maps.at(0);
  std::vector<double> means;
  for (const auto& [x, y] : {std::pair(24.0, 18.0), {10.0, 10.0}, {40.0, 28.0}}) {
    const FieldBasis basis = EvaluateBasis(map.grid, {x, y});
    for (std::size_t f = 0; f < map.fields.size(); ++f) {
      means.push_back(map.EvaluateValue(static_cast<int>(f), basis).mean_dbm);
    }
  }
  return means;
}

// Located readings are placed worse than surveyed ones: where nothing changed the survey's stay
// alone, and the walks only count as heard.
TEST(MapUpdate, FieldsOfWhatDidNotChangeStayTheSurveys) {
  SyntheticSite site(54, 12);
  const LocatedWalks located(&site, 0, false);
  for (const TransmitterChange& change :
       FindChanges(site.site, site.site.maps[0], located.walks(), {})) {
    ASSERT_FALSE(change.changed()) << change.transmitter;
  }
  Site retrained = site.site;
  RetrainMaps({}, site.site, &retrained);
  MapChangeSettings settings;
  settings.near_survey_m = 1000;
  EXPECT_EQ(MeansOf(UpdateSite(site.site, located.walks(), {}, settings)), MeansOf(retrained));
  settings.near_survey_m = -1;
  EXPECT_NE(MeansOf(UpdateSite(site.site, located.walks(), {}, settings)), MeansOf(retrained));
}

// A transmitter that has lost 12 dB is no longer heard where it was weak.
TEST(MapUpdate, WhatFallsUnderTheWeakestReadingIsNotHeard) {
  SyntheticSite site(55, 12);
  const LocatedWalks located(&site, -12, false);
  const auto readings_of_first = [](const Site& of, std::size_t scans) {
    std::vector<float> values;
    for (std::size_t s = 0; s < scans; ++s) {
      for (const SurveyReading& reading : of.scans[s].readings) {
        if (reading.transmitter == 0) values.push_back(reading.rssi_dbm);
      }
    }
    return values;
  };
  float weakest_dbm = 0;
  for (const SurveyScan& scan : site.site.scans) {
    for (const SurveyReading& reading : scan.readings) {
      weakest_dbm = std::min(weakest_dbm, reading.rssi_dbm);
    }
  }
  const Site updated = UpdateSite(site.site, located.walks(), {}, {});
  const std::vector<float> before = readings_of_first(site.site, site.site.scans.size());
  const std::vector<float> after = readings_of_first(updated, site.site.scans.size());
  ASSERT_FALSE(after.empty());
  EXPECT_LT(after.size(), before.size());
  EXPECT_GE(*std::min_element(after.begin(), after.end()), weakest_dbm);
}

// A transmitter that the survey never heard joins, and nobody else's readings change hands.
TEST(MapUpdate, NewTransmittersShiftNoIndex) {
  SyntheticSite site(53, 4);
  Evidence evidence = site.Walk({{6, 6}, {42, 6}}, 0.1, 2);
  evidence.transmitters.insert(evidence.transmitters.begin(), {Radio::kWifi, "aa first by name"});
  for (RadioReading& reading : evidence.readings) ++reading.transmitter;
  RadioReading heard = evidence.readings.front();
  heard.transmitter = 0;
  evidence.readings.insert(evidence.readings.begin(), heard);
  Trajectory trajectory;
  for (int t = 0; t < 36; ++t) {
    PoseEstimate pose;
    pose.time_ns = SyntheticSite::At(t);
    pose.position_m.head<2>() = Eigen::Vector2d(6 + t, 6);
    pose.floor = 1;
    trajectory.poses.push_back(pose);
  }
  const Site joined = WithWalks(site.site, {{&evidence, trajectory, ""}});
  ASSERT_EQ(joined.transmitters.size(), site.site.transmitters.size() + 1);
  EXPECT_TRUE(std::is_sorted(joined.transmitters.begin(), joined.transmitters.end()));
  for (std::size_t s = 0; s < site.site.scans.size(); ++s) {
    for (std::size_t r = 0; r < site.site.scans[s].readings.size(); ++r) {
      const std::uint32_t before = site.site.scans[s].readings[r].transmitter;
      const std::uint32_t after = joined.scans[s].readings[r].transmitter;
      EXPECT_EQ(joined.transmitters[after].name, site.site.transmitters[before].name);
    }
  }
  EXPECT_EQ(joined.transmitters[joined.maps[0].fields[0].transmitter].name,
            site.site.transmitters[site.site.maps[0].fields[0].transmitter].name);
}

}  // namespace
}  // namespace walkgraph
