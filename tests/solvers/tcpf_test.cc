#include "solvers/baselines/tcpf/tcpf.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "solvers/baselines/tcpf/trusted_points.h"
#include "solvers/synthetic_site.h"

namespace walkgraph {
namespace {

using Eigen::Vector2d;
using testing::SyntheticSite;

const std::vector<Vector2d> kWalk{{4, 4}, {40, 4}, {40, 30}, {10, 30}};

// The gyroscope knows the way without error; the compass is the walk's.
Evidence WalkWithGyroscope(SyntheticSite* world, std::vector<Vector2d>* truth = nullptr) {
  Evidence evidence = world->Walk(kWalk, 0.2, 2.0, truth);
  evidence.gyro_yaw_rad = SyntheticSite(1).Walk(kWalk, 0, 2.0).absolute_heading_rad;
  return evidence;
}

EstimateResult Solve(std::string_view name, const Site& site, const Evidence& evidence,
                     const TcpfSettings& settings = {}) {
  const auto* const method =
      std::find_if(std::begin(kTcpfMethods), std::end(kTcpfMethods),
                   [&](const TcpfMethod& m) { return m.description.name == name; });
  return TcpfEstimator(*method, settings, {}, {}, {}).Estimate(site, evidence);
}

double MeanError(const EstimateResult& result, const std::vector<Vector2d>& truth) {
  double sum = 0;
  for (std::size_t s = 0; s < truth.size(); ++s) {
    const PoseEstimate pose = result.trajectory.At(SyntheticSite::At(static_cast<double>(s)));
    sum += (pose.position_m.head<2>() - truth[s]).norm() / static_cast<double>(truth.size());
  }
  return sum;
}

// The paper's order. Its rival never leaves a wrong start: where the first fix is far off, all that
// it may search lies far off too ("error cycle").
TEST(Tcpf, FusionBeatsWifiAloneAndTheCrossAssistiveRival) {
  double wifi = 0, cross = 0, fused = 0;
  for (std::uint32_t seed = 1; seed <= 8; ++seed) {
    SyntheticSite world(seed);
    std::vector<Vector2d> truth;
    const Evidence evidence = WalkWithGyroscope(&world, &truth);
    wifi += MeanError(Solve("tcpf_wknn_thr_ap", world.site, evidence), truth);
    cross += MeanError(Solve("tcpf_cross_assistive", world.site, evidence), truth);
    fused += MeanError(Solve("tcpf", world.site, evidence), truth);
  }
  EXPECT_LT(fused, wifi);
  EXPECT_LT(fused, cross);
}

TEST(Tcpf, DeadReckoningKeepsTheErrorOfItsStart) {
  SyntheticSite world(2);
  std::vector<Vector2d> truth;
  const Evidence evidence = WalkWithGyroscope(&world, &truth);
  const EstimateResult result = Solve("tcpf_pdr", world.site, evidence);
  const Vector2d start_error = result.trajectory.poses.front().position_m.head<2>() - truth[0];
  for (std::size_t s = 0; s < truth.size(); ++s) {
    const PoseEstimate pose = result.trajectory.At(SyntheticSite::At(static_cast<double>(s)));
    EXPECT_NEAR((pose.position_m.head<2>() - truth[s] - start_error).norm(), 0, 3) << s;
  }
}

TEST(Tcpf, MarksTrustedPoints) {
  SyntheticSite world(2);
  const EstimateResult result = Solve("tcpf", world.site, WalkWithGyroscope(&world));
  ASSERT_FALSE(result.slow_states.empty());
  EXPECT_EQ(result.slow_states.front().value, 0);  // begins unlocked
  double trusted = 0;
  for (const SlowStateEstimate& state : result.slow_states) trusted += state.value;
  EXPECT_GT(trusted, 3);
  EXPECT_LT(trusted, static_cast<double>(result.slow_states.size()));
}

// A chain that never unlocks and an area that holds nothing: the first fix and dead reckoning.
TEST(Tcpf, WithoutCandidatesInTheAreaItReckons) {
  SyntheticSite world(2);
  const Evidence evidence = WalkWithGyroscope(&world);
  TcpfSettings settings;
  settings.distance_tolerance_m = -1;
  const EstimateResult fused = Solve("tcpf_cross_assistive", world.site, evidence, settings);
  const EstimateResult reckoned = Solve("tcpf_pdr", world.site, evidence, settings);
  const Vector2d offset =
      (fused.trajectory.poses.front().position_m - reckoned.trajectory.poses.front().position_m)
          .head<2>();
  const Vector2d end_offset =
      (fused.trajectory.poses.back().position_m - reckoned.trajectory.poses.back().position_m)
          .head<2>();
  EXPECT_NEAR((offset - end_offset).norm(), 0, 1e-9);
}

TEST(Tcpf, SaysWhatAWalkLacks) {
  SyntheticSite world(2);
  const Evidence whole = WalkWithGyroscope(&world);
  Evidence no_gyroscope = whole, no_compass = whole, no_accelerometer = whole;
  no_gyroscope.gyro_yaw_rad = {};
  no_compass.absolute_heading_rad = {};
  no_compass.absolute_heading_sigma_rad.clear();
  no_accelerometer.motion.clear();
  no_accelerometer.steps.clear();
  for (const TcpfMethod& method : kTcpfMethods) {
    const std::string_view name = method.description.name;
    const bool wifi_alone = name.find("wknn") != std::string_view::npos;
    EXPECT_EQ(Solve(name, world.site, whole).status, EstimateStatus::kOk) << name;
    for (const Evidence* lacking : {&no_gyroscope, &no_compass}) {
      const EstimateResult result = Solve(name, world.site, *lacking);
      EXPECT_EQ(result.status, wifi_alone ? EstimateStatus::kOk : EstimateStatus::kUnsupported)
          << name;
      EXPECT_EQ(result.messages.empty(), wifi_alone) << name;
    }
    EXPECT_EQ(Solve(name, world.site, no_accelerometer).status, EstimateStatus::kUnsupported);
  }
}

TEST(Tcpf, WithoutWifiItIsPlacedAtTheCentroid) {
  SyntheticSite world(2);
  Evidence evidence = WalkWithGyroscope(&world);
  evidence.readings.clear();
  for (const char* name : {"tcpf", "tcpf_cross_assistive", "tcpf_wknn_thr"}) {
    const EstimateResult result = Solve(name, world.site, evidence);
    EXPECT_EQ(result.status, EstimateStatus::kUnobservable) << name;
    EXPECT_FALSE(result.trajectory.empty()) << name;
  }
}

// A waypoint belongs to the position nearest to it in time.
TEST(Tcpf, WaypointsAtTrustedPointsAreFound) {
  EstimateResult result;
  const double unknown = std::nan("");
  for (const auto& [second, trusted] : {std::pair(0, 1.0), {10, 0.0}, {20, 1.0}}) {
    result.slow_states.push_back(
        {std::string(kTrustedState), second * kNsPerSecond, trusted, unknown});
    result.slow_states.push_back({"step_scale", second * kNsPerSecond, 1 - trusted, unknown});
  }
  std::vector<Waypoint> waypoints;
  for (const int second : {-3, 4, 6, 14, 16, 30}) {
    waypoints.push_back({second * kNsPerSecond, Vector2d::Zero(), 0});
  }
  const std::vector<bool> expected{true, true, false, false, true, true};
  EXPECT_EQ(TrustedAt(result, waypoints), expected);
  result.slow_states.clear();
  EXPECT_TRUE(TrustedAt(result, waypoints).empty());
}

TEST(Tcpf, BothFusionsMarkTheirPositions) {
  SyntheticSite world(2);
  const Evidence evidence = WalkWithGyroscope(&world);
  const std::vector<Waypoint> somewhere{{evidence.begin_ns, Vector2d::Zero(), 0}};
  for (const TcpfMethod& method : kTcpfMethods) {
    const std::string_view name = method.description.name;
    const bool fuses = name == "tcpf" || name == "tcpf_cross_assistive";
    EXPECT_EQ(TrustedAt(Solve(name, world.site, evidence), somewhere).empty(), !fuses) << name;
  }
}

}  // namespace
}  // namespace walkgraph
