#include "frontends/radio_map/survey_scans.h"

#include <algorithm>
#include <utility>

#include "frontends/radio_map/sweeps.h"

namespace walkgraph {
namespace {

// A reading this long before the first or after the last known position is still placed there.
constexpr double kClampSeconds = 1.0;

bool IsPlaced(const Trajectory& trajectory, TimeNs stamp_ns, const LagRange& lags) {
  const double before_s = SecondsBetween(stamp_ns, trajectory.poses.front().time_ns);
  const double after_s = SecondsBetween(trajectory.poses.back().time_ns, stamp_ns);
  return before_s - lags.first_s <= kClampSeconds && after_s + lags.last_s <= kClampSeconds;
}

}  // namespace

std::uint32_t FirstOfTrial(const std::vector<SurveyWalk>& walks, std::size_t index) {
  if (walks[index].trial.empty()) return static_cast<std::uint32_t>(index);
  const auto first = std::find_if(walks.begin(), walks.end(), [&](const SurveyWalk& walk) {
    return walk.trial == walks[index].trial;
  });
  return static_cast<std::uint32_t>(first - walks.begin());
}

std::vector<SurveyScan> PlaceScans(const std::vector<SurveyWalk>& walks, std::size_t index,
                                   Radio radio, const std::vector<std::int32_t>& site_index,
                                   double lag_s, const LagRange& placed) {
  const SurveyWalk& walk = walks[index];
  const std::uint32_t trial = FirstOfTrial(walks, index);
  const TimeNs lag_ns = DurationNs(lag_s);
  std::vector<SurveyScan> scans;
  for (const Sweep& sweep : GroupSweeps(*walk.evidence, radio)) {
    SurveyScan scan;
    scan.walk = static_cast<std::uint32_t>(index);
    scan.trial = trial;
    scan.radio = radio;
    scan.printed_ns = walk.evidence->readings[sweep.readings.front()].printed_ns;
    scan.floor = walk.trajectory.At(sweep.mean_heard_ns + lag_ns).floor;
    for (const std::size_t i : sweep.readings) {
      const RadioReading& reading = walk.evidence->readings[i];
      if (!IsPlaced(walk.trajectory, reading.heard_ns, placed)) continue;
      const PoseEstimate pose = walk.trajectory.At(reading.heard_ns + lag_ns);
      scan.readings.push_back(
          {static_cast<std::uint32_t>(site_index[reading.transmitter]), reading.rssi_dbm,
           static_cast<float>(SecondsBetween(reading.heard_ns, reading.printed_ns)),
           pose.position_m.head<2>().cast<float>(), static_cast<float>(pose.heading_rad)});
    }
    if (!scan.readings.empty()) scans.push_back(std::move(scan));
  }
  return scans;
}

Eigen::Vector2d MeanPosition(const SurveyScan& scan) {
  Eigen::Vector2d sum = Eigen::Vector2d::Zero();
  for (const SurveyReading& reading : scan.readings) sum += reading.position_m.cast<double>();
  return sum / static_cast<double>(scan.readings.size());
}

std::uint32_t NextWalk(const Site& site) {
  std::uint32_t next = 0;
  for (const SurveyScan& scan : site.scans) next = std::max(next, scan.walk + 1);
  for (const SurveyPoint& point : site.path) next = std::max(next, point.walk + 1);
  return next;
}

}  // namespace walkgraph
