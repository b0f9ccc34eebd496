#include "data/simulator/sample.h"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <filesystem>

#include "data/formats/csv.h"
#include "data/formats/text_output.h"
#include "data/simulator/barometer.h"
#include "data/simulator/magnetic.h"
#include "data/simulator/office_plan.h"
#include "data/simulator/phone.h"
#include "data/simulator/radio.h"
#include "data/simulator/scenarios.h"
#include "data/simulator/walk_truth.h"

namespace walkgraph {
namespace {

constexpr double kSurveyLengthM = 28.0;
constexpr double kTestLengthM = 66.0;
constexpr double kTestStopS = 4.0;
constexpr TimeNs kImuIntervalNs = 20 * kNsPerMs;  // 50 Hz
constexpr TimeNs kBeginNs = 10 * kNsPerSecond;    // readings heard before the walk have times too
// Walks begin and end this far from crossings.
constexpr double kEndMarginM = 1.5;
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
enum RandomStream : std::uint64_t {
  kPlaceStream,
  kMagneticStream,
  kHandlingStream,
  kWalkStream = 1000
};

int OtherEnd(const WayLink& link, int node) { return link.from == node ? link.to : link.from; }

// A link at `node` other than the one the person comes along.
int NextLink(const Plan& plan, int node, int arrived_by, Random* random) {
  std::vector<int> choices;
  for (int i = 0; i < static_cast<int>(plan.links.size()); ++i) {
    const WayLink& link = plan.Link(i);
    if (i != arrived_by && (link.from == node || link.to == node)) choices.push_back(i);
  }
  return choices[static_cast<std::size_t>(random->Index(static_cast<int>(choices.size())))];
}

// The corners of a random path from a point on the first link until the length is used up.
std::vector<RouteCorner> RandomCorners(const Plan& plan, int first_link, double length_m,
                                       Random* random) {
  int link = first_link;
  const WayLink& first = plan.Link(link);
  int target = random->Uniform() < 0.5 ? first.from : first.to;
  const Eigen::Vector2d begin = plan.Node(first.from).position_m;
  const Eigen::Vector2d end = plan.Node(first.to).position_m;
  const double margin = kEndMarginM / (end - begin).norm();
  std::vector<RouteCorner> corners = {
      {begin + (end - begin) * random->Uniform(margin, 1.0 - margin)}};
  double left = length_m;
  while (true) {
    const Eigen::Vector2d& node = plan.Node(target).position_m;
    const Eigen::Vector2d from = corners.back().position_m;
    const Eigen::Vector2d leg = node - from;
    if (leg.norm() >= left) {
      const double last =
          std::clamp(left, kEndMarginM, std::max(kEndMarginM, leg.norm() - kEndMarginM));
      corners.push_back({from + leg.normalized() * last});
      return corners;
    }
    left -= leg.norm();
    corners.push_back({node});
    link = NextLink(plan, target, link, random);
    target = OtherEnd(plan.Link(link), target);
  }
}

struct WalkPlan {
  std::string name;
  int first_link = 0;
  double length_m = 0;
  double stop_s = 0;
};

// Where everything happens.
struct Place {
  SimulationSettings settings = SampleSettings();
  Plan plan = MakeSampleOffice();
  std::vector<Sender> access_points;
};

SimulatedWalk MakeWalk(const Place& place, const WalkPlan& walk_plan, Random random) {
  const SimulationSettings& settings = place.settings;
  SimulatedWalk walk;
  walk.name = walk_plan.name;
  std::vector<Leg> legs = {
      {.route = Route(RandomCorners(place.plan, walk_plan.first_link, walk_plan.length_m, &random),
                      {}, &random)}};
  const Gait gait = RandomGait(settings.gait, &random);
  legs[0].stops = {{random.Uniform(0.3, 0.7) * legs[0].route.length_m(), walk_plan.stop_s}};
  walk.path = WalkLegs(legs, gait, settings, kStandAtEndsS, kBeginNs, kImuIntervalNs, &random);
  walk.truth = MakeTruth(place.plan, legs, walk.path, walk.path.front().time_ns,
                         settings.walks.waypoint_every_s);
  walk.recording.id = walk.name;
  walk.recording.device = "simulated";
  walk.recording.begin_ns = walk.path.front().time_ns;
  walk.recording.end_ns = walk.path.back().time_ns;
  const Handling handling(0.0, random.Fork(kHandlingStream));
  Random steel = random.Fork(kMagneticStream);
  const MagneticField field(settings.magnetic, 0.0, &steel);
  const std::vector<Eigen::Quaterniond> attitudes =
      SimulateAttitudes(walk.path, gait, settings.hold, handling, &random);
  SimulateInertial(walk.path, attitudes, gait, settings, handling, &random, &walk.recording);
  SimulateMagnetic(walk.path, attitudes, field, settings.magnetic, 0.0, &random, &walk.recording);
  SimulateBarometer(walk.path, settings.barometer, &random, &walk.recording);
  SimulateWifi(place.plan, place.access_points, walk.path, settings, &random, &walk.recording);
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
  Place place;
  Random places = random.Fork(kPlaceStream);
  place.access_points = PlaceAccessPoints(place.plan, place.settings, &places);
  Sample sample;
  sample.building = place.plan.building;
  const int links = static_cast<int>(place.plan.links.size());
  const WalkSettings& walks = place.settings.walks;
  for (int i = 0; i < walks.survey + walks.test; ++i) {
    const bool survey = i < walks.survey;
    WalkPlan walk;
    walk.name = survey ? WalkName("survey", i + 1) : WalkName("test", i - walks.survey + 1);
    walk.first_link = i % links;  // so that the survey begins everywhere
    walk.length_m = survey ? kSurveyLengthM : kTestLengthM;
    walk.stop_s = survey ? 0.0 : kTestStopS;
    sample.walks.push_back(
        MakeWalk(place, walk, random.Fork(kWalkStream + static_cast<std::uint64_t>(i))));
  }
  return sample;
}

void SimulateSample(const std::string& out_dir, std::uint64_t seed) {
  namespace fs = std::filesystem;
  MakeFolder(out_dir);
  const Sample sample = MakeSample(seed);
  WriteBuildingJson(sample.building, (fs::path(out_dir) / "building.json").string());
  for (const SimulatedWalk& walk : sample.walks) {
    WriteCsvWalk(walk.recording, walk.truth, kPrecision, (fs::path(out_dir) / walk.name).string());
  }
}

}  // namespace walkgraph
