#include "frontends/radio_map/trainer.h"

#include <algorithm>
#include <set>
#include <tuple>

#include "frontends/radio_map/map_builder.h"
#include "frontends/radio_map/map_calibration.h"
#include "frontends/radio_map/sweeps.h"

namespace walkgraph {
namespace {

constexpr double kPathSpacingM = 1.0;
// A reading this long before the first or after the last known position is still placed there.
constexpr double kClampSeconds = 1.0;

std::vector<Transmitter> AllTransmitters(const std::vector<SurveyWalk>& walks) {
  std::set<Transmitter> all;
  for (const SurveyWalk& walk : walks) {
    if (walk.trajectory.empty()) continue;
    for (const RadioReading& reading : walk.evidence->readings) {
      all.insert(walk.evidence->transmitters[reading.transmitter]);
    }
  }
  return {all.begin(), all.end()};
}

void AppendPath(const Trajectory& trajectory, std::uint32_t walk, std::vector<SurveyPoint>* path) {
  const PoseEstimate* last = nullptr;
  for (const PoseEstimate& pose : trajectory.poses) {
    const Eigen::Vector2d to = pose.position_m.head<2>();
    if (last == nullptr || last->floor != pose.floor) {
      path->push_back({to, pose.floor, walk});
      last = &pose;
      continue;
    }
    const Eigen::Vector2d from = last->position_m.head<2>();
    const int pieces = static_cast<int>((to - from).norm() / kPathSpacingM);
    for (int i = 1; i <= pieces; ++i) {
      path->push_back({from + (to - from) * i / pieces, pose.floor, walk});
    }
    if (pieces > 0) last = &pose;
  }
}

bool IsPlaced(const Trajectory& trajectory, TimeNs time_ns) {
  return SecondsBetween(time_ns, trajectory.poses.front().time_ns) <= kClampSeconds &&
         SecondsBetween(trajectory.poses.back().time_ns, time_ns) <= kClampSeconds;
}

void AppendScans(const SurveyWalk& walk, std::uint32_t index, Radio radio,
                 const std::vector<std::int32_t>& site_index, std::vector<SurveyScan>* scans) {
  for (const Sweep& sweep : GroupSweeps(*walk.evidence, radio)) {
    SurveyScan scan;
    scan.walk = index;
    scan.radio = radio;
    scan.printed_ns = walk.evidence->readings[sweep.readings.front()].printed_ns;
    scan.floor = walk.trajectory.At(sweep.mean_heard_ns).floor;
    for (const std::size_t i : sweep.readings) {
      const RadioReading& reading = walk.evidence->readings[i];
      if (!IsPlaced(walk.trajectory, reading.heard_ns)) continue;
      const PoseEstimate pose = walk.trajectory.At(reading.heard_ns);
      scan.readings.push_back(
          {static_cast<std::uint32_t>(site_index[reading.transmitter]), reading.rssi_dbm,
           static_cast<float>(SecondsBetween(reading.heard_ns, reading.printed_ns)),
           pose.position_m.head<2>().cast<float>()});
    }
    if (!scan.readings.empty()) scans->push_back(std::move(scan));
  }
}

void TrainMaps(const TrainerSettings& settings, Site* site) {
  std::set<int> floors;
  for (const SurveyScan& scan : site->scans) floors.insert(scan.floor);
  for (const int floor : floors) {
    const FieldGrid grid =
        CoveringGrid(site->building.FindFloor(floor), site->path, floor, settings);
    for (const Radio radio : {Radio::kWifi, Radio::kBeacon}) {
      ScanList scans;
      for (const SurveyScan& scan : site->scans) {
        if (scan.floor == floor && scan.radio == radio) scans.push_back(&scan);
      }
      if (scans.empty()) continue;
      const FieldModel model = SelectFieldModel(floor, radio, grid, scans, settings);
      RadioMap map = BuildMap(floor, radio, grid, scans, model, settings);
      const MapCalibration calibration = CalibrateMap(floor, radio, grid, scans, model, settings);
      map.n_eff = calibration.n_eff;
      map.hear_weight = calibration.hear_weight;
      map.map_error_sigma_m = calibration.map_error_sigma_m;
      site->maps.push_back(std::move(map));
    }
  }
}

}  // namespace

Site TrainSite(const Building& building, const std::vector<SurveyWalk>& walks,
               const TrainerSettings& settings) {
  Site site;
  site.building = building;
  site.transmitters = AllTransmitters(walks);
  for (std::size_t i = 0; i < walks.size(); ++i) {
    const SurveyWalk& walk = walks[i];
    if (walk.trajectory.empty()) continue;
    const std::uint32_t index = static_cast<std::uint32_t>(i);
    AppendPath(walk.trajectory, index, &site.path);
    const std::vector<std::int32_t> site_index = MatchTransmitters(site, *walk.evidence);
    for (const Radio radio : {Radio::kWifi, Radio::kBeacon}) {
      AppendScans(walk, index, radio, site_index, &site.scans);
    }
  }
  std::stable_sort(site.scans.begin(), site.scans.end(),
                   [](const SurveyScan& a, const SurveyScan& b) {
                     return std::tie(a.walk, a.printed_ns) < std::tie(b.walk, b.printed_ns);
                   });
  TrainMaps(settings, &site);
  return site;
}

}  // namespace walkgraph
