#include "eval/calibrate/calibrate_motion.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <deque>
#include <numbers>
#include <random>
#include <string>
#include <vector>

#include "data/angle.h"
#include "eval/calibrate/leg_comparison.h"
#include "eval/config_keys.h"

namespace walkgraph {
namespace {

constexpr TimeNs kStart = 1'560'000'000 * kNsPerSecond;
constexpr double kStepS = 0.55;
constexpr double kModelLengthM = 0.7;

// How the simulated walks deviate from dead reckoning.
struct Gait {
  int walks = 200;
  int legs = 8;
  double scale_mean = 1.1, scale_sigma = 0.05;
  double offset_mean_rad = 0.3, offset_sigma_rad = 0.1;
  double along_m = 0.12, across_m = 0.10;  // of a step
  double waypoint_m = 0.3;                 // per axis
  double bias_sigma_radps = 0;
  double bias_walk = 0;            // rad/s per sqrt(s)
  double turn_rad_per_sqrt_s = 0;  // of the walking direction against the gyroscope
  double heading_error_rad = 0;    // of the absolute heading, anew every two seconds
  bool compass = true;
  int slips = 0;  // whole turns by which the unwrapped heading is off in the end
};

// Walks of straight legs between waypoints, of 8 to 40 steps each.
class Simulation {
 public:
  explicit Simulation(const Gait& gait, std::uint32_t seed = 1) : gait_(gait), random_(seed) {
    for (int i = 0; i < gait.walks; ++i) AddWalk();
  }

  std::vector<CalibrationWalk> walks() const {
    std::vector<CalibrationWalk> walks;
    for (std::size_t i = 0; i < evidence_.size(); ++i) {
      walks.push_back({&evidence_[i], &truth_[i]});
    }
    return walks;
  }

 private:
  double Normal(double sigma) { return sigma * normal_(random_); }

  void AddWaypoint(double seconds, const Eigen::Vector2d& at) {
    const double dx = Normal(gait_.waypoint_m), dy = Normal(gait_.waypoint_m);
    truth_.back().waypoints.push_back(
        {kStart + DurationNs(seconds), at + Eigen::Vector2d(dx, dy), 0});
  }

  void AddWalk() {
    Evidence& evidence = evidence_.emplace_back();
    truth_.emplace_back();
    const double scale = gait_.scale_mean + Normal(gait_.scale_sigma);
    const double offset = gait_.offset_mean_rad + Normal(gait_.offset_sigma_rad);
    double bias = Normal(gait_.bias_sigma_radps);
    Eigen::Vector2d position(0, 0);
    double t = 0, turned = 0, drifted = 0, heading_error = 0;
    int since_error = 0;
    AddWaypoint(t, position);
    for (int leg = 0; leg < gait_.legs; ++leg) {
      const double direction = std::uniform_real_distribution<double>(0, 6)(random_);
      const int steps = std::uniform_int_distribution<int>(8, 40)(random_);
      for (int i = 0; i < steps; ++i) {
        const double along = scale * kModelLengthM + Normal(gait_.along_m);
        const double across = Normal(gait_.across_m);
        const Eigen::Vector2d ahead(std::cos(direction), std::sin(direction));
        position += along * ahead + across * Eigen::Vector2d(-ahead.y(), ahead.x());
        const TimeNs begin = kStart + DurationNs(t), end = kStart + DurationNs(t + kStepS);
        evidence.steps.push_back({begin, end, kModelLengthM});
        if (since_error++ % 4 == 0) heading_error = Normal(gait_.heading_error_rad);
        turned += Normal(gait_.turn_rad_per_sqrt_s * std::sqrt(kStepS));
        if (gait_.bias_walk > 0) bias += Normal(gait_.bias_walk * std::sqrt(kStepS));
        drifted += bias * kStepS;
        const TimeNs middle = begin + (end - begin) / 2;
        evidence.gyro_yaw_rad.push_back(middle, direction + turned + 1.0 + drifted);
        if (gait_.compass) {
          const double slipped = 2 * std::numbers::pi * (leg * gait_.slips / gait_.legs);
          evidence.absolute_heading_rad.push_back(middle,
                                                  direction - offset + heading_error + slipped);
          evidence.absolute_heading_sigma_rad.push_back(0.1);
        }
        t += kStepS;
      }
      AddWaypoint(t, position);
    }
    evidence.begin_ns = kStart;
    evidence.end_ns = kStart + DurationNs(t);
  }

