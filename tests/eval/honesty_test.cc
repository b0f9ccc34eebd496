#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <nlohmann/json.hpp>
#include <string>
#include <vector>

#include "data/simulator/random.h"
#include "eval/honesty/honesty_output.h"
#include "eval/honesty/honesty_scores.h"
#include "eval/honesty/matched_site.h"
#include "eval/honesty/matched_walk.h"
#include "eval/honesty/planned_inputs.h"
#include "eval/honesty/random_field.h"
#include "eval/run_program.h"
#include "graph/map_error_states.h"
#include "graph/statistics.h"
#include "graph/walk_graph.h"
#include "solvers/batch_smoother.h"
#include "solvers/window_smoother.h"

namespace walkgraph {
namespace {

using ::testing::HasSubstr;

Truth WaypointsEvery(double every_s, double duration_s) {
  Truth truth;
  for (double s = 0; s <= duration_s; s += every_s) {
    truth.waypoints.push_back({DurationNs(s), {s, 0}, 0});
  }
  return truth;
}

std::vector<double> Seconds(const Truth& truth) {
  std::vector<double> seconds;
  for (const Waypoint& w : truth.waypoints)
    seconds.push_back(std::round(SecondsBetween(0, w.time_ns)));
  return seconds;
}

TEST(ThinTruth, TakesTheNearestWaypointInTheMiddleOfEveryInterval) {
  EXPECT_THAT(Seconds(ThinTruth(WaypointsEvery(3, 72), 20)), testing::ElementsAre(9, 30, 51, 69));
  // Waypoints rarer than asked for are each taken once.
  EXPECT_THAT(Seconds(ThinTruth(WaypointsEvery(50, 150), 20)),
              testing::ElementsAre(0, 50, 100, 150));
  EXPECT_TRUE(ThinTruth(Truth(), 20).waypoints.empty());
}

WalkHonesty WalkOf(const std::vector<double>& nees) {
  WalkHonesty walk;
  walk.has_trajectory = true;
  for (const double value : nees) {
    WaypointError error;
    error.error_m = 2;
    error.nees = value;
    walk.errors.push_back(error);
  }
  return walk;
}

// The ellipses of the 2-D normal distribution end at 1.386, 5.991 and 13.816.
TEST(SummariseHonesty, CountsByHand) {
  WalkHonesty first = WalkOf({1, 3}), second = WalkOf({7, 20, 1});
  first.statistics = {{"step", 10, 2, 0.5, 0}};
  second.statistics = {{"step", 30, 2, 1.5, 0}};
  const HonestyRow row = SummariseHonesty("any", {first, second, WalkHonesty()});
  EXPECT_EQ(row.walks, 2);
  EXPECT_EQ(row.no_answer, 1);
  EXPECT_EQ(row.n, 5);
  EXPECT_NEAR(row.nees_per_dimension.mean, 32.0 / 5 / 2, 1e-12);
  EXPECT_NEAR(row.median_nees_per_dimension, 1.5, 1e-12);
  EXPECT_NEAR(row.coverage50.mean, 0.4, 1e-12);
  EXPECT_NEAR(row.coverage95.mean, 0.6, 1e-12);
  EXPECT_NEAR(row.beyond_999, 0.2, 1e-12);
  EXPECT_NEAR(row.statistics.at("step").MeanSquare(), 1.25, 1e-12);
  EXPECT_LE(row.coverage95.interval.low, 1.0 / 3 + 1e-12);
}

TEST(PlanInputs, StepsTouchAndDeadReckoningStaysNearItsStart) {
  Random random(5);
  const Evidence inputs = PlanInputs(300, &random);
  EXPECT_GE(SecondsBetween(inputs.begin_ns, inputs.end_ns), 300);
  Eigen::Vector2d position = Eigen::Vector2d::Zero();
  for (std::size_t i = 0; i < inputs.steps.size(); ++i) {
    const StepEvidence& step = inputs.steps[i];
    ASSERT_GE(step.begin_ns, i > 0 ? inputs.steps[i - 1].end_ns : inputs.begin_ns);
    const double heading = Interpolate(inputs.gyro_yaw_rad, step.end_ns);
    position += step.length_m * Eigen::Vector2d(std::cos(heading), std::sin(heading));
    ASSERT_LT(position.cwiseAbs().maxCoeff(), 25);
  }
  for (std::size_t i = 1; i < inputs.motion.size(); ++i) {
    EXPECT_EQ(inputs.motion[i].begin_ns, inputs.motion[i - 1].end_ns);
  }
}

// Over many fields: variance one, and the covariance that was asked for.
TEST(RandomField, HasItsCovariance) {
  constexpr double kLengthM = 8, kApartM = 6;
  double square = 0, smooth = 0, rough = 0;
  constexpr int kFields = 4000;
  for (int i = 0; i < kFields; ++i) {
    const auto a = RandomField::SquaredExponential(kLengthM, Random(7).Fork(2 * i));
    const auto b = RandomField::Exponential(kLengthM, Random(7).Fork(2 * i + 1));
    const Eigen::Vector2d from(3, -2), to = from + kApartM * Eigen::Vector2d(0.6, 0.8);
    square += b.At(from) * b.At(from) / kFields;
    smooth += a.At(from) * a.At(to) / kFields;
    rough += b.At(from) * b.At(to) / kFields;
  }
  EXPECT_NEAR(square, 1, 0.09);
  EXPECT_NEAR(smooth, std::exp(-0.5 * kApartM * kApartM / (kLengthM * kLengthM)), 0.08);
  EXPECT_NEAR(rough, std::exp(-kApartM / kLengthM), 0.08);
}

class Matched : public ::testing::Test {
 protected:
  MatchedWalk Walk(std::uint64_t number) const {
    return DrawMatchedWalk(site_, settings_.factors, 120, Random(3).Fork(number));
  }

