#include "solvers/evidence_order.h"

#include <algorithm>
#include <cstddef>
#include <tuple>

namespace walkgraph {
namespace {

template <typename T>
std::size_t CutStream(TimeNs time_ns, Stream<T>* stream) {
  const auto size = static_cast<std::size_t>(
      std::upper_bound(stream->time_ns.begin(), stream->time_ns.end(), time_ns) -
      stream->time_ns.begin());
  stream->time_ns.resize(size);
  stream->value.resize(size);
  return size;
}

}  // namespace

Evidence InCanonicalOrder(const Evidence& evidence) {
  Evidence sorted = evidence;
  std::sort(sorted.readings.begin(), sorted.readings.end(),
            [](const RadioReading& a, const RadioReading& b) {
              return std::tie(a.heard_ns, a.printed_ns, a.transmitter, a.rssi_dbm) <
                     std::tie(b.heard_ns, b.printed_ns, b.transmitter, b.rssi_dbm);
            });
  std::sort(sorted.anchors.begin(), sorted.anchors.end(),
            [](const PositionAnchor& a, const PositionAnchor& b) {
              return std::tie(a.time_ns, a.position_m.x(), a.position_m.y(), a.sigma_m) <
                     std::tie(b.time_ns, b.position_m.x(), b.position_m.y(), b.sigma_m);
            });
  return sorted;
}

Evidence EvidenceUntil(const Evidence& evidence, TimeNs time_ns) {
  Evidence part = evidence;
  part.end_ns = std::min(part.end_ns, std::max(part.begin_ns, time_ns));
  std::erase_if(part.steps, [&](const StepEvidence& step) { return step.end_ns > time_ns; });
  std::erase_if(part.motion,
                [&](const MotionInterval& interval) { return interval.begin_ns > time_ns; });
  if (!part.motion.empty()) {
    part.motion.back().end_ns = std::min(part.motion.back().end_ns, part.end_ns);
  }
  CutStream(time_ns, &part.gyro_yaw_rad);
  part.absolute_heading_sigma_rad.resize(CutStream(time_ns, &part.absolute_heading_rad));
  part.barometric_height_sigma_m.resize(CutStream(time_ns, &part.barometric_height_m));
  CutStream(time_ns, &part.magnetic);
  std::erase_if(part.readings,
                [&](const RadioReading& reading) { return reading.printed_ns > time_ns; });
  std::erase_if(part.anchors,
                [&](const PositionAnchor& anchor) { return anchor.time_ns > time_ns; });
  return part;
}

Evidence EvidenceSince(const Evidence& evidence, TimeNs time_ns) {
  Evidence part = evidence;
  part.begin_ns = std::max(part.begin_ns, std::min(part.end_ns, time_ns));
  std::erase_if(part.steps, [&](const StepEvidence& step) { return step.begin_ns < time_ns; });
  std::erase_if(part.motion,
                [&](const MotionInterval& interval) { return interval.end_ns < time_ns; });
  if (!part.motion.empty()) {
    part.motion.front().begin_ns = std::max(part.motion.front().begin_ns, part.begin_ns);
  }
  std::erase_if(part.readings,
                [&](const RadioReading& reading) { return reading.heard_ns < time_ns; });
  std::erase_if(part.anchors,
                [&](const PositionAnchor& anchor) { return anchor.time_ns < time_ns; });
  return part;
}

}  // namespace walkgraph
