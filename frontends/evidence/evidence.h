#ifndef WALKGRAPH_FRONTENDS_EVIDENCE_EVIDENCE_H_
#define WALKGRAPH_FRONTENDS_EVIDENCE_EVIDENCE_H_

#include <Eigen/Core>
#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <map>
#include <optional>
#include <string>
#include <vector>

#include "data/recording.h"
#include "data/time.h"

namespace walkgraph {

// What the sensors say about a walk, the same for every estimator. Headings here are in the
// east-north frame (radians counter-clockwise from magnetic east): the site's rotation turns them
// into the building frame.

// One step: the person moved length_m in the direction of walking between the two times.
struct StepEvidence {
  TimeNs begin_ns = 0;
  TimeNs end_ns = 0;
  double length_m = 0;  // Weinberg model before any step-scale state
};

enum class MotionState : std::uint8_t { kStanding, kWalking, kHandling };

// Intervals tile [Evidence::begin_ns, Evidence::end_ns] without gaps where there is an
// accelerometer.
struct MotionInterval {
  TimeNs begin_ns = 0;
  TimeNs end_ns = 0;
  MotionState state = MotionState::kStanding;
};

// A unique reading at the time it was heard (not printed).
struct RadioReading {
  TimeNs heard_ns = 0;
  TimeNs printed_ns = 0;          // readings of one scan share it
  std::uint32_t transmitter = 0;  // index into Evidence::transmitters
  float rssi_dbm = 0;
};

// Magnetic field in the gravity frame.
struct MagneticSample {
  double norm_ut = 0;
  double inclination_rad = 0;  // below the horizontal plane positive
};

// A surveyed tag whose position is known (--use_waypoints).
struct PositionAnchor {
  TimeNs time_ns = 0;
  Eigen::Vector2d position_m = Eigen::Vector2d::Zero();
  int floor = 0;
  double sigma_m = 0;
};

struct Evidence {
  std::string id;
  std::string device;
  TimeNs begin_ns = 0;  // the recorded span
  TimeNs end_ns = 0;
  std::optional<TimeNs> begin_unix_ns;  // as Recording's

  std::vector<StepEvidence> steps;     // by time, not overlapping
  std::vector<MotionInterval> motion;  // by time
  // Integral of the gyroscope about the vertical, unwrapped, from 0 at its first sample: only
  // differences mean anything. Empty without gyroscope or gravity.
  Stream<double> gyro_yaw_rad;
  // Walking direction as the phone's absolute sensors give it (rotation vector, else
  // tilt-compensated magnetometer), unwrapped, with its own sigma per sample. Empty where there is
  // neither.
  Stream<double> absolute_heading_rad;
  std::vector<double> absolute_heading_sigma_rad;  // one per absolute heading
  // Height in metres by the barometer (see HeightOfPressure), about one a second, each with its own
  // sigma. Off by the weather, the device and the site's altitude: only differences mean anything.
  Stream<double> barometric_height_m;
  std::vector<double> barometric_height_sigma_m;  // one per barometric height
  Stream<MagneticSample> magnetic;

  std::vector<Transmitter> transmitters;
  std::vector<RadioReading> readings;  // by heard_ns, each reading once, none from before begin_ns
  std::vector<PositionAnchor> anchors;
  std::optional<int> floor;  // where it is given (--floor=given)

  // Counts of what the frontend dropped or doubted: "wifi_repeat", "wifi_before_begin", ...
  std::map<std::string, std::int64_t> counts;
};

// The value of an unwrapped stream at a time, linear between samples, clamped at the ends.
// Precondition: the stream is not empty.
inline double Interpolate(const Stream<double>& stream, TimeNs time_ns) {
  const auto after = std::upper_bound(stream.time_ns.begin(), stream.time_ns.end(), time_ns);
  if (after == stream.time_ns.begin()) return stream.value.front();
  if (after == stream.time_ns.end()) return stream.value.back();
  const std::size_t i = static_cast<std::size_t>(after - stream.time_ns.begin());
  const double span = SecondsBetween(stream.time_ns[i - 1], stream.time_ns[i]);
  const double fraction = SecondsBetween(stream.time_ns[i - 1], time_ns) / span;
  return stream.value[i - 1] + fraction * (stream.value[i] - stream.value[i - 1]);
}

// The motion state at a time; kWalking where the evidence has none, as the one that assumes least.
inline MotionState MotionStateAt(const Evidence& evidence, TimeNs time_ns) {
  const auto after = std::upper_bound(
      evidence.motion.begin(), evidence.motion.end(), time_ns,
      [](TimeNs time, const MotionInterval& interval) { return time < interval.begin_ns; });
  if (after == evidence.motion.begin()) return MotionState::kWalking;
  return (after - 1)->state;
}

// The mean field of the samples within [begin, end); none where there is no sample.
inline std::optional<MagneticSample> MeanField(const Stream<MagneticSample>& field, TimeNs begin_ns,
                                               TimeNs end_ns) {
  const auto first = std::lower_bound(field.time_ns.begin(), field.time_ns.end(), begin_ns) -
                     field.time_ns.begin();
  MagneticSample sum;
  std::size_t i = static_cast<std::size_t>(first);
  for (; i < field.size() && field.time_ns[i] < end_ns; ++i) {
    sum.norm_ut += field.value[i].norm_ut;
    sum.inclination_rad += field.value[i].inclination_rad;
  }
  const auto count = static_cast<double>(i - static_cast<std::size_t>(first));
  if (count == 0) return std::nullopt;
  return MagneticSample{sum.norm_ut / count, sum.inclination_rad / count};
}

}  // namespace walkgraph

#endif  // WALKGRAPH_FRONTENDS_EVIDENCE_EVIDENCE_H_
