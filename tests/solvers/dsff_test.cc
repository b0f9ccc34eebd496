#include "solvers/baselines/dsff/dsff.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <string_view>
#include <vector>

#include "data/angle.h"
#include "solvers/synthetic_site.h"
#include "solvers/two_floors.h"

namespace walkgraph {
namespace {

using testing::SyntheticSite;
using testing::TwoFloors;

DsffEstimator Make(std::string_view name, const DsffSettings& settings = {}) {
  for (const DsffMethod& method : kDsffMethods) {
    if (method.description.name == name) return {method, settings, {}, {}};
  }
  throw std::invalid_argument("no such method");
}

// A synthetic walk whose gyroscope is its heading, off by what a test adds.
struct Walk {
  Evidence evidence;
  std::vector<Eigen::Vector2d> truth;  // by second

  Trajectory TrueTrajectory() const { return testing::TrueTrajectory(truth); }
};

Walk MakeWalk(SyntheticSite* site, const std::vector<Eigen::Vector2d>& corners) {
  Walk walk;
  walk.evidence = site->Walk(corners, 0.02, 3, &walk.truth);
  walk.evidence.gyro_yaw_rad = walk.evidence.absolute_heading_rad;
  return walk;
}

double MeanError(const EstimateResult& result, const std::vector<Eigen::Vector2d>& truth) {
  double sum = 0;
  for (std::size_t t = 0; t < truth.size(); ++t) {
    const PoseEstimate pose = result.trajectory.At(SyntheticSite::At(static_cast<double>(t)));
    sum += (pose.position_m.head<2>() - truth[t]).norm() / static_cast<double>(truth.size());
  }
  return sum;
}

const std::vector<Eigen::Vector2d> kRound{{6, 6}, {42, 6}, {42, 30}, {6, 30}, {6, 8}, {40, 8}};

// Few access points, so that motion has something to add.
TEST(Dsff, MotionBeatsTheMapAlone) {
  SyntheticSite site(21, 5);
  double absolute = 0, hmm = 0;
  for (int i = 0; i < 5; ++i) {
    const Walk walk = MakeWalk(&site, kRound);
    absolute += MeanError(Make("dsff_absolute").Estimate(site.site, walk.evidence), walk.truth);
    hmm += MeanError(Make("dsff_hmm").Estimate(site.site, walk.evidence), walk.truth);
  }
  EXPECT_LT(hmm, 0.8 * absolute);
}

// What a sensor's blocks have learnt after a minute, mean over walks; and whether it paid.
struct Lesson {
  double learnt = 0, hmm_error_m = 0, error_m = 0;
};
template <typename Disturb>
Lesson Teach(SyntheticSite site, std::string_view method, std::string_view state_name,
             const Disturb& disturb) {
  constexpr int kWalks = 6;
  Lesson lesson;
  double states = 0;
  for (int i = 0; i < kWalks; ++i) {
    Walk walk = MakeWalk(&site, kRound);
    disturb(&walk.evidence);
    const EstimateResult hmm = Make("dsff_hmm").Estimate(site.site, walk.evidence);
    const EstimateResult result = Make(method).Estimate(site.site, walk.evidence);
    lesson.hmm_error_m += MeanError(hmm, walk.truth) / kWalks;
    lesson.error_m += MeanError(result, walk.truth) / kWalks;
    for (const SlowStateEstimate& state : result.slow_states) {
      if (state.name != state_name || state.time_ns < SyntheticSite::At(60)) continue;
      lesson.learnt += state.value;
      ++states;
    }
  }
  lesson.learnt /= states;
  return lesson;
}

// What the method is for: a heading off by a constant angle is learnt, where the fixes are good
// enough (40 access points) to tell the trace from what the heading says.
TEST(Dsff, ErrorBlocksLearnAHeadingBiasAndGainByIt) {
  const double bias = DegreesToRadians(30);
  const Lesson lesson =
      Teach(SyntheticSite(22, 40), "dsff_heading", "heading_error_rad", [&](Evidence* evidence) {
        for (double& heading : evidence->absolute_heading_rad.value) heading += bias;
        for (double& heading : evidence->gyro_yaw_rad.value) heading += bias;
      });
  EXPECT_GT(lesson.learnt, 0.3 * bias);
  EXPECT_LT(lesson.learnt, 1.3 * bias);
  EXPECT_LT(lesson.error_m, 0.5 * lesson.hmm_error_m);
}

// Steps taken to be half again as long. (A trace through noisy fixes is longer than the walk, so
// that small errors of this sign are not seen.)
TEST(Dsff, ErrorBlocksLearnThatStepsAreTooLong) {
  const Lesson lesson =
      Teach(SyntheticSite(22, 40), "dsff_distance", "step_length_error_m", [](Evidence* evidence) {
        for (StepEvidence& step : evidence->steps) step.length_m *= 1.5;
      });
  EXPECT_GT(lesson.learnt, 0.1);  // of 0.35
  EXPECT_LT(lesson.error_m, lesson.hmm_error_m);
}

TEST(Dsff, TruthInPlaceOfASensorIsNotWorseAndIsAskedForAlone) {
  SyntheticSite site(23, 6);
  double hmm = 0, told = 0;
  for (int i = 0; i < 5; ++i) {
    Walk walk = MakeWalk(&site, kRound);
    for (double& heading : walk.evidence.absolute_heading_rad.value) heading += 0.5;
    for (double& heading : walk.evidence.gyro_yaw_rad.value) heading += 0.5;
    hmm += MeanError(Make("dsff_hmm").Estimate(site.site, walk.evidence), walk.truth);
    const DsffEstimator knowing = Make("dsff_true_both");
    EXPECT_TRUE(knowing.uses_truth());
    told += MeanError(knowing.EstimateKnowing(walk.TrueTrajectory(), site.site, walk.evidence),
                      walk.truth);
  }
  EXPECT_LT(told, hmm);
  EXPECT_FALSE(Make("dsff").uses_truth());
}

// What the truth knows reaches nobody who does not ask.
TEST(Dsff, OtherVariantsDoNotHeedTheTruth) {
  SyntheticSite site(24, 6);
  const Walk walk = MakeWalk(&site, kRound);
  const EstimateResult a = Make("dsff").Estimate(site.site, walk.evidence);
  const EstimateResult b =
      Make("dsff").EstimateKnowing(walk.TrueTrajectory(), site.site, walk.evidence);
  ASSERT_EQ(a.trajectory.poses.size(), b.trajectory.poses.size());
  for (std::size_t i = 0; i < a.trajectory.poses.size(); ++i) {
    EXPECT_EQ(a.trajectory.poses[i].position_m, b.trajectory.poses[i].position_m);
  }
}

TEST(Dsff, SaysWhatIsMissing) {
  SyntheticSite site(25);
  const Walk whole = MakeWalk(&site, {{6, 6}, {42, 6}});
  const auto lack = [&](std::string_view name, auto&& spoil) {
    Evidence evidence = whole.evidence;
    spoil(&evidence);
    const EstimateResult result = Make(name).Estimate(site.site, evidence);
    EXPECT_TRUE(result.trajectory.empty());
    return result.status == EstimateStatus::kUnsupported ? result.messages.front() : "";
  };
  const auto nothing = [](Evidence* /*evidence*/) {};
  EXPECT_NE(lack("dsff", [](Evidence* e) { e->motion.clear(); }).find("accelerometer"),
            std::string::npos);
  EXPECT_NE(lack("dsff", [](Evidence* e) { e->gyro_yaw_rad = {}; }).find("gyroscope"),
            std::string::npos);
  EXPECT_NE(lack("dsff", [](Evidence* e) { e->absolute_heading_rad = {}; }).find("heading"),
            std::string::npos);
  EXPECT_NE(lack("dsff_pressure", nothing).find("one floor"), std::string::npos);
  EXPECT_NE(lack("dsff_true_heading", nothing).find("truth"), std::string::npos);
  Evidence deaf = whole.evidence;
  deaf.readings.clear();
  EXPECT_EQ(Make("dsff").Estimate(site.site, deaf).status, EstimateStatus::kUnobservable);
  Evidence elsewhere = whole.evidence;
  elsewhere.floor = 7;
  EXPECT_EQ(Make("dsff").Estimate(site.site, elsewhere).status, EstimateStatus::kUnobservable);
}

// A wall down the middle, along which people walk: traces through noisy fixes cross it, but for map
// matching.
TEST(Dsff, MapMatchingKeepsToOneSideOfAWall) {
  SyntheticSite site(26, 5);
  site.site.building.floors[0].obstacles = {{{23.9, -9}, {24.1, -9}, {24.1, 45}, {23.9, 45}}};
  int with = 0, without = 0;
  for (int i = 0; i < 6; ++i) {
    const Walk walk = MakeWalk(&site, {{23.2, 4}, {23.2, 32}, {23.2, 4}, {23.2, 32}});
    DsffSettings settings;
    const auto crossings = [&](bool map_matching) {
      settings.map_matching = map_matching;
      const EstimateResult result = Make("dsff_hmm", settings).Estimate(site.site, walk.evidence);
      EXPECT_TRUE(result.messages.empty());  // the trace never began anew
      const auto& path = result.hypotheses.front().path_m;
      int count = 0;
      for (std::size_t k = 1; k < path.size(); ++k) {
        count += (path[k].x() < 24) != (path[k - 1].x() < 24) ? 1 : 0;
      }
      return count;
    };
    with += crossings(true);
    without += crossings(false);
  }
  EXPECT_GT(without, 0);
  EXPECT_EQ(with, 0);
}

TEST(Dsff, SelectsTheAccessPointsThatVaryMost) {
  SyntheticSite site(27, 6);
  // One that sounds the same everywhere and loud.
  site.site.transmitters.push_back({Radio::kWifi, "everywhere"});
  for (SurveyScan& scan : site.site.scans) {
    scan.readings.push_back({6, -40.0F, 0.0F, scan.readings.front().position_m});
  }
  const std::vector<bool> six = SelectAccessPoints(site.site, 6, -100);
  EXPECT_EQ(std::count(six.begin(), six.end(), true), 6);
  EXPECT_FALSE(six[6]);
  const std::vector<bool> all = SelectAccessPoints(site.site, 0, -100);
  EXPECT_EQ(std::count(all.begin(), all.end(), true), 7);
}

// Each column of the hall has its own field strength: the magnetic density finds it.
TEST(Dsff, MagneticDensityPrefersWhereTheFieldWasMeasured) {
  SyntheticSite site(28);
  for (double x = 0.5; x < 48; x += 0.5) {
    for (double y = 1; y < 36; y += 2) {
      const Eigen::Vector2d at(x, y);
      site.site.magnetic.push_back({at.cast<float>(), 1, 0, 0, static_cast<float>(30 + x), 1.0F});
      site.site.magnetic.push_back({at.cast<float>(), 1, 0, 0, static_cast<float>(30.5 + x), 1.1F});
    }
  }
  const DsffCells cells(site.site, {1}, {ReferenceArea::kSurveyed, 1.0, 3.0});
  const MagneticEmission emission(site.site, cells, {});
  ASSERT_FALSE(emission.empty());
  std::vector<double> log_likelihood(cells.size(), 0.0);
  emission.Add({50.25, 1.05}, &log_likelihood);
  const auto best = std::max_element(log_likelihood.begin(), log_likelihood.end());
  EXPECT_NEAR(cells.PositionOf(static_cast<int>(best - log_likelihood.begin())).x(), 20, 1.01);
  EXPECT_TRUE(MagneticEmission(SyntheticSite(29).site, cells, {}).empty());
}

// A lift ride on an unknown floor, the barometer of a phone that is metres off: the learnt error is
// the way back to the floors.
TEST(Dsff, FollowsALiftByItsBarometer) {
  TwoFloors house(31, 3);
  house.site.path.clear();
  for (int floor = 0; floor < 3; ++floor) {
    for (int s = 0; s < 40; ++s) {
      house.site.path.push_back({{0.5 * s, 10.0}, floor, static_cast<std::uint32_t>(floor)});
    }
  }
  Evidence evidence = house.Ride(TwoFloors::Stays({0, 2, 1}, 60, 10), 12.0);
  evidence.gyro_yaw_rad.push_back(evidence.begin_ns, 0.0);
  evidence.absolute_heading_rad = evidence.gyro_yaw_rad;
  evidence.absolute_heading_sigma_rad = {0.1};
  for (const char* name : {"dsff_hmm", "dsff_pressure", "dsff"}) {
    const EstimateResult result = Make(name).Estimate(house.site, evidence);
    ASSERT_EQ(result.status, EstimateStatus::kOk) << name;
    EXPECT_EQ(result.trajectory.At(TwoFloors::At(30)).floor, 0) << name;
    EXPECT_EQ(result.trajectory.At(TwoFloors::At(100)).floor, 2) << name;
    EXPECT_EQ(result.trajectory.At(TwoFloors::At(170)).floor, 1) << name;
  }
  evidence.barometric_height_m = {};
  EXPECT_EQ(Make("dsff").Estimate(house.site, evidence).status, EstimateStatus::kUnsupported);
}

TEST(Dsff, SurvivesAnHourWithoutScans) {
  SyntheticSite site(32, 6);
  Walk walk = MakeWalk(&site, {{6, 6}, {42, 6}, {42, 30}});
  const TimeNs later = DurationNs(3600);
  for (RadioReading& reading : walk.evidence.readings) {
    if (reading.heard_ns <= SyntheticSite::At(30)) continue;
    reading.heard_ns += later;
    reading.printed_ns += later;
  }
  walk.evidence.end_ns += later;
  const EstimateResult result = Make("dsff").Estimate(site.site, walk.evidence);
  EXPECT_EQ(result.status, EstimateStatus::kOk);
  EXPECT_GT(result.trajectory.poses.size(), 3600U);
}

}  // namespace
}  // namespace walkgraph
