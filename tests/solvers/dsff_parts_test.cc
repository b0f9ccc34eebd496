#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <random>
#include <vector>

#include "data/angle.h"
#include "frontends/evidence/barometric_formula.h"
#include "solvers/baselines/dsff/error_block.h"
#include "solvers/baselines/dsff/k_best.h"
#include "solvers/baselines/dsff/transition.h"
#include "solvers/baselines/walls.h"

namespace walkgraph {
namespace {

ErrorBlockSettings Block(double height, double sigma) {
  return {ErrorBlockMode::kBlock, height * sigma, 0.2};
}

TEST(ErrorBlock, StartsAsTheNormalCutAtTwoAndAHalfSigma) {
  const ErrorBlock block(3, {});
  EXPECT_NEAR(block.MassWithin(-7.5, -4.5), 0.06136, 5e-6);
  EXPECT_NEAR(block.MassWithin(-4.5, -1.5), 0.24477, 5e-6);
  EXPECT_NEAR(block.MassWithin(-1.5, 1.5), 0.38774, 5e-6);
  EXPECT_NEAR(block.MassWithin(1.5, 4.5), 0.24477, 5e-6);
  EXPECT_NEAR(block.MassWithin(-7.5, 7.5), 1, 1e-12);
  EXPECT_NEAR(block.Mean(), 0, 1e-12);
  // Convolved with the sensor's own variance of 9.
  EXPECT_NEAR(1 + block.Variance() / 9, 2.06375, 5e-6);
}

// Integral of the corrected density's moments, by the trapezoidal rule.
double Moment(const ErrorBlock& block, int power, double low, double high) {
  double sum = 0;
  constexpr double kStep = 0.02;
  for (double x = low; x <= high; x += kStep) {
    sum += kStep * std::pow(x, power) * std::exp(block.LogDensity(x));
  }
  return sum;
}

TEST(ErrorBlock, CorrectedDensityIsOneAndShiftsAgainstTheError) {
  ErrorBlock block(3, {});
  EXPECT_NEAR(Moment(block, 0, -60, 60), 1, 1e-9);
  EXPECT_NEAR(Moment(block, 2, -60, 60), 9 * 2.06375, 1e-3);
  for (int i = 0; i < 4; ++i) block.Add(30);
  EXPECT_NEAR(Moment(block, 0, -90, 60), 1, 1e-9);
  EXPECT_NEAR(Moment(block, 1, -90, 60), -block.Mean(), 1e-6);
}

// How many errors until 95 % of the mass is expected within 2.5 sigma of 30, of those errors of
// which `share` fall there; and that mass.
struct Learnt {
  int blocks = 0;
  double mass = 0;
};
Learnt BlocksUntilLearnt(const ErrorBlockSettings& settings, double share) {
  ErrorBlock block(3, settings);
  Learnt learnt;
  while (learnt.mass <= 0.95) {
    block.Add(30);
    ++learnt.blocks;
    learnt.mass = share * block.MassWithin(22.5, 37.5);
  }
  return learnt;
}

// Of errors N(b, s); a block there has the mass that a constant error's has.
const double kShareWithin = std::erf(2.5 / std::sqrt(2.0));

TEST(ErrorBlock, IsLearntAfterAsManyBlocksAsThePaperSays) {
  EXPECT_NEAR(kShareWithin, 0.98758, 5e-6);
  EXPECT_EQ(BlocksUntilLearnt(Block(0.1, 3), 1).blocks, 12);
  EXPECT_EQ(BlocksUntilLearnt(Block(0.1, 3), kShareWithin).blocks, 13);
  EXPECT_EQ(BlocksUntilLearnt(Block(0.2, 3), kShareWithin).blocks, 7);
  EXPECT_EQ(BlocksUntilLearnt(Block(0.3, 3), kShareWithin).blocks, 6);
  EXPECT_EQ(BlocksUntilLearnt(Block(0.5, 3), kShareWithin).blocks, 4);
  EXPECT_EQ(BlocksUntilLearnt(Block(1.0, 3), kShareWithin).blocks, 3);
  const Learnt aging = BlocksUntilLearnt({}, kShareWithin);
  EXPECT_EQ(aging.blocks, 15);
  EXPECT_NEAR(aging.mass, 0.95283, 5e-6);
}

// The mean mass about the bias over many walks with errors N(b, s) is 0.98758 (1 - (1 + h s)^-k).
TEST(ErrorBlock, MeanMassAboutABiasFollowsTheClosedForm) {
  const double bias = 30, sigma = 3;
  std::mt19937 random(5);
  std::normal_distribution<double> error(bias, sigma);
  for (const double height : {0.1, 0.3, 1.0}) {
    constexpr int kWalks = 4000, kBlocks = 8;
    double mass = 0;
    for (int walk = 0; walk < kWalks; ++walk) {
      ErrorBlock block(sigma, Block(height, sigma));
      for (int k = 0; k < kBlocks; ++k) block.Add(error(random));
      mass += block.MassWithin(bias - 2.5 * sigma, bias + 2.5 * sigma) / kWalks;
    }
    EXPECT_NEAR(mass, 0.98758 * (1 - std::pow(1 + height * sigma, -kBlocks)), 0.004) << height;
  }
}

TEST(ErrorBlock, MeanShiftOfAConstantErrorOfThirtyDegrees) {
  const auto shift = [](const ErrorBlockSettings& settings, int blocks) {
    ErrorBlock block(3, settings);
    for (int k = 0; k < blocks; ++k) block.Add(30);
    return -block.Mean();
  };
  EXPECT_NEAR(shift(Block(0.1, 3), 1), -6.923, 5e-4);
  EXPECT_NEAR(shift(Block(0.1, 3), 5), -21.920, 5e-4);
  EXPECT_NEAR(shift(Block(0.1, 3), 13), -29.009, 5e-4);
  EXPECT_NEAR(shift({}, 1), -6, 1e-9);
  EXPECT_NEAR(shift({}, 5), -20.170, 5e-4);
  EXPECT_NEAR(shift({}, 13), -28.351, 5e-4);
  // alpha = 0.2 is a block of h s = 0.25.
  EXPECT_NEAR(shift({ErrorBlockMode::kBlock, 0.25, 0}, 7), shift({}, 7), 1e-9);
}

// An outlier moves what is learnt by alpha times its effect and is forgotten as (1 - alpha)^k; one
// that persists is learnt as if it were a bias.
TEST(ErrorBlock, ForgetsAnOutlierAndLearnsAPersistentOne) {
  const double outlier = 24;
  ErrorBlock block(3, {});
  block.Add(0);
  const double before = block.Mean();
  block.Add(outlier);
  EXPECT_NEAR(block.Mean() - 0.8 * before, 0.2 * outlier, 1e-12);
  for (int k = 1; k <= 10; ++k) {
    block.Add(0);
    EXPECT_NEAR(block.Mean(), 0.2 * outlier * std::pow(0.8, k), 1e-9);
  }
  for (int k = 0; k < 20; ++k) block.Add(outlier);
  EXPECT_NEAR(block.Mean(), outlier, 0.02 * outlier);
}

TEST(ErrorBlock, FarDeviationsStayFinite) {
  const ErrorBlock block(0.1, {});
  EXPECT_TRUE(std::isfinite(block.LogDensity(1e4)));
  EXPECT_LT(block.LogDensity(1e4), block.LogDensity(0) - 500);
}

struct RandomModel {
  std::vector<std::vector<double>> emission;                 // [epoch][state], log
  std::vector<std::vector<std::vector<double>>> transition;  // [epoch][from][to], log
};

RandomModel MakeModel(std::uint32_t seed, std::size_t states, std::size_t epochs) {
  std::mt19937 random(seed);
  std::uniform_real_distribution<double> nats(-5, 0);
  RandomModel model;
  for (std::size_t e = 0; e < epochs; ++e) {
    model.emission.emplace_back();
    model.transition.emplace_back(states);
    for (std::size_t s = 0; s < states; ++s) {
      model.emission.back().push_back(nats(random));
      for (std::size_t t = 0; t < states; ++t) model.transition.back()[s].push_back(nats(random));
    }
  }
  return model;
}

std::vector<KBestViterbi::Trace> Solve(const RandomModel& model, int k) {
  const std::size_t states = model.emission[0].size();
  KBestViterbi viterbi(states, k, std::numeric_limits<double>::infinity());
  viterbi.Begin(model.emission[0]);
  for (std::size_t e = 1; e < model.emission.size(); ++e) {
    const auto transitions = [&](int from, const auto& relax) {
      for (std::size_t to = 0; to < states; ++to) {
        relax(static_cast<int>(to), model.transition[e][static_cast<std::size_t>(from)][to]);
      }
    };
    EXPECT_TRUE(viterbi.Advance(transitions, model.emission[e]));
  }
  return viterbi.Best();
}

// All 4^4 traces of a model, best first.
std::vector<KBestViterbi::Trace> BruteForce(const RandomModel& model) {
  std::vector<KBestViterbi::Trace> traces;
  for (int code = 0; code < 256; ++code) {
    KBestViterbi::Trace trace;
    for (std::size_t e = 0; e < 4; ++e) {
      const int state = (code >> (2 * e)) & 3;
      const auto s = static_cast<std::size_t>(state);
      trace.log_score += model.emission[e][s];
      if (e > 0) {
        trace.log_score += model.transition[e][static_cast<std::size_t>(trace.states.back())][s];
      }
      trace.states.push_back(state);
    }
    traces.push_back(trace);
  }
  std::sort(traces.begin(), traces.end(),
            [](const auto& a, const auto& b) { return a.log_score > b.log_score; });
  return traces;
}

TEST(KBestViterbi, EqualsBruteForceOnFourCellsAndEpochs) {
  for (std::uint32_t seed = 1; seed <= 20; ++seed) {
    const RandomModel model = MakeModel(seed, 4, 4);
    const auto all = BruteForce(model);
    for (const int k : {1, 3, 10}) {
      const auto best = Solve(model, k);
      ASSERT_EQ(best.size(), static_cast<std::size_t>(k));
      for (std::size_t i = 0; i < best.size(); ++i) {
        EXPECT_NEAR(best[i].log_score, all[i].log_score, 1e-12);
        EXPECT_EQ(best[i].states, all[i].states);
      }
    }
  }
}

TEST(KBestViterbi, SaysWhenNothingIsReached) {
  KBestViterbi viterbi(2, 2, 40);
  viterbi.Begin(std::vector<double>{0, -1});
  const auto nowhere = [](int /*from*/, const auto& /*relax*/) {};
  EXPECT_FALSE(viterbi.Advance(nowhere, std::vector<double>{0, 0}));
  viterbi.Restart(std::vector<double>{-3, -2});
  EXPECT_EQ(viterbi.LastStep().from, 0);
  EXPECT_EQ(viterbi.LastStep().to, 1);
  EXPECT_NEAR(viterbi.Best().front().log_score, -2, 1e-12);
}

RelativeSensors NoLearning() { return {{0.1, false, {}}, {0.2, false, {}}, {0.5, false, {}}}; }

TEST(DsffTransition, KernelPeaksWhereRingAndFanMeet) {
  DsffMotion motion;
  motion.distance_m = 5;
  motion.heading_rad = DegreesToRadians(90);
  motion.steps = 7;
  const TransitionKernel kernel = MakeKernel(motion, NoLearning(), 1, 12);
  const auto best = std::max_element(
      kernel.entries.begin(), kernel.entries.end(),
      [](const auto& a, const auto& b) { return a.log_probability < b.log_probability; });
  EXPECT_EQ(best->offset, (ReferencePoints::Cell{0, 5}));
  for (const TransitionKernel::Entry& entry : kernel.entries) {
    EXPECT_LE(std::hypot(entry.offset.column, entry.offset.row), 12);
  }
}

TEST(DsffTransition, LearntHeadingErrorTurnsTheFan) {
  RelativeSensors sensors{{0.1, true, {}}, {0.2, true, {}}, {0.5, true, {}}};
  DsffMotion motion;
  motion.distance_m = 5;
  motion.heading_rad = DegreesToRadians(60);  // 60 degrees too far: people go along x
  motion.steps = 7;
  for (int k = 0; k < 20; ++k) LearnFromTrace(motion, {5, 0}, std::nullopt, &sensors);
  const TransitionKernel kernel = MakeKernel(motion, sensors, 1, 12);
  const auto best = std::max_element(
      kernel.entries.begin(), kernel.entries.end(),
      [](const auto& a, const auto& b) { return a.log_probability < b.log_probability; });
  EXPECT_EQ(best->offset, (ReferencePoints::Cell{5, 0}));
}

TEST(DsffTransition, StandingTeachesNothing) {
  RelativeSensors sensors{{0.1, true, {}}, {0.2, true, {}}, {0.5, true, {}}};
  LearnFromTrace(DsffMotion(), {3, 0}, std::nullopt, &sensors);
  EXPECT_NEAR(sensors.distance.block()->Mean(), 0, 1e-15);
  EXPECT_NEAR(sensors.heading.block()->Mean(), 0, 1e-15);
}

TEST(Walls, BlockWhatCrossesThem) {
  std::mt19937 random(3);
  std::uniform_real_distribution<double> at(0, 30);
  const Polygon room{{10, 10}, {20, 10}, {20, 20}, {10, 20}};
  const std::vector<Polygon> rooms{room};
  const Walls walls(rooms);
  const auto inside = [](const Eigen::Vector2d& p) {
    return p.x() > 10 && p.x() < 20 && p.y() > 10 && p.y() < 20;
  };
  int crossings = 0;
  for (int i = 0; i < 2000; ++i) {
    const Eigen::Vector2d a(at(random), at(random)), b(at(random), at(random));
    // A segment with one end inside crosses; with sampled points on both sides too.
    bool crosses = inside(a) != inside(b);
    for (int s = 1; s < 400 && !crosses; ++s)
      crosses = inside(a + s / 400.0 * (b - a)) != inside(a);
    EXPECT_TRUE(!crosses || walls.Block(a, b));
    crossings += walls.Block(a, b) ? 1 : 0;
  }
  EXPECT_GT(crossings, 200);
  EXPECT_FALSE(walls.Block({1, 1}, {9, 29}));
  EXPECT_FALSE(walls.Block({11, 11}, {19, 19}));
  EXPECT_FALSE(Walls({}).Block({0, 0}, {1, 1}));
}

TEST(BarometricFormula, TwoPhonesHalfAHectopascalApartAreMoreThanAStoreyApart) {
  const double apart_m = HeightOfPressure(1013.25) - HeightOfPressure(1013.25 + 0.45);
  EXPECT_NEAR(apart_m, 3.75, 0.01);
  EXPECT_GT(apart_m, 3.08);  // the museum's levels
}

}  // namespace
}  // namespace walkgraph
