// The frontends on the recorded walks. Set WALKGRAPH_REAL_DATA to the folder that holds ilc20/ and
// ipin2023_t3/; without it every test here reports itself as skipped.

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <filesystem>
#include <map>
#include <string>
#include <vector>

#include "data/angle.h"
#include "data/dataset.h"
#include "frontends/build_evidence.h"
#include "frontends/sensor_figures.h"

namespace walkgraph {
namespace {

struct BuiltWalk {
  Evidence evidence;
  Truth truth;  // building frame
  std::int64_t wifi_rows = 0;
  SensorFigures figures;
};

// Every walk of a folder below the recorded data, read once per test program.
const std::vector<BuiltWalk>& Built(const std::string& folder) {
  static std::map<std::string, std::vector<BuiltWalk>> cache;
  const auto [it, added] = cache.try_emplace(folder);
  if (!added) return it->second;
  const Dataset dataset = OpenDataset(folder);
  const double rotation = dataset.building.origin ? -dataset.building.origin->rotation_rad : 0.0;
  for (const WalkFile& file : dataset.walks) {
    const Walk walk = ReadWalk(file);
    BuiltWalk built;
    built.evidence = BuildEvidence(walk.recording, {});
    built.truth = ToBuildingFrame(walk.truth, dataset.building);
    for (const RadioRow& row : walk.recording.radio_rows) {
      built.wifi_rows += walk.recording.transmitters[row.transmitter].radio == Radio::kWifi;
    }
    built.figures = ComputeSensorFigures(built.evidence, built.truth, rotation);
    it->second.push_back(std::move(built));
  }
  return it->second;
}

SensorSummary SummaryOf(const std::vector<BuiltWalk>& walks) {
  std::vector<SensorFigures> figures;
  for (const BuiltWalk& walk : walks) figures.push_back(walk.figures);
  return Summarize(figures);
}

class RealFrontends : public testing::Test {
 protected:
  void SetUp() override {
    const char* root = std::getenv("WALKGRAPH_REAL_DATA");
    if (root == nullptr) GTEST_SKIP() << "WALKGRAPH_REAL_DATA is not set";
    root_ = root;
    for (const std::string& folder : {root_ + "/ilc20/data/site1", Ipin2023()}) {
      if (!std::filesystem::is_directory(folder)) GTEST_SKIP() << "no folder " << folder;
    }
  }

  std::string Ipin2023() const { return root_ + "/ipin2023_t3"; }
  std::vector<std::string> Ilc20Floors() const {
    return {root_ + "/ilc20/data/site1/B1", root_ + "/ilc20/data/site1/F1",
            root_ + "/ilc20/data/site1/F2"};
  }

