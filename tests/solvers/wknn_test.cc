#include "solvers/baselines/wknn.h"

#include <gtest/gtest.h>

#include <cmath>
#include <map>
#include <vector>

#include "solvers/synthetic_site.h"

namespace walkgraph {
namespace {

using testing::SyntheticSite;

SurveyReading Reading(std::uint32_t transmitter, float rssi_dbm, float x_m, float age_s = 0) {
  SurveyReading reading;
  reading.transmitter = transmitter;
  reading.rssi_dbm = rssi_dbm;
  reading.age_s = age_s;
  reading.position_m = Eigen::Vector2f(x_m, 0);
  return reading;
}

// A site of four fingerprints of the access points a, b and c; one reading of c is 5 s old.
Site HandSite() {
  Site site;
  site.transmitters = {{Radio::kWifi, "a"}, {Radio::kWifi, "b"}, {Radio::kWifi, "c"}};
  const std::vector<std::vector<SurveyReading>> readings = {
      {Reading(0, -50, 0), Reading(1, -70, 0)},
      {Reading(0, -60, 10), Reading(1, -60, 10)},
      {Reading(1, -50, 20), Reading(2, -40, 20, 5)},
      {Reading(0, -52, 30), Reading(1, -70, 30)}};
  for (std::size_t i = 0; i < readings.size(); ++i) {
    site.scans.push_back({0, 0, 0, i < 3 ? 1 : 2, Radio::kWifi, readings[i]});
  }
  return site;
}

Evidence HandEvidence(float a_dbm, float b_dbm) {
  Evidence evidence;
  evidence.begin_ns = 0;
  evidence.end_ns = 4 * kNsPerSecond;
  evidence.transmitters = {{Radio::kWifi, "b"}, {Radio::kWifi, "a"}, {Radio::kWifi, "unknown"}};
  evidence.readings = {{kNsPerSecond, 3 * kNsPerSecond, 1, a_dbm},
                       {kNsPerSecond, 3 * kNsPerSecond, 2, -30},
                       {2 * kNsPerSecond, 3 * kNsPerSecond, 0, b_dbm}};
  return evidence;
}

TEST(Wknn, WeighsByInverseDistanceOverMissingSignals) {
  const Site site = HandSite();
  Evidence evidence = HandEvidence(-58, -62);
  evidence.floor = 1;
  const auto fixes = WknnFixes(site, evidence, WknnSettings());
  ASSERT_EQ(fixes.size(), 1U);
  // Distances by hand; the third fingerprint heard only b in time, so a is -100 dBm there.
  const double d[] = {std::hypot(8, 8), std::hypot(2, 2), std::hypot(42, 12)};
  const double weights = 1 / d[0] + 1 / d[1] + 1 / d[2];
  EXPECT_NEAR(fixes[0].position_m.x(), (10 / d[1] + 20 / d[2]) / weights, 1e-6);
  EXPECT_EQ(fixes[0].time_ns, 3 * kNsPerSecond / 2);
}

TEST(Wknn, ReturnsTheFingerprintThatItHears) {
  const Site site = HandSite();
  Evidence evidence = HandEvidence(-60, -60);
  evidence.floor = 1;
  EXPECT_NEAR(WknnFixes(site, evidence, WknnSettings())[0].position_m.x(), 10, 1e-3);
}

TEST(Wknn, WithoutAFloorTheNearestDecidesAmongEqualVotes) {
  const Site site = HandSite();
  WknnSettings two;
  two.k = 2;
  const auto on_second = WknnFixes(site, HandEvidence(-52, -70), two);
  EXPECT_EQ(on_second[0].floor, 2);
  EXPECT_NEAR(on_second[0].position_m.x(), 30, 1e-3);
  EXPECT_EQ(WalkFloor(site, HandEvidence(-50, -70), two), 1);
}

TEST(Wknn, SparseDistancesAreEuclidean) {
  SyntheticSite synthetic(5);
  const Fingerprints fingerprints(synthetic.site, 1, 3, -100);
  Evidence evidence = synthetic.Walk({{10, 10}, {40, 20}}, 0.1, 4);
  for (const QueryScan& scan : CollectQueryScans(synthetic.site, evidence, 3)) {
    const auto neighbours = fingerprints.Nearest(scan.signal, fingerprints.size());
    ASSERT_EQ(neighbours.size(), synthetic.site.scans.size());
    double previous = 0;
    for (const Neighbour& neighbour : neighbours) {
      std::map<std::uint32_t, double> difference;
      for (const auto& entry : scan.signal.entries) {
        difference[entry.transmitter] += entry.rssi_dbm + 100;
      }
      for (const SurveyReading& reading : synthetic.site.scans[neighbour.fingerprint].readings) {
        difference[reading.transmitter] -= reading.rssi_dbm + 100;
      }
      double squared = 0;
      for (const auto& [transmitter, value] : difference) squared += value * value;
      EXPECT_NEAR(neighbour.distance_db, std::sqrt(squared), 1e-4);
      EXPECT_GE(neighbour.distance_db, previous);
      previous = neighbour.distance_db;
    }
  }
}

TEST(Wknn, BeatsNearestNeighbourOnNoisyScans) {
  SyntheticSite synthetic(6);
  double error[2] = {0, 0};
  for (int walk = 0; walk < 10; ++walk) {
    std::vector<Eigen::Vector2d> truth;
    Evidence evidence = synthetic.Walk({{6, 6}, {40, 8}, {38, 30}, {8, 28}}, 0.1, 3, &truth);
    const auto nn = WknnEstimator::NearestNeighbour({}, {}).Estimate(synthetic.site, evidence);
    const auto wknn = WknnEstimator::Wknn({}, {}).Estimate(synthetic.site, evidence);
    for (std::size_t t = 0; t < truth.size(); ++t) {
      const TimeNs time = SyntheticSite::At(static_cast<double>(t));
      error[0] += (nn.trajectory.At(time).position_m.head<2>() - truth[t]).norm();
      error[1] += (wknn.trajectory.At(time).position_m.head<2>() - truth[t]).norm();
    }
  }
  EXPECT_LT(error[1], error[0]);
}

TEST(Wknn, InterpolatesBetweenScansAndClampsAtTheEnds) {
  SyntheticSite synthetic(7);
  Evidence evidence = synthetic.Walk({{6, 6}, {40, 8}}, 0.1, 5);
  const auto fixes = WknnFixes(synthetic.site, evidence, {});
  const Trajectory trajectory =
      WknnEstimator::Wknn({}, {}).Estimate(synthetic.site, evidence).trajectory;
  EXPECT_EQ(trajectory.poses.front().time_ns, evidence.begin_ns);
  EXPECT_EQ(trajectory.poses.back().time_ns, evidence.end_ns);
  const auto at = [&trajectory](TimeNs time) {
    return Eigen::Vector2d(trajectory.At(time).position_m.head<2>());
  };
  EXPECT_TRUE(at(evidence.begin_ns).isApprox(fixes.front().position_m));
  EXPECT_TRUE(at(evidence.end_ns).isApprox(fixes.back().position_m));
  const TimeNs middle = (fixes[1].time_ns - fixes[0].time_ns) / 2 + fixes[0].time_ns;
  EXPECT_TRUE(at(middle).isApprox((fixes[0].position_m + fixes[1].position_m) / 2));
  EXPECT_DOUBLE_EQ(trajectory.poses[3].position_m.z(), 4);
}

TEST(Wknn, PlacesAWalkWithoutWifiAtTheCentroidOfTheSurvey) {
  SyntheticSite synthetic(8);
  Evidence evidence = synthetic.Walk({{6, 6}, {20, 6}}, 0.1, 5);
  evidence.readings.clear();
  const EstimateResult result = WknnEstimator::Wknn({}, {}).Estimate(synthetic.site, evidence);
  EXPECT_EQ(result.status, EstimateStatus::kUnobservable);
  ASSERT_FALSE(result.messages.empty());
  ASSERT_EQ(result.trajectory.poses.size(), 15U);
  // The survey covers x = 1.5, 2.5 ... 47.5 and y = 1.5, 4.5 ... 34.5 evenly.
  const PoseEstimate& pose = result.trajectory.poses[7];
  EXPECT_NEAR(pose.position_m.x(), 24.5, 1e-9);
  EXPECT_NEAR(pose.position_m.y(), 18, 1e-9);
  EXPECT_NEAR(pose.covariance_xy_m2(0, 0), (47.0 * 47.0 - 1) / 12, 1e-6);
  EXPECT_NEAR(pose.covariance_xy_m2(1, 1), 9 * (12.0 * 12.0 - 1) / 12, 1e-6);
}

}  // namespace
}  // namespace walkgraph
