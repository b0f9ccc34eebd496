#include <gtest/gtest.h>

#include <cmath>
#include <numbers>
#include <set>
#include <utility>
#include <vector>

#include "data/simulator/office_plan.h"
#include "data/simulator/radio.h"
#include "data/simulator/random.h"
#include "data/simulator/scenarios.h"
#include "data/simulator/simulation.h"

namespace walkgraph {
namespace {

TEST(Random, NormalHasItsMoments) {
  Random random(11);
  constexpr int kCount = 200000;
  double sum = 0;
  double squares = 0;
  double fourth = 0;
  for (int i = 0; i < kCount; ++i) {
    const double x = random.Normal();
    sum += x;
    squares += x * x;
    fourth += x * x * x * x;
  }
  EXPECT_NEAR(sum / kCount, 0.0, 0.01);
  EXPECT_NEAR(squares / kCount, 1.0, 0.015);
  EXPECT_NEAR(fourth / kCount, 3.0, 0.12);
}

TEST(Random, ForksDifferFromEachOther) {
  const Random random(1);
  Random a = random.Fork(0);
  Random b = random.Fork(1);
  Random again = random.Fork(0);
  const double first = a.Uniform();
  EXPECT_NE(first, b.Uniform());
  EXPECT_EQ(first, again.Uniform());
}

// Over many fields: variance one, and correlation exp(-d / length) at one length and at three.
TEST(ShadowField, HasTheCorrelationItPromises) {
  Random random(5);
  constexpr int kFields = 4000;
  constexpr double kLengthM = 6.0;
  double variance = 0;
  double near = 0;
  double far = 0;
  for (int i = 0; i < kFields; ++i) {
    const ShadowField field = ShadowField::Planar(kLengthM, &random);
    const double here = field.At({3.0, 4.0, 0.0});
    variance += here * here;
    near += here * field.At({3.0 + kLengthM, 4.0, 0.0});
    far += here * field.At({3.0, 4.0 - 3.0 * kLengthM, 0.0});
  }
  EXPECT_NEAR(variance / kFields, 1.0, 0.07);
  EXPECT_NEAR(near / kFields, std::exp(-1.0), 0.06);
  EXPECT_NEAR(far / kFields, std::exp(-3.0), 0.06);
}

TEST(ShadowField, IsAsCorrelatedUpwardsAsSideways) {
  Random random(6);
  constexpr int kFields = 4000;
  constexpr double kLengthM = 6.0;
  double variance = 0;
  double above = 0;
  double aside = 0;
  for (int i = 0; i < kFields; ++i) {
    const ShadowField field = ShadowField::Spatial(kLengthM, &random);
    const double here = field.At({3.0, 4.0, 1.0});
    variance += here * here;
    above += here * field.At({3.0, 4.0, 1.0 + kLengthM});
    aside += here * field.At({3.0, 4.0 + kLengthM, 1.0});
  }
  EXPECT_NEAR(variance / kFields, 1.0, 0.07);
  EXPECT_NEAR(above / kFields, std::exp(-1.0), 0.06);
  EXPECT_NEAR(aside / kFields, std::exp(-1.0), 0.06);
}

SimulationSettings Unshadowed() {
  SimulationSettings settings = CleanSettings();
  settings.propagation.shadow_sigma_db = 0;
  settings.propagation.reading_sigma_db = 0;
  return settings;
}

Plan FourFloors() {
  Random random(1);
  BuildingSettings building;
  building.floors = 4;
  return MakeOffice(building, GaitSettings{}, &random);
}

Sender SenderAt(const Eigen::Vector3d& position_m, int floor) {
  Random random(2);
  return {.name = "02:00:5e:00:00:01",
          .position_m = position_m,
          .floor = floor,
          .power_at_1m_dbm = -40.0,
          .phase = 0.5,
          .shadow = ShadowField::Spatial(6.0, &random)};
}

TEST(Propagation, IsFreeSpaceAlongACorridor) {
  const Plan plan = FourFloors();
  const PropagationSettings settings = Unshadowed().propagation;
  const Sender sender = SenderAt({4.2, 6.2, 1.2}, 0);  // as high as the phone
  for (const double distance_m : {1.0, 10.0, 30.0}) {
    EXPECT_NEAR(MeanRssiDbm(plan, sender, {4.2 + distance_m, 6.2}, 0.0, settings),
                -40.0 - 20.0 * std::log10(distance_m), 1e-9);
  }
  // Nothing is nearer than a metre.
  EXPECT_NEAR(MeanRssiDbm(plan, sender, {4.3, 6.2}, 0.0, settings), -40.0, 1e-9);
}

TEST(Propagation, WallsTakeTheirShareUpToALimit) {
  const Plan plan = FourFloors();
  PropagationSettings settings = Unshadowed().propagation;
  const Sender sender = SenderAt({4.2, 6.2, 1.2}, 0);
  const Eigen::Vector2d room(4.2, 3.0);  // behind one wall
  ASSERT_EQ(CountWallsBetween(plan, 0, room, {4.2, 6.2}), 1);
  const double with = MeanRssiDbm(plan, sender, room, 0.0, settings);
  settings.wall_loss_db = 0;
  const double without = MeanRssiDbm(plan, sender, room, 0.0, settings);
  EXPECT_NEAR(without - with, 3.4, 1e-9);
  settings.wall_loss_db = 3.4;
  settings.most_walls = 0;
  EXPECT_NEAR(MeanRssiDbm(plan, sender, room, 0.0, settings), without, 1e-9);
}

// COST 231, section 4.7.2: 18.3 n^((n + 2)/(n + 1) - 0.46).
TEST(Propagation, FloorsTakeWhatCost231Says) {
  const PropagationSettings settings;
  EXPECT_EQ(FloorLossDb(settings, 0), 0.0);
  EXPECT_NEAR(FloorLossDb(settings, 1), 18.3, 1e-12);
  EXPECT_NEAR(FloorLossDb(settings, 2), 18.3 * std::pow(2.0, 4.0 / 3.0 - 0.46), 1e-12);
  const Plan plan = FourFloors();
  const Sender sender = SenderAt({4.2, 6.2, 1.2}, 0);
  const double below = MeanRssiDbm(plan, sender, {14.2, 6.2}, 0.0, Unshadowed().propagation);
  const double above = MeanRssiDbm(plan, sender, {14.2, 6.2}, 3.5, Unshadowed().propagation);
  EXPECT_NEAR(below - above, 18.3 + 20.0 * std::log10(std::hypot(10.0, 3.5) / 10.0), 1e-9);
}

// TCPF: eta(-60) = 84.63, eta(-75) = 43.49, eta(-85) = 2.53 percent.
TEST(Reception, RefreshesAtTcpfsRate) {
  const WifiSettings settings;
  EXPECT_NEAR(100.0 * RefreshShare(settings, -60), 84.63, 0.005);
  EXPECT_NEAR(100.0 * RefreshShare(settings, -75), 43.49, 0.005);
  EXPECT_NEAR(100.0 * RefreshShare(settings, -85), 2.53, 0.005);
}

std::vector<WalkState> StandingAt(const Eigen::Vector2d& position_m, double duration_s) {
  std::vector<WalkState> states;
  for (TimeNs time_ns = 0; time_ns < DurationNs(duration_s); time_ns += 20 * kNsPerMs) {
    WalkState& state = states.emplace_back();
    state.time_ns = time_ns;
    state.position_m = position_m;
  }
  return states;
}

TEST(Reception, HearsAStrongAccessPointAtTheRefreshRate) {
  const Plan plan = FourFloors();
  SimulationSettings settings = Unshadowed();
  const std::vector<Sender> senders = {SenderAt({14.2, 6.2, 1.2}, 0)};  // -60 dBm
  Random random(3);
  Recording recording;
  SimulateWifi(plan, senders, StandingAt({4.2, 6.2}, 3600), settings, &random, &recording);
  std::set<TimeNs> heard;
  std::set<TimeNs> printed;
  for (const RadioRow& row : recording.radio_rows) {
    EXPECT_EQ(row.rssi_dbm, -60.0F);
    heard.insert(row.heard_ns);
    printed.insert(row.printed_ns);
  }
  const double sweeps = 3600.0 / 2.45;
  EXPECT_NEAR(static_cast<double>(heard.size()) / sweeps, 0.8463, 0.03);
  EXPECT_NEAR(static_cast<double>(printed.size()) / sweeps, 1.0, 0.02);  // from memory
}

TEST(Reception, LatencyStampsReadingsEarlierAndChangesNothingElse) {
  const Plan plan = FourFloors();
  SimulationSettings settings = Unshadowed();
  settings.wifi.keep_s = 1000;
  const std::vector<Sender> senders = {SenderAt({14.2, 6.2, 1.2}, 0)};
  const auto rows = [&](double latency_s) {
    settings.wifi.latency_s = latency_s;
    Random random(4);
    Recording recording;
    SimulateWifi(plan, senders, StandingAt({4.2, 6.2}, 120), settings, &random, &recording);
    return recording.radio_rows;
  };
  const std::vector<RadioRow> at_once = rows(0.0);
  const std::vector<RadioRow> late = rows(0.8);
  ASSERT_EQ(at_once.size(), late.size());
  for (std::size_t i = 0; i < late.size(); ++i) {
    EXPECT_EQ(late[i].printed_ns, at_once[i].printed_ns);
    EXPECT_EQ(at_once[i].heard_ns - late[i].heard_ns, 800 * kNsPerMs);
  }
}

TEST(Reception, BodiesShadowWhatLiesBehind) {
  const Plan plan = FourFloors();
  SimulationSettings settings = Unshadowed();
  settings.propagation.body_loss_db = 6.0;
  const Sender sender = SenderAt({14.2, 6.2, 1.2}, 0);
  Random random(5);
  WalkState state;
  state.position_m = {4.2, 6.2};
  const double facing = DrawRssiDbm(plan, sender, state, settings.propagation, &random);
  state.heading_rad = std::numbers::pi;
  const double turned = DrawRssiDbm(plan, sender, state, settings.propagation, &random);
  EXPECT_NEAR(facing - turned, 6.0, 1e-9);
}

TEST(Reception, RepeatsRowsAsOftenAsRecordedWalks) {
  SimulationSettings settings;
  settings.walks.handling_s = 0;
  const Simulation simulation(settings, 9);
  std::int64_t rows = 0;
  std::int64_t repeats = 0;
  for (int index = 0; index < 8; ++index) {
    const Recording recording = simulation.MakeWalk(index).recording;
    std::set<std::pair<std::uint32_t, TimeNs>> seen;
    for (const RadioRow& row : recording.radio_rows) {
      if (recording.transmitters[row.transmitter].radio != Radio::kWifi) continue;
      ++rows;
      repeats += seen.insert({row.transmitter, row.heard_ns}).second ? 0 : 1;
    }
  }
  EXPECT_NEAR(static_cast<double>(repeats) / static_cast<double>(rows), 0.43, 0.06);  // ilc20
}

TEST(Change, SilencesAndAltersTheSharesItIsTold) {
  std::vector<Sender> senders(2000, SenderAt({0, 0, 2.5}, 0));
  const ChangeSettings settings = {
      .vanished_share = 0.2, .altered_share = 0.3, .altered_sigma_db = 8.0};
  int silent = 0;
  int altered = 0;
  double squares = 0;
  for (const Sender& sender : ChangeSenders(senders, settings, Random(7))) {
    const double change_db = sender.power_at_1m_dbm + 40.0;
    silent += change_db < -500.0 ? 1 : 0;
    if (change_db == 0.0 || change_db < -500.0) continue;
    ++altered;
    squares += change_db * change_db;
  }
  EXPECT_NEAR(silent, 400, 60);
  EXPECT_NEAR(altered, 600, 70);
  EXPECT_NEAR(std::sqrt(squares / altered), 8.0, 0.8);
}

TEST(OfficePlan, CountsTheWallsOfAStraightLine) {
  const Plan plan = MakeSampleOffice();
  EXPECT_EQ(CountWallsBetween(plan, 0, {10.0, 6.2}, {20.0, 6.2}), 0);   // along a corridor
  EXPECT_EQ(CountWallsBetween(plan, 0, {10.0, 6.2}, {10.0, 4.0}), 1);   // into an office
  EXPECT_EQ(CountWallsBetween(plan, 0, {10.0, 6.2}, {10.0, 17.8}), 3);  // through two rooms between
  EXPECT_EQ(CountWallsBetween(plan, 0, {1.0, 2.0}, {43.0, 2.0}),
            7);  // through all southern offices
}

TEST(OfficePlan, CorridorsRunBetweenTheRooms) {
  const Plan plan = MakeSampleOffice();
  const Floor& floor = plan.building.floors.front();
  for (const WayLink& link : plan.links) {
    const Eigen::Vector2d a = plan.Node(link.from).position_m;
    const Eigen::Vector2d b = plan.Node(link.to).position_m;
    EXPECT_EQ(CountWallsBetween(plan, 0, a, b), 0);
    EXPECT_FALSE(InsidePolygons(floor.obstacles, 0.5 * (a + b)));
  }
}

}  // namespace
}  // namespace walkgraph
