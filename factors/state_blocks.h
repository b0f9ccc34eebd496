#ifndef WALKGRAPH_FACTORS_STATE_BLOCKS_H_
#define WALKGRAPH_FACTORS_STATE_BLOCKS_H_

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <string_view>

#include "data/time.h"

namespace walkgraph {

// The unknowns of a walk. A node has a position, a heading and a height; the other kinds are slow
// states that live on knots of their own.
enum class BlockKind : std::uint8_t {
  kPosition,          // [2] m, building frame
  kHeading,           // [1] rad, direction of walking, unwrapped along the walk
  kGyroBias,          // [1] rad/s, what the gyroscope adds to the true rate of turn
  kHeadingOffset,     // [1] rad, direction of walking minus absolute heading
  kStepScale,         // [1] true over modelled step length
  kMapError,          // [2] m, where the radio map seems to be minus where one is
  kRssiOffset,        // [1] dB, the map's device minus this one; one block per radio
  kHeight,            // [1] m, of the feet in the building frame
  kMagneticError,     // [2] m, the same of the magnetic map
  kBarometricOffset,  // [1] m, height by the barometer minus height: weather, device, altitude
};
inline constexpr int kBlockKindCount = 10;
inline constexpr int kMaxBlockSize = 2;

constexpr int BlockSize(BlockKind kind) {
  return kind == BlockKind::kPosition || kind == BlockKind::kMapError ||
                 kind == BlockKind::kMagneticError
             ? 2
             : 1;
}

constexpr bool IsSlowState(BlockKind kind) {
  return kind != BlockKind::kPosition && kind != BlockKind::kHeading && kind != BlockKind::kHeight;
}

// Name of the state with its unit, as outputs write it.
constexpr std::string_view BlockName(BlockKind kind) {
  constexpr std::string_view kNames[kBlockKindCount] = {
      "position_m",       "heading_rad",        "gyro_bias_radps", "heading_offset_rad",
      "step_scale",       "map_error_m",        "rssi_offset_db",  "height_m",
      "magnetic_error_m", "barometric_offset_m"};
  return kNames[static_cast<int>(kind)];
}

// A block's name in the graph: its kind and the index of the node, the knot or (kRssiOffset) the
// radio.
struct BlockId {
  BlockKind kind = BlockKind::kPosition;
  int index = 0;
  bool operator==(const BlockId&) const = default;
};

// Equidistant knots of a slow state. The state is piecewise constant: knot k holds from Time(k) to
// Time(k + 1), the last one to the end.
class Knots {
 public:
  // Precondition: spacing_s > 0 and end_ns >= begin_ns.
  Knots(TimeNs begin_ns, TimeNs end_ns, double spacing_s)
      : begin_ns_(begin_ns),
        spacing_ns_(std::max<TimeNs>(1, DurationNs(spacing_s))),
        count_(static_cast<int>(
            std::max<TimeNs>(1, (end_ns - begin_ns + spacing_ns_ - 1) / spacing_ns_))) {}

  int count() const { return count_; }
  TimeNs Time(int knot) const { return begin_ns_ + knot * spacing_ns_; }
  // The knot that holds at a time, clamped at the ends.
  int At(TimeNs time_ns) const {
    if (time_ns <= begin_ns_) return 0;
    return static_cast<int>(std::min<TimeNs>(count_ - 1, (time_ns - begin_ns_) / spacing_ns_));
  }

 private:
  TimeNs begin_ns_;
  TimeNs spacing_ns_;
  int count_;
};

}  // namespace walkgraph

#endif  // WALKGRAPH_FACTORS_STATE_BLOCKS_H_
