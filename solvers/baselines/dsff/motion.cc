#include "solvers/baselines/dsff/motion.h"

#include <algorithm>
#include <cmath>
#include <cstddef>

namespace walkgraph {
namespace {

double StepsWithin(const Evidence& evidence, TimeNs begin_ns, TimeNs end_ns) {
  double steps = 0;
  for (const StepEvidence& step : evidence.steps) {
    const double inside_s =
        SecondsBetween(std::max(begin_ns, step.begin_ns), std::min(end_ns, step.end_ns));
    if (inside_s > 0) steps += inside_s / SecondsBetween(step.begin_ns, step.end_ns);
  }
  return steps;
}

void SetWay(const Eigen::Vector2d& way_m, DsffMotion* motion) {
  motion->distance_m = way_m.norm();
  motion->heading_rad = std::atan2(way_m.y(), way_m.x());
}

}  // namespace

Evidence WithGyroscopeHeading(const Evidence& evidence) {
  Evidence result = evidence;
  const Stream<double>& compass = evidence.absolute_heading_rad;
  double sine = 0, cosine = 0;
  for (std::size_t i = 0; i < compass.size(); ++i) {
    const double d = compass.value[i] - Interpolate(evidence.gyro_yaw_rad, compass.time_ns[i]);
    sine += std::sin(d);
    cosine += std::cos(d);
  }
  const double turn = std::atan2(sine, cosine);
  result.absolute_heading_rad = evidence.gyro_yaw_rad;
  for (double& heading : result.absolute_heading_rad.value) heading += turn;
  result.absolute_heading_sigma_rad.assign(result.absolute_heading_rad.size(), 0.0);
  return result;
}

std::vector<DsffMotion> MeasureDsffMotion(const Evidence& evidence, const DeadReckonedPath& path,
                                          const std::vector<TimeNs>& epochs) {
  std::vector<DsffMotion> motion(epochs.size());
  const Stream<double>& height = evidence.barometric_height_m;
  for (std::size_t e = 0; e < epochs.size(); ++e) {
    if (!height.empty()) {
      motion[e].height_m = Interpolate(height, epochs[e]) - Interpolate(height, epochs.front());
    }
    if (e == 0) continue;
    SetWay(path.PositionAt(epochs[e]) - path.PositionAt(epochs[e - 1]), &motion[e]);
    motion[e].steps = StepsWithin(evidence, epochs[e - 1], epochs[e]);
  }
  return motion;
}

void SubstituteTruth(const Trajectory& truth, const std::vector<TimeNs>& epochs,
                     const TrueSensors& sensors, std::vector<DsffMotion>* motion) {
  constexpr double kNoHeadingM = 0.3;
  if (truth.empty()) return;
  const TimeNs begin = truth.poses.front().time_ns, end = truth.poses.back().time_ns;
  const double first_height_m = truth.At(epochs.front()).position_m.z();
  for (std::size_t e = 0; e < epochs.size(); ++e) {
    DsffMotion& reading = (*motion)[e];
    if (epochs[e] < begin || epochs[e] > end) continue;
    const Eigen::Vector3d now = truth.At(epochs[e]).position_m;
    if (sensors.height) reading.height_m = now.z() - first_height_m;
    if (e == 0 || epochs[e - 1] < begin) continue;
    DsffMotion exact = reading;
    SetWay((now - truth.At(epochs[e - 1]).position_m).head<2>(), &exact);
    if (sensors.distance) reading.distance_m = exact.distance_m;
    if (sensors.heading && exact.distance_m > kNoHeadingM) reading.heading_rad = exact.heading_rad;
  }
}

}  // namespace walkgraph
