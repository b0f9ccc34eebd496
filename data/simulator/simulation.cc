#include "data/simulator/simulation.h"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <iterator>
#include <utility>

#include "data/formats/csv.h"
#include "data/simulator/barometer.h"
#include "data/simulator/grid_plan.h"
#include "data/simulator/itinerary.h"
#include "data/simulator/office_plan.h"
#include "data/simulator/phone.h"
#include "data/simulator/walk_truth.h"

namespace walkgraph {
namespace {

// Streams of random numbers: of the place, and of a walk.
enum PlaceStream : std::uint64_t {
  kBuilding,
  kSteel,
  kAccessPoints,
  kBeacons,
  kChange,
  kStarts,
  kFirstWalk = 1000
};
enum WalkStream : std::uint64_t {
  kTour,
  kMotion,
  kHandling,
  kHold,
  kInertial,
  kMagnetic,
  kBarometer,
  kWifi,
  kBeacon
};

// Walks begin two hours apart, so that no two ever hear the same reading.
constexpr TimeNs kFirstBeginNs = 10 * kNsPerSecond;
constexpr TimeNs kBetweenBeginsNs = 2LL * 3600 * kNsPerSecond;
// The first waypoint lies that long before the first step.
constexpr double kBeforeFirstStepS = 0.5;
constexpr double kBodyInertiaS = 0.4;  // a third of a stride: what a body can change its way in

Plan MakePlan(const SimulationSettings& settings, Random random) {
  Plan plan = settings.building.kind == BuildingKind::kHall
                  ? MakeHall(settings.building)
                  : MakeOffice(settings.building, settings.gait, &random);
  plan.building.origin = {settings.building.latitude_deg, settings.building.longitude_deg,
                          DegreesToRadians(settings.building.rotation_deg)};
  return plan;
}

std::string WalkName(bool survey, int number) {
  char name[32];
  std::snprintf(name, sizeof(name), "%s/walk_%02d", survey ? "survey" : "test", number);
  return name;
}

std::vector<int> Shuffled(std::vector<int> values, Random random) {
  for (int left = static_cast<int>(values.size()); left > 1; --left) {
    std::swap(values[static_cast<std::size_t>(left - 1)],
              values[static_cast<std::size_t>(random.Index(left))]);
  }
  return values;
}

// Times of writers are whole milliseconds.
TimeNs IntervalNs(double rate_hz) {
  return kNsPerMs * std::max<TimeNs>(1, std::lround(1000.0 / rate_hz));
}

}  // namespace

Simulation::Simulation(const SimulationSettings& settings, std::uint64_t seed)
    : Simulation(settings, seed, MakePlan(settings, Random(seed).Fork(kBuilding))) {}

Simulation::Simulation(const SimulationSettings& settings, std::uint64_t seed,
                       const std::string& plan_path)
    : Simulation(
          settings, seed,
          MakeGivenPlan(ReadBuildingJson(plan_path), settings.building, settings.gait, plan_path)) {
}

Simulation::Simulation(const SimulationSettings& settings, std::uint64_t seed, Plan plan)
    : settings_(settings), random_(seed), plan_(std::move(plan)), field_([this] {
        Random steel = random_.Fork(kSteel);
        return MagneticField(settings_.magnetic, RotationRad(), &steel);
      }()) {
  Random access_points = random_.Fork(kAccessPoints);
  Random beacons = random_.Fork(kBeacons);
  if (settings_.wifi.enabled) {
    survey_senders_ = PlaceAccessPoints(plan_, settings_, &access_points);
  }
  if (settings_.beacon.enabled) {
    std::vector<Sender> placed = PlaceBeacons(plan_, settings_, &beacons);
    std::move(placed.begin(), placed.end(), std::back_inserter(survey_senders_));
  }
  starts_ = Shuffled(CorridorLinks(plan_), random_.Fork(kStarts));
  test_senders_ = ChangeSenders(survey_senders_, settings_.change, random_.Fork(kChange));
}

double Simulation::RotationRad() const {
  return plan_.building.origin ? plan_.building.origin->rotation_rad : 0.0;
}

SimulatedWalk Simulation::MakeWalk(int index) const {
  const bool survey = index < settings_.walks.survey;
  const Random random = random_.Fork(kFirstWalk + static_cast<std::uint64_t>(index));
  SimulatedWalk walk;
  walk.name = WalkName(survey, survey ? index + 1 : index - settings_.walks.survey + 1);
  Random motion = random.Fork(kMotion);
  Random tour = random.Fork(kTour);
  const Gait gait = RandomGait(settings_.gait, &motion);
  const int start =
      survey ? starts_[static_cast<std::size_t>(index) % starts_.size()]
             : starts_[static_cast<std::size_t>(tour.Index(static_cast<int>(starts_.size())))];
  const std::vector<Leg> legs =
      RandomTour(plan_, start, gait, settings_, settings_.walks.duration_s, &tour);
  const double wait_s =
      std::max(kStandAtEndsS, settings_.walks.handling_s + settings_.walks.stand_after_handling_s);
  const TimeNs begin_ns = kFirstBeginNs + index * kBetweenBeginsNs;
  walk.path = WalkLegs(legs, gait, settings_, wait_s, begin_ns, IntervalNs(settings_.walks.rate_hz),
                       &motion);
  SmoothPath(kBodyInertiaS, &walk.path);
  walk.truth = MakeTruth(plan_, legs, walk.path, begin_ns + DurationNs(wait_s - kBeforeFirstStepS),
                         settings_.walks.waypoint_every_s);
  walk.recording.id = walk.name;
  walk.recording.device = "simulated";
  walk.recording.begin_ns = walk.path.front().time_ns;
  walk.recording.end_ns = walk.path.back().time_ns;
  SimulateSensors(walk.path, gait, random, &walk.recording);
  SimulateRadio(walk.path, survey, random, &walk.recording);
  return walk;
}

void Simulation::SimulateSensors(const std::vector<WalkState>& states, const Gait& gait,
                                 const Random& random, Recording* recording) const {
  const Handling handling(settings_.walks.handling_s, random.Fork(kHandling));
  Random hold = random.Fork(kHold);
  Random inertial = random.Fork(kInertial);
  Random magnetic = random.Fork(kMagnetic);
  Random barometer = random.Fork(kBarometer);
  const std::vector<Eigen::Quaterniond> attitudes =
      SimulateAttitudes(states, gait, settings_.hold, handling, &hold);
  SimulateInertial(states, attitudes, gait, settings_, handling, &inertial, recording);
  SimulateMagnetic(states, attitudes, field_, settings_.magnetic, RotationRad(), &magnetic,
                   recording);
  SimulateBarometer(states, settings_.barometer, &barometer, recording);
}

void Simulation::SimulateRadio(const std::vector<WalkState>& states, bool survey,
                               const Random& random, Recording* recording) const {
  std::vector<Sender> access_points;
  std::vector<Sender> beacons;
  for (const Sender& sender : survey ? survey_senders_ : test_senders_) {
    (sender.radio == Radio::kWifi ? access_points : beacons).push_back(sender);
  }
  Random wifi = random.Fork(kWifi);
  Random beacon = random.Fork(kBeacon);
  SimulateWifi(plan_, access_points, states, settings_, &wifi, recording);
  SimulateBeacons(plan_, beacons, states, settings_, &beacon, recording);
  std::stable_sort(
      recording->radio_rows.begin(), recording->radio_rows.end(),
      [](const RadioRow& a, const RadioRow& b) { return a.printed_ns < b.printed_ns; });
}

}  // namespace walkgraph