  Settings settings_ = MatchedSettings();
  Site site_ = MakeMatchedSite(settings_.factors.map_error.sigma_m, Random(4));
};

TEST_F(Matched, EveryFactorFindsResidualsOfVarianceOneAtTheTrueStates) {
  StatisticsByType pooled;
  for (std::uint64_t i = 0; i < 40; ++i) {
    const MatchedWalk drawn = Walk(i);
    WalkGraph walk = BuildWalkGraph(site_, drawn.evidence, settings_.factors, 0);
    ASSERT_EQ(walk.graph.values().size(), drawn.values.size());
    walk.graph.SetValues(drawn.values);
    ConditionOnPlaces(&walk);
    for (const ResidualStatistics& s : ComputeStatistics(walk.graph)) {
      pooled[s.type].Add(s.count, s.dimension, s.mean_squared_whitened);
    }
  }
  for (const char* type : {"absolute_heading", "fingerprint", "heading_increment", "standing",
                           "step", "map_error_m_field", "gyro_bias_radps_prior",
                           "heading_offset_rad_random_walk", "position_prior"}) {
    ASSERT_TRUE(pooled.contains(type)) << type;
    const PooledStatistics& s = pooled.at(type);
    // Squares of n normal variables have the mean 1 with a sigma of sqrt(2 / n).
    const double sigma = std::sqrt(2.0 / (static_cast<double>(s.count) * s.dimension));
    EXPECT_NEAR(s.MeanSquare(), 1, 4 * sigma) << type;
  }
}

// Transmitters are heard as often as their fields say.
TEST_F(Matched, ScansHearWhatTheMapExpects) {
  double heard = 0, expected = 0, variance = 0;
  const RadioMap& map = site_.maps.front();
  settings_.factors.map_error.sigma_m = 1e-6;
  for (std::uint64_t i = 0; i < 20; ++i) {
    const MatchedWalk drawn = Walk(i);
    heard += static_cast<double>(drawn.evidence.readings.size());
    TimeNs last_ns = 0;
    for (const RadioReading& reading : drawn.evidence.readings) {
      if (reading.heard_ns == last_ns) continue;
      last_ns = reading.heard_ns;
      const auto& points = drawn.truth.waypoints;
      const auto after = std::upper_bound(
          points.begin(), points.end(), last_ns,
          [](TimeNs time_ns, const Waypoint& point) { return time_ns < point.time_ns; });
      const Waypoint &a = *(after - 1), &b = after == points.end() ? a : *after;
      const double span_s = SecondsBetween(a.time_ns, b.time_ns);
      const double share = span_s > 0 ? SecondsBetween(a.time_ns, last_ns) / span_s : 0;
      const FieldBasis basis =
          EvaluateBasis(map.grid, a.position + share * (b.position - a.position));
      for (std::size_t f = 0; f < map.fields.size(); ++f) {
        const double logit = map.EvaluateValue(static_cast<int>(f), basis).logit_hear;
        const double p = 1 / (1 + std::exp(-logit));
        expected += p;
        variance += p * (1 - p);
      }
    }
  }
  EXPECT_NEAR(heard, expected, 4 * std::sqrt(variance));
}

double BatchNees(const Site& site, const Settings& settings,
                 const std::vector<MatchedWalk>& walks) {
  const BatchSmoother smoother(settings.factors, settings.solver);
  std::vector<WalkHonesty> outcomes;
  for (const MatchedWalk& walk : walks) {
    const EstimateResult result = smoother.Estimate(site, walk.evidence);
    WalkHonesty outcome;
    outcome.has_trajectory = true;
    outcome.errors = ErrorsAtWaypoints(result.trajectory, ThinTruth(walk.truth, kScoredEveryS), 0);
    outcomes.push_back(outcome);
  }
  return SummariseHonesty("batch", outcomes).nees_per_dimension.mean;
}

TEST_F(Matched, TheBatchIsHonestAndAWrongModelShows) {
  std::vector<MatchedWalk> walks;
  for (std::uint64_t i = 0; i < 24; ++i) walks.push_back(Walk(i));
  const double honest = BatchNees(site_, settings_, walks);
  EXPECT_GT(honest, 0.7);
  EXPECT_LT(honest, 1.3);
  // Without the state for the error that scans at a place share, covariances are far too small.
  settings_.factors.map_error.mode = StateMode::kAbsent;
  EXPECT_GT(BatchNees(site_, settings_, walks), 2 * honest);
}

// Every reading of the model's own walks comes as it was expected, within what a mean of so many
// that share states can be off; a compass that is taken for twice as good as it is surprises.
TEST_F(Matched, TheWindowsInnovationsHaveVarianceOne) {
  WindowSettings window;
  window.innovations = true;
  const auto pooled = [&](const FactorSettings& factors, std::uint64_t walks) {
    StatisticsByType sums;
    const WindowSmoother smoother(factors, settings_.solver, window);
    for (std::uint64_t i = 0; i < walks; ++i) {
      for (const FactorStatistics& s : smoother.Estimate(site_, Walk(i).evidence).innovations) {
        sums[s.factor].Add(s.count, s.dimension, s.mean_squared_whitened);
      }
    }
    return sums;
  };
  const StatisticsByType honest = pooled(settings_.factors, 6);
  for (const char* type : {"absolute_heading", "fingerprint"}) {
    ASSERT_TRUE(honest.contains(type)) << type;
    EXPECT_GT(honest.at(type).count, 500) << type;
    EXPECT_NEAR(honest.at(type).MeanSquare(), 1, 0.15) << type;
  }
  EXPECT_FALSE(honest.contains("step"));  // a tie between times, no reading
  FactorSettings bold = settings_.factors;
  bold.absolute_heading.sigma_rad /= 2;
  EXPECT_GT(pooled(bold, 2).at("absolute_heading").MeanSquare(), 2);
  // Poses follow an error that scans share, and no reading surprises: that needs errors to see.
  FactorSettings blind = settings_.factors;
  blind.map_error.mode = StateMode::kAbsent;
  EXPECT_NEAR(pooled(blind, 2).at("fingerprint").MeanSquare(), 1, 0.15);
}

TEST_F(Matched, JudgingReadingsLeavesTheEstimateAsItWas) {
  const MatchedWalk walk = Walk(1);
  WindowSettings judging;
  judging.innovations = true;
  const auto estimate = [&](const WindowSettings& window) {
    return WindowSmoother(settings_.factors, settings_.solver, window)
        .Estimate(site_, walk.evidence);
  };
  const EstimateResult with = estimate(judging), without = estimate({});
  EXPECT_FALSE(with.innovations.empty());
  EXPECT_TRUE(without.innovations.empty());
  ASSERT_EQ(with.trajectory.poses.size(), without.trajectory.poses.size());
  for (std::size_t i = 0; i < with.trajectory.poses.size(); ++i) {
    EXPECT_EQ(with.trajectory.poses[i].position_m, without.trajectory.poses[i].position_m) << i;
  }
}

// Half a minute later and back within two metres: the error is the same, as far as a field is that
// fades over twenty.
TEST_F(Matched, WhoComesBackMeetsTheSameMapError) {
  double alike = 0, square = 0;
  for (std::uint64_t i = 0; i < 40; ++i) {
    const MatchedWalk drawn = Walk(i);
    WalkGraph walk = BuildWalkGraph(site_, drawn.evidence, settings_.factors, 0);
    walk.graph.SetValues(drawn.values);
    const MapErrorKnots& knots = walk.map_errors.front();
    const auto places = KnotPlaces(knots, walk, walk.node_ns.back());
    const auto error_m = [&](std::size_t k) {
      return Eigen::Map<const Eigen::Vector2d>(walk.graph.value(knots.state.blocks[k]));
    };
    for (std::size_t a = 0; a < places.size(); ++a) {
      for (std::size_t b = a + 6; b < places.size(); ++b) {
        if ((places[a].position_m - places[b].position_m).norm() > 2) continue;
        alike += error_m(a).dot(error_m(b));
        square += 0.5 * (error_m(a).squaredNorm() + error_m(b).squaredNorm());
      }
    }
  }
  ASSERT_GT(square, 0);
  EXPECT_GT(alike / square, 0.9);
}

std::string FreshFolder(const std::string& name) {
  const std::string path = ::testing::TempDir() + "honesty_" + name;
  std::filesystem::remove_all(path);
  return path;
}

TEST(HonestyVerb, TheSameSeedGivesTheSameNumbersWhateverTheWorkers) {
  const auto Run = [](const std::string& out, const std::string& seed, const std::string& workers) {
    const ProgramResult result =
        RunWalkgraph({"honesty", "--out=" + out, "--walks=3", "--duration_s=60", "--methods=batch",
                      "--seed=" + seed, "--workers=" + workers});
    EXPECT_EQ(result.exit_code, 0) << result.output;
    EXPECT_THAT(result.output, HasSubstr("NEES/dim"));
    return ReadText(out + "/honesty.csv") + ReadText(out + "/honesty.html");
  };
  const std::string first = Run(FreshFolder("a"), "1", "1");
  EXPECT_EQ(first, Run(FreshFolder("b"), "1", "2"));
  EXPECT_NE(first, Run(FreshFolder("c"), "2", "2"));
}

TEST(HonestyVerb, ScoresADataSet) {
  const std::string sample = std::string(WALKGRAPH_SOURCE_DIR) + "/data/samples/";
  const std::string out = FreshFolder("sample");
  const ProgramResult result =
      RunWalkgraph({"honesty", "--train=" + sample + "survey", "--test=" + sample + "test",
                    "--out=" + out, "--methods=batch"});
  ASSERT_EQ(result.exit_code, 0) << result.output;
  const auto json = nlohmann::json::parse(ReadText(out + "/honesty.json"));
  EXPECT_EQ(json.at("methods").at("batch").at("walks"), 4);
  EXPECT_TRUE(json.at("residuals_at_truth").empty());
  // Every figure stands in the page and in a file of its own, and says what it rests on.
  const std::string page = ReadText(out + "/honesty.html");
  for (const char* name : {"calibration", "nees", "nees_by_walk", "residuals"}) {
    const std::string svg = ReadText(out + "/figures/" + name + ".svg");
    EXPECT_THAT(svg, HasSubstr("4 walks")) << name;
    EXPECT_THAT(page, HasSubstr(svg)) << name;
  }
}

TEST(HonestyVerb, WantsBothDataSetsOrNeither) {
  const ProgramResult result = RunWalkgraph({"honesty", "--out=/nowhere", "--train=/nowhere"});
  EXPECT_EQ(result.exit_code, 2);
  EXPECT_THAT(result.output, HasSubstr("--test"));
}

}  // namespace
}  // namespace walkgraph
