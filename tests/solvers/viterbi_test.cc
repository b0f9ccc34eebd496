#include "solvers/baselines/viterbi.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <numbers>
#include <vector>

#include "data/angle.h"
#include "solvers/synthetic_site.h"

namespace walkgraph {
namespace {

using ::walkgraph::testing::SyntheticSite;

const std::vector<Eigen::Vector2d> kWalk{{4, 4}, {40, 4}, {40, 30}, {10, 30}, {10, 12}};

double Mean(const std::vector<double>& values) {
  double sum = 0;
  for (const double value : values) sum += value;
  return sum / static_cast<double>(values.size());
}

// Distances from the truth at every second.
std::vector<double> Errors(const Trajectory& trajectory,
                           const std::vector<Eigen::Vector2d>& truth) {
  std::vector<double> errors;
  for (std::size_t s = 0; s < truth.size(); ++s) {
    const PoseEstimate pose = trajectory.At(SyntheticSite::At(static_cast<double>(s)));
    errors.push_back((pose.position_m.head<2>() - truth[s]).norm());
  }
  return errors;
}

// Replaces the absolute heading by the gyroscope's, which starts at `start_rad`.
void KeepGyroscopeOnly(double start_rad, Evidence* evidence) {
  evidence->gyro_yaw_rad = evidence->absolute_heading_rad;
  for (double& yaw : evidence->gyro_yaw_rad.value) yaw += start_rad;
  evidence->absolute_heading_rad = {};
  evidence->absolute_heading_sigma_rad.clear();
}

bool AllFinite(const Trajectory& trajectory) {
  return std::all_of(trajectory.poses.begin(), trajectory.poses.end(), [](const PoseEstimate& p) {
    return p.position_m.allFinite() && std::isfinite(p.heading_rad);
  });
}

TEST(ViterbiTest, FindsAKnownWalkWithinACellOrTwo) {
  SyntheticSite world(1);
  std::vector<Eigen::Vector2d> truth;
  const Evidence evidence = world.Walk(kWalk, 0.1, 2.0, &truth);
  const DiscreteSettings settings;
  const EstimateResult result = Viterbi({}, settings).Estimate(world.site, evidence);
  EXPECT_EQ(result.status, EstimateStatus::kOk);
  EXPECT_EQ(result.trajectory.poses.front().time_ns, evidence.begin_ns);
  EXPECT_EQ(result.trajectory.poses.back().time_ns, evidence.end_ns);
  const std::vector<double> errors = Errors(result.trajectory, truth);
  EXPECT_LT(Mean(errors), 1.5 * settings.spacing_m);
  EXPECT_LT(*std::max_element(errors.begin(), errors.end()), 5 * settings.spacing_m);
}

TEST(ViterbiTest, EqualInputGivesAnEqualWalk) {
  SyntheticSite world(2);
  const Evidence evidence = world.Walk(kWalk, 0.1, 2.0);
  const Viterbi viterbi({}, {});
  const EstimateResult a = viterbi.Estimate(world.site, evidence);
  const EstimateResult b = viterbi.Estimate(world.site, evidence);
  ASSERT_EQ(a.trajectory.poses.size(), b.trajectory.poses.size());
  for (std::size_t i = 0; i < a.trajectory.poses.size(); ++i) {
    EXPECT_EQ(a.trajectory.poses[i].position_m, b.trajectory.poses[i].position_m);
    EXPECT_EQ(a.trajectory.poses[i].heading_rad, b.trajectory.poses[i].heading_rad);
  }
}

// The gyroscope knows the shape of the walk but not its direction: bins all round the circle do.
// Starts on both sides of the seam between the last and the first bin among them.
TEST(ViterbiTest, FindsAWalkOfUnknownDirection) {
  for (const double start_rad : {0.02, -0.02, 1.0, 3.0, -2.0}) {
    SyntheticSite world(3);
    std::vector<Eigen::Vector2d> truth;
    Evidence evidence = world.Walk(kWalk, 0.05, 2.0, &truth);
    const Stream<double> heading = evidence.absolute_heading_rad;
    KeepGyroscopeOnly(start_rad, &evidence);
    const EstimateResult result = Viterbi({}, {}).Estimate(world.site, evidence);
    EXPECT_LT(Mean(Errors(result.trajectory, truth)), 3.0) << start_rad;
    for (const PoseEstimate& pose : result.trajectory.poses) {
      const double off = WrapAngle(pose.heading_rad - Interpolate(heading, pose.time_ns));
      EXPECT_LT(std::abs(off), 0.6) << start_rad;
    }
  }
}

// A gyroscope that drifts takes the offset from the last bins of the circle to the first.
TEST(ViterbiTest, OffsetMayDriftAcrossTheSeam) {
  SyntheticSite world(12);
  Evidence evidence = world.Walk(kWalk, 0.02, 2.0);
  const Stream<double> heading = evidence.absolute_heading_rad;
  KeepGyroscopeOnly(0.0, &evidence);
  for (std::size_t i = 0; i < evidence.gyro_yaw_rad.size(); ++i) {
    const double t = SecondsBetween(evidence.begin_ns, evidence.gyro_yaw_rad.time_ns[i]);
    evidence.gyro_yaw_rad.value[i] += 0.6 - 0.012 * t;
  }
  FactorSettings factors;
  factors.gyro_bias.prior_sigma_radps = 0.012;
  const DiscreteSettings settings;
  const DeadReckonedPath walk = DeadReckon(world.site, evidence, factors);
  const std::vector<DiscretePath> paths =
      SmoothOnLattice(world.site, evidence, walk, factors, settings, 1);
  ASSERT_FALSE(paths.empty());
  const std::vector<double>& offset = paths[0].heading_offset_rad.value;
  for (std::size_t k = 1; k < offset.size(); ++k) {
    EXPECT_LE(std::abs(offset[k] - offset[k - 1]), 1.01 * settings.heading_bin_rad);
  }
  EXPECT_NEAR(offset.back() - offset.front(), 0.012 * 98, 0.4);
  const EstimateResult result = Viterbi(factors, settings).Estimate(world.site, evidence);
  for (const PoseEstimate& pose : result.trajectory.poses) {
    const double off = WrapAngle(pose.heading_rad - Interpolate(heading, pose.time_ns));
    EXPECT_LT(std::abs(off), 0.6);
  }
}

// Turning the gyroscope's zero by whole bins renames the bins and changes nothing else.
TEST(ViterbiTest, ZeroOfTheGyroscopeDoesNotMatter) {
  SyntheticSite world(4);
  Evidence evidence = world.Walk(kWalk, 0.05, 2.0);
  KeepGyroscopeOnly(0.0, &evidence);
  const Viterbi viterbi({}, {});
  const EstimateResult before = viterbi.Estimate(world.site, evidence);
  const double bin_rad = 2 * std::numbers::pi / 63;
  for (double& yaw : evidence.gyro_yaw_rad.value) yaw += 17 * bin_rad;
  const EstimateResult after = viterbi.Estimate(world.site, evidence);
  ASSERT_EQ(before.trajectory.poses.size(), after.trajectory.poses.size());
  for (std::size_t i = 0; i < before.trajectory.poses.size(); ++i) {
    const PoseEstimate& a = before.trajectory.poses[i];
    const PoseEstimate& b = after.trajectory.poses[i];
    EXPECT_LT((a.position_m - b.position_m).norm(), 1e-6);
    EXPECT_NEAR(WrapAngle(a.heading_rad - b.heading_rad), 0.0, 1e-6);
  }
}

TEST(ViterbiTest, ManagesWithoutAnyHeading) {
  SyntheticSite world(5);
  std::vector<Eigen::Vector2d> truth;
  Evidence evidence = world.Walk(kWalk, 0.1, 2.0, &truth);
  evidence.absolute_heading_rad = {};
  evidence.absolute_heading_sigma_rad.clear();
  const EstimateResult result = Viterbi({}, {}).Estimate(world.site, evidence);
  EXPECT_EQ(result.status, EstimateStatus::kOk);
  EXPECT_TRUE(AllFinite(result.trajectory));
  EXPECT_LT(Mean(Errors(result.trajectory, truth)), 4.5);
}

// One scan of a dozen access points with 5 dB of noise and an unknown offset of the phone says
// little: the mean over many instants is what can be asked for. Guessing would give 20 m.
TEST(ViterbiTest, PlacesARecordingOfASingleInstant) {
  SyntheticSite world(6);
  std::vector<Eigen::Vector2d> truth;
  const Evidence walk = world.Walk(kWalk, 0.1, 2.0, &truth);
  std::vector<double> errors;
  for (std::size_t second = 3; second < truth.size(); second += 6) {
    Evidence evidence = walk;
    const TimeNs instant = SyntheticSite::At(static_cast<double>(second));
    std::erase_if(evidence.readings, [&](const RadioReading& r) { return r.heard_ns != instant; });
    evidence.steps.clear();
    evidence.absolute_heading_rad = {};
    evidence.begin_ns = evidence.end_ns = instant;
    const EstimateResult result = Viterbi({}, {}).Estimate(world.site, evidence);
    EXPECT_EQ(result.status, EstimateStatus::kOk);
    ASSERT_EQ(result.trajectory.poses.size(), 1U);
    errors.push_back((result.trajectory.poses[0].position_m.head<2>() - truth[second]).norm());
  }
  EXPECT_LT(Mean(errors), 9.0);
}

TEST(ViterbiTest, SurvivesAWalkThatLeavesTheLattice) {
  SyntheticSite world(7);
  // Out of the hall and 200 m away: no cell is left for the rest.
  const Evidence evidence = world.Walk({{20, 10}, {250, 10}}, 0.05, 2.0);
  const EstimateResult result = Viterbi({}, {}).Estimate(world.site, evidence);
  EXPECT_EQ(result.status, EstimateStatus::kOk);
  EXPECT_TRUE(AllFinite(result.trajectory));
  EXPECT_LT(
      (result.trajectory.At(SyntheticSite::At(4)).position_m.head<2>() - Eigen::Vector2d(24, 10))
          .norm(),
      10.0);
}

TEST(ViterbiTest, AnchorsAloneFixAWalk) {
  SyntheticSite world(8);
  std::vector<Eigen::Vector2d> truth;
  Evidence evidence = world.Walk(kWalk, 0.05, 2.0, &truth);
  evidence.readings.clear();
  evidence.anchors = {{SyntheticSite::At(13), truth[13], 1, 0.3},
                      {SyntheticSite::At(70), truth[70], 1, 0.3},
                      {SyntheticSite::At(20), {0, 0}, 2, 0.3}};  // of another floor
  const EstimateResult result = Viterbi({}, {}).Estimate(world.site, evidence);
  EXPECT_EQ(result.status, EstimateStatus::kOk);
  const std::vector<double> errors = Errors(result.trajectory, truth);
  EXPECT_LT(errors[13], 2.0);
  EXPECT_LT(errors[70], 2.0);
  EXPECT_LT(Mean(errors), 3.0);
}

TEST(ViterbiTest, WithoutAbsoluteEvidenceSaysSo) {
  SyntheticSite world(9);
  Evidence evidence = world.Walk(kWalk, 0.05, 2.0);
  Evidence strangers = evidence;
  for (Transmitter& transmitter : strangers.transmitters) transmitter.name += "_elsewhere";
  evidence.readings.clear();
  for (const Evidence* lost : {&evidence, &strangers}) {
    const EstimateResult result = Viterbi({}, {}).Estimate(world.site, *lost);
    EXPECT_EQ(result.status, EstimateStatus::kUnobservable);
    EXPECT_FALSE(result.messages.empty());
    EXPECT_TRUE(AllFinite(result.trajectory));
    // The shape of the walk is kept: 30 m along +x in the first 30 s.
    const Eigen::Vector3d moved = result.trajectory.At(SyntheticSite::At(30)).position_m -
                                  result.trajectory.At(SyntheticSite::At(0)).position_m;
    EXPECT_LT((moved - Eigen::Vector3d(30, 0, 0)).norm(), 2.0);
  }
}

TEST(ViterbiTest, WithoutARadioMapIsUnsupported) {
  SyntheticSite world(10);
  Evidence evidence = world.Walk(kWalk, 0.05, 2.0);
  evidence.floor.reset();
  EXPECT_EQ(Viterbi({}, {}).Estimate(Site(), evidence).status, EstimateStatus::kUnsupported);
}

TEST(ViterbiTest, ChoosesTheFloorThatExplainsTheReadings) {
  SyntheticSite world(11);
  Site site = world.site;
  RadioMap other = site.maps[0];
  other.floor = 2;
  for (std::size_t i = 0; i < other.fields.size(); ++i) {  // the same halls, other neighbours
    RadioMap::TransmitterField& field = other.fields[i];
    field = world.site.maps[0].fields[(i + 5) % other.fields.size()];
    field.transmitter = static_cast<std::uint32_t>(i);
  }
  site.maps.push_back(other);
  for (const SurveyPoint& point : world.site.path) {
    site.path.push_back({point.position_m, 2, point.walk});
  }
  Evidence evidence = world.Walk(kWalk, 0.1, 2.0);
  evidence.floor.reset();
  EXPECT_EQ(Viterbi({}, {}).Estimate(site, evidence).trajectory.poses.front().floor, 1);
}

}  // namespace
}  // namespace walkgraph
