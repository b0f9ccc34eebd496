#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <numbers>
#include <vector>

#include "data/angle.h"
#include "factors/refresh_rate.h"
#include "solvers/baselines/tcpf/heading_filter.h"
#include "solvers/baselines/tcpf/step_error.h"
#include "solvers/baselines/tcpf/trust_chain.h"
#include "solvers/baselines/tcpf/wifi.h"
#include "solvers/turning_walk.h"

namespace walkgraph {
namespace {

using Eigen::Vector2d;
using testing::TurningWalk;

TEST(RefreshRate, IsThePapersFit) {
  const RefreshRate eta;
  EXPECT_NEAR(eta.Percent(-60), 84.63, 0.005);
  EXPECT_NEAR(eta.Percent(-75), 43.49, 0.005);
  EXPECT_NEAR(eta.Percent(-85), 2.53, 0.005);
  EXPECT_NEAR(eta.Percent(-75.0075), 43.40885, 5e-6);
  EXPECT_NEAR(eta.Slope(-75.0075), 11.169, 0.0005);
  EXPECT_NEAR(eta.Slope(-78), (eta.Percent(-77.999) - eta.Percent(-78.001)) / 0.002, 1e-6);
  EXPECT_NEAR(eta.Weight(0), 1, 1e-12);
}

TEST(StepError, HasTheValuesOfItsIntegral) {
  const double sigma = DegreesToRadians(8.5916);
  EXPECT_NEAR(ExpectedStepError(0.75, {0, sigma}), 0.089565, 5e-7);
  EXPECT_NEAR(ExpectedStepError(0.75, {DegreesToRadians(-1.5086), sigma}), 0.090937, 5e-7);
}

TEST(StepError, TheFittedNormalPromisesMoreThanWasMeasured) {
  const HeadingError fitted{DegreesToRadians(-1.5086), DegreesToRadians(8.5916)};
  const double limits_deg[] = {20, 15, 10};
  const double promised[] = {0.9782, 0.9145, 0.7483}, measured[] = {0.9400, 0.8776, 0.7113};
  for (int i = 0; i < 3; ++i) {
    const double within = ProbabilityWithin(DegreesToRadians(limits_deg[i]), fitted);
    EXPECT_NEAR(within, promised[i], 5e-5);
    EXPECT_GT(within, measured[i] + 0.03);
  }
}

TEST(TrustedArea, IsTheAnnularSector) {
  const TrustedArea area{{1, 1}, {10, 0}, 2, DegreesToRadians(45)};
  EXPECT_TRUE(area.Contains({12.9, 1}));
  EXPECT_FALSE(area.Contains({13.1, 1}));
  EXPECT_FALSE(area.Contains({8.9, 1}));
  const auto at = [](double degrees) {
    return Vector2d(1 + 10 * std::cos(DegreesToRadians(degrees)),
                    1 + 10 * std::sin(DegreesToRadians(degrees)));
  };
  EXPECT_TRUE(area.Contains(at(44.9)));
  EXPECT_FALSE(area.Contains(at(-45.1)));
  // Across +-180 degrees, and without a direction.
  const TrustedArea west{{0, 0}, {-10, 0.1}, 2, DegreesToRadians(45)};
  EXPECT_TRUE(west.Contains({-10, -0.1}));
  const TrustedArea standing{{0, 0}, {0, 0}, 2, DegreesToRadians(45)};
  EXPECT_TRUE(standing.Contains({0, -1.9}));
  EXPECT_FALSE(standing.Contains({0, -2.1}));
}

TEST(TrustChain, UnlocksAtTheFourthUntrustedFix) {
  const double alpha = 0.089675 / 0.75 / 2.68;
  EXPECT_NEAR(alpha, 0.044614, 5e-7);
  TrustChain chain(alpha, 1, TrustState::kTrustedLocked, 0);
  const double expected[] = {0.1625, 0.3978, 0.8317, 1.9228};
  for (int k = 0; k < 4; ++k) {
    chain.Move(60.6 / 19);
    chain.Settle(false);
    EXPECT_NEAR(chain.lambda(), expected[k], 1e-4);
    EXPECT_EQ(chain.state(), k < 3 ? TrustState::kLocked : TrustState::kUnlocked);
  }
  for (int k = 0; k < 100; ++k) chain.Settle(false);
  EXPECT_NEAR((chain.Fuse({0, 0}, {3, 4}) - Vector2d(3, 4)).norm(), 0, 1e-12);
  chain.Settle(true);
  EXPECT_EQ(chain.lambda(), 0);
  EXPECT_EQ(chain.state(), TrustState::kTrustedLocked);
  EXPECT_EQ(chain.Fuse({1, 2}, {30, 40}), Vector2d(1, 2));
}

TEST(TrustChain, WeighsWithLambdaAgainstOne) {
  TrustChain chain(0.5, 1, TrustState::kLocked, 0);
  chain.Move(4);  // lambda = 2
  EXPECT_NEAR((chain.Fuse({0, 3}, {3, 0}) - Vector2d(2, 1)).norm(), 0, 1e-12);
}

TEST(HeadingFilter, FollowsATurnThatBothSensorsSee) {
  const TurningWalk walk;
  const FilteredHeading filtered =
      FilterHeading(walk.evidence.gyro_yaw_rad, walk.evidence.absolute_heading_rad, {});
  ASSERT_FALSE(filtered.heading_rad.empty());
  for (std::size_t i = 0; i < filtered.heading_rad.time_ns.size(); ++i) {
    const double s = SecondsBetween(TurningWalk::At(0), filtered.heading_rad.time_ns[i]);
    EXPECT_NEAR(filtered.heading_rad.value[i], walk.Heading(s), 0.05) << s;
    EXPECT_LE(filtered.sigma_rad[i], 0.3 + 1e-12);
  }
}

TEST(HeadingFilter, TheGyroscopeSmoothsTheCompass) {
  Stream<double> yaw, compass;
  double square_sum = 0;
  for (int i = 0; i <= 1200; ++i) {
    const double error = 0.3 * std::sin(2.1 * i) + 0.3 * std::cos(0.9 * i * i);
    yaw.push_back(TurningWalk::At(0.05 * i), 0.2 * 0.05 * i);
    compass.push_back(TurningWalk::At(0.05 * i), 0.2 * 0.05 * i + error);
    square_sum += error * error / 1201;
  }
  const FilteredHeading filtered = FilterHeading(yaw, compass, {});
  double filtered_sum = 0;
  for (std::size_t i = 200; i < filtered.heading_rad.time_ns.size(); ++i) {
    const double error = filtered.heading_rad.value[i] - yaw.value[i];
    filtered_sum += error * error / static_cast<double>(filtered.heading_rad.time_ns.size() - 200);
  }
  EXPECT_LT(std::sqrt(filtered_sum), 0.3 * std::sqrt(square_sum));
}

TEST(HeadingFilter, WrapsTheInnovation) {
  Stream<double> yaw, compass;
  for (int i = 0; i <= 200; ++i) {
    yaw.push_back(TurningWalk::At(0.05 * i), 0);
    // The same direction, given a full turn further on in the second half.
    compass.push_back(TurningWalk::At(0.05 * i), 1 + (i > 100 ? 2 * std::numbers::pi : 0));
  }
  const FilteredHeading filtered = FilterHeading(yaw, compass, {});
  for (const double heading : filtered.heading_rad.value) EXPECT_NEAR(heading, 1, 1e-9);
}

// Access points 0 and 1 on the left, 2 and 3 on the right; 4 is weak everywhere.
Site TwoSides() {
  Site site;
  for (const char* name : {"a", "b", "c", "d", "e"}) {
    site.transmitters.push_back({Radio::kWifi, name});
  }
  const std::vector<std::vector<float>> rssi = {{-50, -60, -90, -90, -88},
                                                {-52, -58, -90, -90, -99},
                                                {-90, -90, -50, -60, -80},
                                                {-62, -90, -51, -58, -80}};
  for (std::size_t i = 0; i < rssi.size(); ++i) {
    SurveyScan scan{0, 0, 0, 1, Radio::kWifi, {}};
    for (std::size_t j = 0; j < rssi[i].size(); ++j) {
      const Eigen::Vector2f at(10.0F * static_cast<float>(i), 0);
      scan.readings.push_back({static_cast<std::uint32_t>(j), rssi[i][j], 0, at});
    }
    site.scans.push_back(scan);
  }
  return site;
}

TEST(TcpfWifi, WithoutThresholdItIsWknn) {
  const Site site = TwoSides();
  const SignalVector scan{{{0, -55}, {1, -61}, {4, -95}}};
  const TcpfWifi wifi(site, 1, {-100, -100}, {}, false);
  const Fingerprints fingerprints(site, 1, 3, -100);
  const Vector2d expected = WknnFix(fingerprints, fingerprints.Nearest(scan, 5)).position_m;
  EXPECT_NEAR((wifi.Find(scan, true).Mean() - expected).norm(), 0, 1e-9);
}

TEST(TcpfWifi, WeakSignalsCountOnlyWhileStanding) {
  const Site site = TwoSides();
  const TcpfWifi wifi(site, 1, {-85, -75}, {}, false);
  const SignalVector weak{{{4, -80}}};
  EXPECT_TRUE(wifi.Find(weak, true).empty());
  EXPECT_FALSE(wifi.Find(weak, false).empty());
  const SignalVector with{{{2, -50}, {3, -60}, {4, -76}}}, without{{{2, -50}, {3, -60}}};
  EXPECT_EQ(wifi.Find(with, true).Mean(), wifi.Find(without, true).Mean());
}

TEST(TcpfWifi, MatchesTheStrongestAmongTheTwoStrongest) {
  const Site site = TwoSides();
  const TcpfWifi matching(site, 1, {-85, -75}, {}, true);
  const SignalVector left{{{0, -50}, {2, -60}}};
  for (const Neighbour& n : matching.Find(left, true).nearest) EXPECT_LE(n.fingerprint, 1U);
  EXPECT_EQ(matching.Find(left, true).nearest.size(), 2U);
  // e is strongest nowhere: no filter.
  EXPECT_EQ(matching.Find({{{4, -60}}}, true).nearest.size(), 4U);
}

TEST(TcpfWifi, SearchesOnlyWhereItMay) {
  const Site site = TwoSides();
  const TcpfWifi wifi(site, 1, {-85, -75}, {}, false);
  const auto found = wifi.Find({{{0, -50}}}, true, [](const Vector2d& at) { return at.x() > 15; });
  EXPECT_EQ(found.nearest.size(), 2U);
  EXPECT_GT(found.Mean().x(), 15);
}

// Against the sum written out: every access point at the stronger of its two signals.
TEST(Fingerprints, RefreshWeightsAreThoseOfTheSum) {
  const Site site = TwoSides();
  const Fingerprints fingerprints(site, 1, 3, -100);
  const float query[] = {-70, -100, -79, -100, -76};
  SignalVector scan{{{0, query[0]}, {2, query[2]}, {4, query[4]}}};
  const RefreshRate eta;
  const auto nearest = fingerprints.Nearest(scan, 4, {true, {}});
  ASSERT_EQ(nearest.size(), 4U);
  for (const Neighbour& n : nearest) {
    double sum = 0;
    for (std::size_t j = 0; j < 5; ++j) {
      const double f = site.scans[n.fingerprint].readings[j].rssi_dbm, q = query[j];
      sum += eta.Weight(std::max(f, q)) * (f - q) * (f - q);
    }
    EXPECT_NEAR(n.distance_db, std::sqrt(sum), 1e-6);
  }
}

}  // namespace
}  // namespace walkgraph
