#include "data/simulator/sample.h"

#include <algorithm>
#include <cstdio>
#include <filesystem>
#include <system_error>

#include "data/formats/csv.h"
#include "data/input_error.h"
#include "data/simulator/imu.h"
#include "data/simulator/plan.h"
#include "data/simulator/radio.h"
#include "data/simulator/random.h"
#include "data/simulator/route.h"

namespace walkgraph {
namespace {

constexpr int kAccessPoints = 40;
constexpr int kSurveyWalks = 14;
constexpr int kTestWalks = 4;
constexpr double kSurveyLengthM = 28.0;
constexpr double kTestLengthM = 66.0;
constexpr double kTestStopS = 4.0;
constexpr TimeNs kImuIntervalNs = 20 * kNsPerMs;  // 50 Hz
constexpr TimeNs kBeginNs = 10 * kNsPerSecond;    // readings heard before the walk have times too
constexpr double kWaypointEveryS = 10.0;
// As many decimals as the sensors have digits: the sample is part of the source tree.
constexpr CsvPrecision kPrecision = {.time_s = 2,
                                     .acceleration_mps2 = 2,
                                     .angular_rate_radps = 3,
                                     .magnetic_field_ut = 1,
                                     .quaternion = 4,
                                     .pressure_hpa = 3,
                                     .rssi_dbm = 0,
                                     .waypoint = 2};

// Streams of random numbers, so that a change to one part of the simulator leaves the others as
// they were.
enum RandomStream : std::uint64_t { kPlaceStream, kWalkStream = 1000 };

Waypoint MakeWaypoint(const WalkState& state) { return {state.time_ns, state.position_m, 0}; }

// A waypoint where the person starts, turns and arrives, and between them so that none is further
// than kWaypointEveryS from the one before.
Truth MakeTruth(const Route& route, const std::vector<WalkState>& states) {
  std::vector<TimeNs> times = {states.front().time_ns, states.back().time_ns};
  for (const double turn_m : route.turns_m()) {
    const auto there = std::find_if(states.begin(), states.end(), [&](const WalkState& state) {
      return state.distance_m >= turn_m;
    });
    if (there != states.end()) times.push_back(there->time_ns);
  }
  std::sort(times.begin(), times.end());
  Truth truth;
  TimeNs last_ns = states.front().time_ns;
  std::size_t next = 0;
  for (const WalkState& state : states) {
    const bool due = next < times.size() && state.time_ns >= times[next];
    const bool long_ago = SecondsBetween(last_ns, state.time_ns) >= kWaypointEveryS;
    if (!due && !long_ago) continue;
    while (next < times.size() && state.time_ns >= times[next]) ++next;
    truth.waypoints.push_back(MakeWaypoint(state));
    last_ns = state.time_ns;
  }
  return truth;
}

struct WalkPlan {
  std::string name;
  int first_link = 0;
  double length_m = 0;
  double stop_s = 0;
};

SimulatedWalk MakeWalk(const Plan& plan, const std::vector<AccessPoint>& access_points,
                       const WalkPlan& walk_plan, Random random) {
  SimulatedWalk walk;
  walk.name = walk_plan.name;
  const Route route(plan, walk_plan.first_link, walk_plan.length_m, &random);
  const Gait gait = RandomGait(&random);
  const Stop stop = {random.Uniform(0.3, 0.7) * route.length_m(), walk_plan.stop_s};
  walk.path = WalkRoute(route, gait, stop, kBeginNs, kImuIntervalNs, &random);
  walk.truth = MakeTruth(route, walk.path);
  walk.recording.id = walk.name;
  walk.recording.device = "simulated";
  walk.recording.begin_ns = walk.path.front().time_ns;
  walk.recording.end_ns = walk.path.back().time_ns;
  SimulateImu(walk.path, gait, &random, &walk.recording);
  SimulateWifi(plan, access_points, walk.path, &random, &walk.recording);
  return walk;
}

std::string WalkName(const char* set, int number) {
  char name[32];
  std::snprintf(name, sizeof(name), "%s/walk_%02d", set, number);
  return name;
}

}  // namespace

Sample MakeSample(std::uint64_t seed) {
  const Random random(seed);
  const Plan plan = MakeOfficePlan();
  Random places = random.Fork(kPlaceStream);
  const std::vector<AccessPoint> access_points = PlaceAccessPoints(plan, kAccessPoints, &places);
  Sample sample;
  sample.building = plan.building;
  const int links = static_cast<int>(plan.links.size());
  for (int i = 0; i < kSurveyWalks + kTestWalks; ++i) {
    const bool survey = i < kSurveyWalks;
    WalkPlan walk;
    walk.name = survey ? WalkName("survey", i + 1) : WalkName("test", i - kSurveyWalks + 1);
    walk.first_link = i % links;  // so that the survey begins everywhere
    walk.length_m = survey ? kSurveyLengthM : kTestLengthM;
    walk.stop_s = survey ? 0.0 : kTestStopS;
    sample.walks.push_back(MakeWalk(plan, access_points, walk,
                                    random.Fork(kWalkStream + static_cast<std::uint64_t>(i))));
  }
  return sample;
}

void SimulateSample(const std::string& out_dir, std::uint64_t seed) {
  namespace fs = std::filesystem;
  std::error_code error;
  fs::create_directories(out_dir, error);
  if (error) throw InputError(out_dir, 0, error.message(), "a folder that can be made");
  const Sample sample = MakeSample(seed);
  WriteBuildingJson(sample.building, (fs::path(out_dir) / "building.json").string());
  for (const SimulatedWalk& walk : sample.walks) {
    WriteCsvWalk(walk.recording, walk.truth, kPrecision, (fs::path(out_dir) / walk.name).string());
  }
}

}  // namespace walkgraph