  Gait gait_;
  std::mt19937 random_;
  std::normal_distribution<double> normal_;
  std::deque<Evidence> evidence_;
  std::deque<Truth> truth_;
};

FactorSettings Calibrate(const Gait& gait) {
  const Simulation simulation(gait);
  FactorSettings settings;
  CalibrateMotion({}, simulation.walks(), &settings);
  return settings;
}

// A walk's mean over its eight legs errs by 0.02 (step noise 0.12 m sqrt(24), waypoints 0.3 m
// sqrt(2), on 18 m, over sqrt(8)); over 200 walks that and the spread leave 0.004.
TEST(CalibrateMotionTest, RecoversMeansOfScaleAndOffset) {
  const FactorSettings settings = Calibrate({});
  EXPECT_NEAR(settings.step_scale.prior_mean, 1.1, 0.015);
  EXPECT_NEAR(settings.heading_offset.prior_mean_rad, 0.3, 0.03);
}

// A sigma from 200 walks errs by 5 %.
TEST(CalibrateMotionTest, RecoversSpreadsOverWalks) {
  const FactorSettings settings = Calibrate({});
  EXPECT_NEAR(settings.step_scale.prior_sigma, 0.05, 0.012);
  EXPECT_NEAR(settings.heading_offset.prior_sigma_rad, 0.1, 0.02);
}

Gait ShortWalks() {
  Gait gait;
  gait.walks = 500;
  gait.legs = 3;
  return gait;
}

// On walks of three legs the mean scale errs by as much as people differ: without reckoning with
// it the spread would come to 0.05.
TEST(CalibrateMotionTest, ErrorsOfShortWalksAreNoSpreadOfScales) {
  Gait gait = ShortWalks();
  gait.scale_sigma = 0.03;
  gait.waypoint_m = 0.5;
  EXPECT_NEAR(Calibrate(gait).step_scale.prior_sigma, 0.03, 0.008);
  gait.scale_sigma = 0;
  EXPECT_LT(Calibrate(gait).step_scale.prior_sigma, 0.025);
}

TEST(CalibrateMotionTest, ErrorsOfTheCompassAreNoSpreadOfOffsets) {
  Gait gait = ShortWalks();
  gait.offset_sigma_rad = 0.05;
  gait.heading_error_rad = 0.25;
  EXPECT_NEAR(Calibrate(gait).heading_offset.prior_sigma_rad, 0.05, 0.012);
}

// The slope of 1600 squared errors (mean 0.5 m^2) over steps (8 to 40) errs by 0.0018 m^2.
TEST(CalibrateMotionTest, TellsTheErrorOfStepsFromThatOfWaypoints) {
  const FactorSettings settings = Calibrate({});
  EXPECT_NEAR(settings.step.sigma_along_m, 0.12, 0.025);
  EXPECT_NEAR(settings.step.sigma_across_m, 0.10, 0.03);
  Gait exact, sloppy;
  exact.waypoint_m = 0.05;
  sloppy.waypoint_m = 0.45;
  EXPECT_NEAR(Calibrate(exact).step.sigma_along_m, 0.12, 0.02);
  EXPECT_NEAR(Calibrate(sloppy).step.sigma_along_m, 0.12, 0.05);
  Gait swaying;
  swaying.along_m = 0.25;
  EXPECT_NEAR(Calibrate(swaying).step.sigma_along_m, 0.25, 0.05);
}

// Neighbouring legs share a waypoint and its error, which the model has not: the rate comes out up
// to a quarter low.
TEST(CalibrateMotionTest, RecoversTheWanderingOfDirection) {
  Gait gait;
  gait.turn_rad_per_sqrt_s = 0.04;
  const double found = Calibrate(gait).heading_increment.sigma_rad_per_sqrt_s;
  EXPECT_GT(found, 0.04 * 0.75);
  EXPECT_LT(found, 0.04 * 1.15);
}

// A bias has a state of its own: it is no noise of the increments, whether it turns a walk by a
// tenth of a radian or by several.
TEST(CalibrateMotionTest, TheGyroscopesBiasIsNoNoiseOfTurns) {
  Gait gait;
  gait.turn_rad_per_sqrt_s = 0.04;
  for (const double bias : {0.003, 0.02, 0.05}) {
    gait.bias_sigma_radps = bias;
    const double found = Calibrate(gait).heading_increment.sigma_rad_per_sqrt_s;
    EXPECT_GT(found, 0.04 * 0.75) << bias;
    EXPECT_LT(found, 0.04 * 1.15) << bias;
  }
}

// Walks of nearly five minutes. The steps' own errors turn legs by a tenth of a radian, so does the
// bias in a minute.
TEST(CalibrateMotionTest, ABiasThatWandersIsToldFromTurns) {
  Gait gait;
  gait.legs = 20;
  gait.turn_rad_per_sqrt_s = 0.03;
  gait.bias_walk = 5e-4;
  const FactorSettings wandering = Calibrate(gait);
  EXPECT_NEAR(wandering.gyro_bias.walk_radps_per_sqrt_s, 5e-4, 1e-4);
  EXPECT_NEAR(wandering.heading_increment.sigma_rad_per_sqrt_s, 0.03, 0.012);
  // Without one either a small rate is found, or that the walks cannot tell.
  gait.bias_walk = 0;
  const double found = Calibrate(gait).gyro_bias.walk_radps_per_sqrt_s;
  EXPECT_TRUE(found < 3e-4 || found == FactorSettings().gyro_bias.walk_radps_per_sqrt_s) << found;
}

TEST(CalibrateMotionTest, WalksOfHalfAMinuteSayNothingOfABiasThatWanders) {
  Gait gait;
  gait.legs = 3;
  gait.walks = 60;
  const FactorSettings defaults;
  EXPECT_EQ(Calibrate(gait).gyro_bias.walk_radps_per_sqrt_s,
            defaults.gyro_bias.walk_radps_per_sqrt_s);
}

// Three legs of differing lengths leave one direction without a line: its closed form.
TEST(DifferencesWithoutDrift, LosesALineAndKeepsTheRest) {
  WalkLegs legs(3);
  const double seconds[] = {0, 4, 10};
  for (std::size_t i = 0; i < 3; ++i) {
    legs[i].middle_ns = kStart + DurationNs(seconds[i]);
    legs[i].heading_rad = WrapAngle(0.7 + 0.4 * seconds[i]);  // turns round twice a minute
  }
  for (const double d : DifferencesWithoutDrift({legs}, &Leg::heading_rad).difference) {
    EXPECT_NEAR(d, 0, 1e-9);
  }
  legs[1].heading_rad = WrapAngle(legs[1].heading_rad + 0.3);
  // What is left lies along n = (6, -10, 4), the normal of lines at these times, |n|^2 = 152.
  const auto found = DifferencesWithoutDrift({legs}, &Leg::heading_rad);
  ASSERT_EQ(found.difference.size(), 3U);
  const double left = 0.3 * -10 / 152;
  EXPECT_NEAR(found.difference[0], left * -16, 1e-9);
  EXPECT_NEAR(found.difference[1], left * -2, 1e-9);
  EXPECT_NEAR(found.difference[2], left * 14, 1e-9);
  EXPECT_NEAR(found.noise[0], 16.0 * 16 / 152, 1e-9);
  // A random walk at 4 and 10 s: n' K n = 100 * 4 + 16 * 10 - 2 * 40 * 4 = 240.
  EXPECT_NEAR(found.wander[2], 14.0 * 14 * 240 / (152.0 * 152), 1e-9);
  // Its integral has 4^3 / 3, 10^3 / 3 and, between the two, 4^2 (30 - 4) / 6.
  const double integral = 100 * 64.0 / 3 + 16 * 1000.0 / 3 - 2 * 40 * 16 * 26.0 / 6;
  EXPECT_NEAR(found.bias[2], 14.0 * 14 * integral / (152.0 * 152), 1e-9);
  EXPECT_EQ(found.long_walks, 0U);
}

TEST(CalibrateMotionTest, RecoversTheAbsoluteHeadingsOwnError) {
  Gait gait;
  gait.heading_error_rad = 0.25;
  EXPECT_NEAR(Calibrate(gait).absolute_heading.sigma_rad, 0.25, 0.07);
}

TEST(CalibrateMotionTest, RecoversTheGyroscopeBias) {
  Gait gait;
  gait.bias_sigma_radps = 0.01;
  EXPECT_NEAR(Calibrate(gait).gyro_bias.prior_sigma_radps, 0.01, 0.0015);
}

// A gyroscope that drifts turns the later legs of a walk by a third of a radian: that is no
// sideways step.
TEST(CalibrateMotionTest, TheGyroscopesDriftIsNoErrorOfSteps) {
  Gait gait;
  gait.bias_sigma_radps = 0.003;
  gait.turn_rad_per_sqrt_s = 0.02;
  EXPECT_NEAR(Calibrate(gait).step.sigma_across_m, 0.10, 0.04);
}

// A phone held upright turns its heading round by the wrong way now and then: whole turns that its
// unwrapped heading keeps, and no drift.
TEST(CalibrateMotionTest, WholeTurnsOfTheHeadingAreNoDrift) {
  Gait gait;
  gait.bias_sigma_radps = 0.01;
  gait.slips = 3;
  EXPECT_NEAR(Calibrate(gait).gyro_bias.prior_sigma_radps, 0.01, 0.0015);
}

TEST(CalibrateMotionTest, NothingWanderingGivesTheSmallestRates) {
  Gait gait;
  gait.along_m = gait.across_m = gait.waypoint_m = 1e-4;
  const FactorSettings settings = Calibrate(gait);
  EXPECT_LT(settings.heading_increment.sigma_rad_per_sqrt_s, 0.011);
  EXPECT_LT(settings.heading_offset.walk_rad_per_sqrt_s, 0.0031);
  EXPECT_LT(settings.step_scale.walk_per_sqrt_s, 0.0021);
  EXPECT_GT(settings.step.sigma_along_m, 0.0);
  EXPECT_GT(settings.gyro_bias.prior_sigma_radps, 0.0);
}

// A phone held backwards: offsets on both sides of pi are near each other.
TEST(CalibrateMotionTest, OffsetsLieOnACircle) {
  Gait gait;
  gait.offset_mean_rad = std::numbers::pi;
  const FactorSettings settings = Calibrate(gait);
  EXPECT_NEAR(WrapAngle(settings.heading_offset.prior_mean_rad - std::numbers::pi), 0, 0.03);
  EXPECT_NEAR(settings.heading_offset.prior_sigma_rad, 0.1, 0.02);
}

// Calibrating again from where the first calibration arrived changes nothing.
TEST(CalibrateMotionTest, DoesNotDependOnTheSettingsBefore) {
  const Simulation simulation({});
  FactorSettings once, twice;
  CalibrateMotion({}, simulation.walks(), &once);
  twice = once;
  CalibrateMotion({}, simulation.walks(), &twice);
  EXPECT_EQ(once.step_scale.prior_mean, twice.step_scale.prior_mean);
  EXPECT_EQ(once.heading_offset.prior_mean_rad, twice.heading_offset.prior_mean_rad);
  EXPECT_EQ(once.step.sigma_along_m, twice.step.sigma_along_m);
  EXPECT_EQ(once.absolute_heading.sigma_rad, twice.absolute_heading.sigma_rad);
}

// A building turned against north turns the headings, not the offset.
TEST(CalibrateMotionTest, TurningTheBuildingAddsItsAngle) {
  const Simulation simulation({});
  Building building;
  building.origin = GeoReference{41, 2, 0.7};
  FactorSettings settings;
  CalibrateMotion(building, simulation.walks(), &settings);
  EXPECT_NEAR(settings.heading_offset.prior_mean_rad, 0.3 + 0.7, 0.03);
}

TEST(CalibrateMotionTest, FewerThanTenSamplesKeepTheDefaults) {
  Gait few;
  few.walks = 9;
  few.legs = 1;
  const Simulation simulation(few);
  FactorSettings settings;
  EXPECT_TRUE(CalibrateMotion({}, simulation.walks(), &settings).empty());
  const FactorSettings defaults;
  EXPECT_EQ(settings.step_scale.prior_mean, defaults.step_scale.prior_mean);
  EXPECT_EQ(settings.step.sigma_along_m, defaults.step.sigma_along_m);
  EXPECT_EQ(settings.heading_offset.prior_sigma_rad, defaults.heading_offset.prior_sigma_rad);
  EXPECT_TRUE(CalibrateMotion({}, {}, &settings).empty());
}

TEST(CalibrateMotionTest, WithoutACompassOnlyStepsAndTurnsAreSet) {
  Gait gait;
  gait.compass = false;
  const Simulation simulation(gait);
  FactorSettings settings;
  const auto values = CalibrateMotion({}, simulation.walks(), &settings);
  EXPECT_NEAR(settings.step_scale.prior_mean, 1.1, 0.015);
  EXPECT_NEAR(settings.step.sigma_along_m, 0.12, 0.025);
  for (const CalibratedValue& value : values) {
    EXPECT_EQ(value.key.find("heading_offset"), std::string::npos);
    EXPECT_EQ(value.key.find("absolute_heading"), std::string::npos);
  }
}

TEST(CalibrateMotionTest, ReportsWhatItSetUnderTheKeysOfTheConfiguration) {
  const Simulation simulation({});
  Settings settings;
  const auto values = CalibrateMotion({}, simulation.walks(), &settings.factors);
  EXPECT_GE(values.size(), 9U);
  const std::vector<ConfigKey> keys = ConfigKeys(&settings);
  for (const CalibratedValue& value : values) {
    const auto key = std::find_if(keys.begin(), keys.end(),
                                  [&](const ConfigKey& k) { return k.name == value.key; });
    ASSERT_NE(key, keys.end()) << value.key;
    EXPECT_EQ(*std::get<double*>(key->target), value.value) << value.key;
    EXPECT_GE(value.samples, 10U) << value.key;
  }
}

// Walks without legs, steps or evidence of any kind are passed over.
TEST(CalibrateMotionTest, EmptyWalksChangeNothing) {
  const Simulation simulation({});
  std::vector<CalibrationWalk> walks = simulation.walks();
  FactorSettings before, after;
  CalibrateMotion({}, walks, &before);
  const Evidence nothing;
  const Truth nowhere;
  walks.push_back({&nothing, &nowhere});
  walks.push_back({&nothing, walks[0].truth});
  walks.push_back({walks[0].evidence, &nowhere});
  CalibrateMotion({}, walks, &after);
  EXPECT_EQ(before.step.sigma_along_m, after.step.sigma_along_m);
  EXPECT_EQ(before.step_scale.prior_mean, after.step_scale.prior_mean);
}

}  // namespace
}  // namespace walkgraph
