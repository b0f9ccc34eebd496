#include "frontends/build_evidence.h"

#include <utility>
#include <vector>

#include "frontends/gravity.h"
#include "frontends/heading.h"
#include "frontends/magnetic.h"
#include "frontends/motion.h"
#include "frontends/pressure.h"
#include "frontends/readings.h"
#include "frontends/steps.h"
#include "frontends/yaw.h"

namespace walkgraph {

Evidence BuildEvidence(const Recording& recording, const FrontendSettings& settings) {
  Evidence evidence;
  evidence.id = recording.id;
  evidence.device = recording.device;
  evidence.begin_ns = recording.begin_ns;
  evidence.end_ns = recording.end_ns;
  evidence.begin_unix_ns = recording.begin_unix_ns;

  const Stream<Eigen::Vector3d> up = EstimateUp(recording, settings.gravity);
  evidence.gyro_yaw_rad =
      IntegrateYaw(recording.gyroscope_radps, up, settings.yaw, &evidence.counts);
  const std::vector<TimeSpan> handling = FindHandling(up, evidence.gyro_yaw_rad, settings.handling);
  const Stream<double> gait = GaitSignal(recording.accelerometer_mps2, up, settings.steps);
  evidence.steps = DetectSteps(gait, handling, settings.steps, &evidence.counts);
  if (!up.empty()) {
    evidence.motion =
        ClassifyMotion(recording.begin_ns, recording.end_ns, handling, evidence.steps);
  }
  HeadingStream heading =
      AbsoluteHeading(recording, up, evidence.gyro_yaw_rad, settings.heading, &evidence.counts);
  evidence.absolute_heading_rad = std::move(heading.heading_rad);
  evidence.absolute_heading_sigma_rad = std::move(heading.sigma_rad);
  HeightStream height = BarometricHeight(recording, settings.pressure, &evidence.counts);
  evidence.barometric_height_m = std::move(height.height_m);
  evidence.barometric_height_sigma_m = std::move(height.sigma_m);
  evidence.magnetic = MagneticField(recording.magnetometer_ut, up);
  evidence.transmitters = recording.transmitters;
  evidence.readings = UniqueReadings(recording, &evidence.counts);
  return evidence;
}

}  // namespace walkgraph