  std::string root_;
};

TEST_F(RealFrontends, Ilc20HeadingIsUnbiasedOnEveryFloor) {
  for (const std::string& floor : Ilc20Floors()) {
    const SensorSummary summary = SummaryOf(Built(floor));
    ASSERT_GT(summary.straight_legs, 200) << floor;
    EXPECT_NEAR(RadiansToDegrees(summary.heading_walking.MeanRad()), 1.5, 2.5) << floor;
    EXPECT_NEAR(RadiansToDegrees(summary.heading_walking.RmsRad()), 14, 4) << floor;
  }
}

TEST_F(RealFrontends, StepsTimesWeinbergLengthIsTheDistanceWalked) {
  for (const std::string& floor : Ilc20Floors()) {
    const SensorSummary summary = SummaryOf(Built(floor));
    EXPECT_NEAR(summary.distance_rate_mean, 0, 0.1) << floor;
    EXPECT_LT(summary.distance_rate_std, 0.25) << floor;
  }
  EXPECT_NEAR(SummaryOf(Built(Ipin2023())).distance_rate_mean, -0.05, 0.1);
}

TEST_F(RealFrontends, DeadReckonedLegsAreRightToASixthInTheMedian) {
  for (const std::string& floor : Ilc20Floors()) {
    EXPECT_LT(SummaryOf(Built(floor)).displacement_error_median, 0.18) << floor;
  }
  EXPECT_LT(SummaryOf(Built(Ipin2023())).displacement_error_median, 0.17);
}

TEST_F(RealFrontends, PeopleWhoWalkTakeStepsAtAHumanRate) {
  for (const std::string& floor : Ilc20Floors()) {
    for (const BuiltWalk& walk : Built(floor)) {
      double walking_s = 0;
      for (const MotionInterval& interval : walk.evidence.motion) {
        if (interval.state != MotionState::kWalking) continue;
        walking_s += SecondsBetween(interval.begin_ns, interval.end_ns);
      }
      if (walking_s < 5) continue;
      const double rate_hz = static_cast<double>(walk.evidence.steps.size()) / walking_s;
      EXPECT_GT(rate_hz, 1.2) << walk.evidence.id;
      EXPECT_LT(rate_hz, 2.6) << walk.evidence.id;
    }
  }
}

// Seconds 0-40 of an IPIN recording wave the phone, then it stands still until the first waypoint.
TEST_F(RealFrontends, WavingBeforeTheWalkIsHandlingAndNotWalking) {
  double waved_s = 0;
  double stood_s = 0;
  std::int64_t steps = 0;
  const std::vector<BuiltWalk>& walks = Built(Ipin2023());
  for (const BuiltWalk& walk : walks) {
    ASSERT_FALSE(walk.truth.waypoints.empty());
    const TimeNs start = walk.truth.waypoints.front().time_ns - kNsPerSecond;
    for (const MotionInterval& interval : walk.evidence.motion) {
      const double s = SecondsBetween(interval.begin_ns, std::min(interval.end_ns, start));
      if (s <= 0) continue;
      if (interval.state == MotionState::kHandling) waved_s += s;
      if (interval.state == MotionState::kStanding) stood_s += s;
    }
    steps += std::count_if(walk.evidence.steps.begin(), walk.evidence.steps.end(),
                           [&](const StepEvidence& step) { return step.end_ns < start; });
  }
  const auto n = static_cast<double>(walks.size());
  EXPECT_GT(waved_s / n, 25);
  EXPECT_GT(stood_s / n, 20);
  // What is left are hands that settle, two or three "steps" a recording.
  EXPECT_LT(static_cast<double>(steps) / n, 3);
}

// Facts about the recordings that were counted independently of this code.
TEST_F(RealFrontends, WifiRowsAreReadingsRepeatsOrFromBefore) {
  for (const std::string& floor : Ilc20Floors()) {
    std::int64_t rows = 0, repeats = 0, before = 0, unique = 0;
    for (const BuiltWalk& walk : Built(floor)) {
      const auto count = [&](const char* name) {
        const auto it = walk.evidence.counts.find(name);
        return it == walk.evidence.counts.end() ? 0 : it->second;
      };
      rows += walk.wifi_rows;
      repeats += count("wifi_repeat");
      before += count("wifi_before_begin");
      unique += std::count_if(walk.evidence.readings.begin(), walk.evidence.readings.end(),
                              [&](const RadioReading& reading) {
                                return walk.evidence.transmitters[reading.transmitter].radio ==
                                       Radio::kWifi;
                              });
      EXPECT_TRUE(
          std::all_of(walk.evidence.readings.begin(), walk.evidence.readings.end(),
                      [&](const RadioReading& r) { return r.heard_ns >= walk.evidence.begin_ns; }));
    }
    EXPECT_EQ(unique + repeats + before, rows) << floor;
    EXPECT_NEAR(static_cast<double>(repeats) / static_cast<double>(rows), 0.42, 0.05) << floor;
    EXPECT_NEAR(static_cast<double>(before) / static_cast<double>(unique + before), 0.08, 0.02)
        << floor;
  }
}

TEST_F(RealFrontends, PressureIsThereWhereThePhoneHasABarometer) {
  for (const BuiltWalk& walk : Built(Ipin2023())) {
    EXPECT_GT(walk.evidence.barometric_height_m.size(), 100u) << walk.evidence.id;
  }
  for (const BuiltWalk& walk : Built(Ilc20Floors()[1])) {
    EXPECT_TRUE(walk.evidence.barometric_height_m.empty());
  }
}

}  // namespace
}  // namespace walkgraph
