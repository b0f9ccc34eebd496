#include "factors/magnetic.h"

#include <gtest/gtest.h>

#include <Eigen/Core>
#include <cmath>
#include <cstddef>
#include <numbers>
#include <random>
#include <vector>

#include "factors/radio_scenarios.h"

namespace walkgraph {
namespace {

using testing::RandomPlace;
using testing::Scenario;

// What the discrete smoother sums up is what the graph's rows cost where the map has no error.
TEST(MagneticGrid, IsTheCostOfTheFactor) {
  std::mt19937 random(4);
  const Scenario<MagneticFactor> scenario(&random);
  std::vector<Eigen::Vector2d> places;
  for (int i = 0; i < 20; ++i) places.push_back(RandomPlace(&random));
  const std::vector<float> nats = MagneticGrid(*scenario.map, places).Evaluate(scenario.look);
  const MagneticFactor factor(scenario.look);
  const Eigen::Vector2d no_error = Eigen::Vector2d::Zero();
  for (std::size_t i = 0; i < places.size(); ++i) {
    Eigen::Vector3d residual;
    const double* blocks[] = {places[i].data(), no_error.data()};
    ASSERT_TRUE(factor.Evaluate(blocks, residual.data(), nullptr));
    EXPECT_NEAR(nats[i], 0.5 * residual.squaredNorm() - factor.CostConstant(), 1e-3);
  }
}

// Ten seconds of a constant field at 50 Hz, the last four of them while the phone is handled.
Evidence TenSeconds() {
  Evidence evidence;
  evidence.begin_ns = 0;
  evidence.end_ns = DurationNs(10);
  for (int i = 0; i < 500; ++i) {
    evidence.magnetic.push_back(DurationNs(0.02 * i), {50, std::numbers::pi / 6});
  }
  evidence.motion = {{0, DurationNs(6), MotionState::kWalking},
                     {DurationNs(6), DurationNs(10), MotionState::kHandling}};
  return evidence;
}

TEST(CollectMagneticLooks, AreHalfSecondsThatCountForTheirShareOfTheCorrelationTime) {
  std::mt19937 random(4);
  Site site;
  site.magnetic_maps = {*Scenario<MagneticFactor>(&random).map};
  site.magnetic_maps[0].correlation_s = 4;
  MagneticLookSettings settings;
  EXPECT_TRUE(CollectMagneticLooks(site, TenSeconds(), settings, FloorPath(0)).empty());
  settings.enabled = true;
  const std::vector<MagneticLook> looks =
      CollectMagneticLooks(site, TenSeconds(), settings, FloorPath(0));
  ASSERT_EQ(looks.size(), 12U);  // of six seconds
  EXPECT_EQ(looks[0].time_ns, DurationNs(0.25));
  EXPECT_DOUBLE_EQ(looks[0].weight, 0.125);
  EXPECT_NEAR(looks[0].field_ut.x(), 50 * std::sqrt(3) / 2, 1e-9);
  EXPECT_NEAR(looks[0].field_ut.y(), 25, 1e-9);
  settings.correlation_s = 0.1;
  EXPECT_EQ(CollectMagneticLooks(site, TenSeconds(), settings, FloorPath(0))[0].weight, 1);
  EXPECT_TRUE(CollectMagneticLooks(site, TenSeconds(), settings, FloorPath(1)).empty());
}

}  // namespace
}  // namespace walkgraph
