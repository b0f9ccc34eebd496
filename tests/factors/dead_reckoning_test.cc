#include "factors/dead_reckoning.h"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

namespace walkgraph {
namespace {

constexpr TimeNs kStart = 1'560'000'000 * kNsPerSecond;

TimeNs At(double seconds) { return kStart + DurationNs(seconds); }

// Twenty steps of 0.7 m in ten seconds from t = 2 s, a quarter turn to the left half way. The
// absolute heading starts at `heading_rad`, the gyroscope at zero.
Evidence TurningWalk(double heading_rad) {
  Evidence evidence;
  evidence.begin_ns = kStart;
  evidence.end_ns = At(15);
  for (int i = 0; i < 20; ++i) {
    evidence.steps.push_back({At(2 + 0.5 * i), At(2.5 + 0.5 * i), 0.7});
  }
  for (int i = 0; i <= 150; ++i) {
    const double turned = i < 70 ? 0.0 : std::numbers::pi / 2;
    evidence.absolute_heading_rad.push_back(At(0.1 * i), heading_rad + turned);
    evidence.absolute_heading_sigma_rad.push_back(0.1);
    evidence.gyro_yaw_rad.push_back(At(0.1 * i), turned);
  }
  return evidence;
}

void ExpectNear(const Eigen::Vector2d& a, const Eigen::Vector2d& b) {
  EXPECT_LT((a - b).norm(), 1e-6) << a.transpose() << " instead of " << b.transpose();
}

TEST(DeadReckonTest, AddsStepsInTheDirectionOfTheHeading) {
  const DeadReckonedPath path = DeadReckon(Site(), TurningWalk(0), FactorSettings());
  EXPECT_EQ(path.source, HeadingSource::kAbsolute);
  ExpectNear(path.PositionAt(At(1)), {0, 0});
  ExpectNear(path.PositionAt(At(7)), {7, 0});
  ExpectNear(path.PositionAt(At(7.25)), {7, 0.35});
  ExpectNear(path.PositionAt(At(12)), {7, 7});
  EXPECT_EQ(path.position_m.time_ns.front(), kStart);
  EXPECT_EQ(path.position_m.time_ns.back(), At(15));
}

TEST(DeadReckonTest, ClampsOutsideTheRecording) {
  const DeadReckonedPath path = DeadReckon(Site(), TurningWalk(0), FactorSettings());
  ExpectNear(path.PositionAt(At(-100)), {0, 0});
  ExpectNear(path.PositionAt(At(100)), {7, 7});
  EXPECT_EQ(path.HeadingAt(At(-100)), 0.0);
}

// The building's axes, the mean offset and the step scale are one similarity transform of the path.
TEST(DeadReckonTest, TurnsWithBuildingAndOffsetAndScalesWithSteps) {
  const DeadReckonedPath plain = DeadReckon(Site(), TurningWalk(0.4), FactorSettings());
  Site site;
  site.building.origin = GeoReference{41, 2, 0.9};
  FactorSettings settings;
  settings.heading_offset.prior_mean_rad = -0.3;
  settings.step_scale.prior_mean = 1.25;
  const DeadReckonedPath path = DeadReckon(site, TurningWalk(0.4), settings);
  const double turn = -0.9 - 0.3;
  for (const double t : {3.0, 6.6, 9.1, 15.0}) {
    const Eigen::Vector2d at = plain.PositionAt(At(t));
    ExpectNear(path.PositionAt(At(t)),
               1.25 * Eigen::Vector2d(std::cos(turn) * at.x() - std::sin(turn) * at.y(),
                                      std::sin(turn) * at.x() + std::cos(turn) * at.y()));
    EXPECT_NEAR(path.HeadingAt(At(t)), plain.HeadingAt(At(t)) + turn, 1e-12);
  }
}

TEST(DeadReckonTest, AbsentStatesAreNotApplied) {
  FactorSettings settings;
  settings.heading_offset = {StateMode::kAbsent, 0.5};
  settings.step_scale = {StateMode::kAbsent, 2.0};
  ExpectNear(DeadReckon(Site(), TurningWalk(0), settings).PositionAt(At(12)), {7, 7});
}

TEST(DeadReckonTest, FallsBackToTheGyroscopeAndThenStraightAhead) {
  FactorSettings settings;
  settings.absolute_heading.enabled = false;
  DeadReckonedPath path = DeadReckon(Site(), TurningWalk(1.1), settings);
  EXPECT_EQ(path.source, HeadingSource::kGyroscope);
  ExpectNear(path.PositionAt(At(12)), {7, 7});  // from an unknown start of zero
  settings.heading_increment.enabled = false;
  path = DeadReckon(Site(), TurningWalk(1.1), settings);
  EXPECT_EQ(path.source, HeadingSource::kNone);
  ExpectNear(path.PositionAt(At(12)), {14, 0});
  settings.step.enabled = false;
  ExpectNear(DeadReckon(Site(), TurningWalk(0), settings).PositionAt(At(12)), {0, 0});
}

TEST(DeadReckonTest, ASingleInstantStaysAtTheOrigin) {
  Evidence evidence;
  evidence.begin_ns = evidence.end_ns = kStart;
  const DeadReckonedPath path = DeadReckon(Site(), evidence, FactorSettings());
  ASSERT_EQ(path.position_m.size(), 1U);
  ExpectNear(path.PositionAt(kStart), {0, 0});
  EXPECT_EQ(path.HeadingAt(kStart), 0.0);
}

// A step that began before the recording or ends after it must not break the order of time.
TEST(DeadReckonTest, StepsOverTheEdgesKeepTheOrder) {
  Evidence evidence;
  evidence.begin_ns = kStart;
  evidence.end_ns = At(1);
  evidence.steps = {{At(-0.2), At(0.3), 0.7}, {At(0.3), At(0.9), 0.7}, {At(0.9), At(1.4), 0.7}};
  const DeadReckonedPath path = DeadReckon(Site(), evidence, FactorSettings());
  for (std::size_t i = 1; i < path.position_m.size(); ++i) {
    EXPECT_GT(path.position_m.time_ns[i], path.position_m.time_ns[i - 1]);
  }
  ExpectNear(path.PositionAt(At(2)), {2.1, 0});
}

}  // namespace
}  // namespace walkgraph
