#include "factors/dead_reckoning.h"

#include <algorithm>
#include <cmath>

#include "data/angle.h"

namespace walkgraph {
namespace {

void ChooseHeading(const Site& site, const Evidence& evidence, const FactorSettings& settings,
                   DeadReckonedPath* path) {
  if (settings.absolute_heading.enabled && !evidence.absolute_heading_rad.empty()) {
    path->source = HeadingSource::kAbsolute;
    path->heading_rad = evidence.absolute_heading_rad;
    const double offset = settings.heading_offset.mode == StateMode::kAbsent
                              ? 0.0
                              : settings.heading_offset.prior_mean_rad;
    for (double& heading : path->heading_rad.value) heading += site.HeadingToBuilding() + offset;
  } else if (settings.heading_increment.enabled && !evidence.gyro_yaw_rad.empty()) {
    path->source = HeadingSource::kGyroscope;
    path->heading_rad = evidence.gyro_yaw_rad;
  }
}

void Append(TimeNs time_ns, const Eigen::Vector2d& position_m, Stream<Eigen::Vector2d>* stream) {
  if (!stream->empty() && stream->time_ns.back() >= time_ns) {
    stream->value.back() = position_m;
    return;
  }
  stream->push_back(time_ns, position_m);
}

}  // namespace

Eigen::Vector2d DeadReckonedPath::PositionAt(TimeNs time_ns) const {
  const auto& times = position_m.time_ns;
  const auto after = std::upper_bound(times.begin(), times.end(), time_ns);
  if (after == times.begin()) return position_m.value.front();
  if (after == times.end()) return position_m.value.back();
  const auto i = static_cast<std::size_t>(after - times.begin());
  const double share =
      SecondsBetween(times[i - 1], time_ns) / SecondsBetween(times[i - 1], times[i]);
  return position_m.value[i - 1] + share * (position_m.value[i] - position_m.value[i - 1]);
}

double DeadReckonedPath::HeadingAt(TimeNs time_ns) const {
  return heading_rad.empty() ? 0.0 : Interpolate(heading_rad, time_ns);
}

DeadReckonedPath DeadReckon(const Site& site, const Evidence& evidence,
                            const FactorSettings& settings) {
  DeadReckonedPath path;
  ChooseHeading(site, evidence, settings, &path);
  const double scale =
      settings.step_scale.mode == StateMode::kAbsent ? 1.0 : settings.step_scale.prior_mean;
  Eigen::Vector2d position = Eigen::Vector2d::Zero();
  Append(evidence.begin_ns, position, &path.position_m);
  if (settings.step.enabled) {
    for (const StepEvidence& step : evidence.steps) {
      Append(step.begin_ns, position, &path.position_m);
      const TimeNs middle = step.begin_ns + (step.end_ns - step.begin_ns) / 2;
      const double heading = path.HeadingAt(middle);
      position += scale * step.length_m * DirectionOf(heading);
      Append(step.end_ns, position, &path.position_m);
    }
  }
  Append(evidence.end_ns, position, &path.position_m);
  return path;
}

}  // namespace walkgraph
