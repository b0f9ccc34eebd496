#include "solvers/baselines/hipe_motion.h"

#include <algorithm>
#include <cmath>

#include "data/angle.h"

namespace walkgraph {
namespace {

// Distance walked and the direction of its sum, over the share of each step in the interval.
struct WalkedSum {
  double distance_m = 0;
  Eigen::Vector2d displacement_m = Eigen::Vector2d::Zero();
};

WalkedSum SumSteps(const Evidence& evidence, const DeadReckonedPath& path, double step_scale,
                   TimeNs begin_ns, TimeNs end_ns, double constant_length_m) {
  WalkedSum sum;
  for (const StepEvidence& step : evidence.steps) {
    const double duration_s = SecondsBetween(step.begin_ns, step.end_ns);
    const double inside_s =
        SecondsBetween(std::max(begin_ns, step.begin_ns), std::min(end_ns, step.end_ns));
    if (inside_s <= 0 || duration_s <= 0) continue;
    const double length_m = constant_length_m > 0 ? constant_length_m : step_scale * step.length_m;
    const double walked_m = length_m * inside_s / duration_s;
    const double heading = path.HeadingAt(step.begin_ns + (step.end_ns - step.begin_ns) / 2);
    sum.distance_m += walked_m;
    sum.displacement_m += walked_m * DirectionOf(heading);
  }
  return sum;
}

double MeanHeading(const DeadReckonedPath& path, TimeNs begin_ns, TimeNs end_ns) {
  constexpr int kSamples = 16;
  double sum = 0;
  for (int i = 0; i < kSamples; ++i) {
    sum += path.HeadingAt(begin_ns + (end_ns - begin_ns) * (2 * i + 1) / (2 * kSamples));
  }
  return sum / kSamples;  // the stream is unwrapped
}

bool NeedsHeading(HipeCase motion_case) {
  return motion_case == HipeCase::kDistanceHeading || motion_case == HipeCase::kHeadingSpeed;
}
bool NeedsDistance(HipeCase motion_case) {
  return motion_case == HipeCase::kDistanceHeading || motion_case == HipeCase::kDistance;
}

}  // namespace

bool IsConsistent(const MotionInformation& motion, double distance_m, double direction_rad) {
  if (motion.distance_m) {
    if (std::abs(distance_m - *motion.distance_m) >= motion.distance_tolerance_m) return false;
  } else if (distance_m >= motion.range_m && distance_m > 0) {
    return false;
  }
  if (!motion.heading_rad || distance_m == 0) return true;
  return std::abs(WrapAngle(direction_rad - *motion.heading_rad)) < motion.heading_tolerance_rad;
}

MotionInformation MeasureMotion(const Evidence& evidence, const DeadReckonedPath& path,
                                double step_scale, TimeNs begin_ns, TimeNs end_ns, double spacing_m,
                                const HipeMotionSettings& settings) {
  MotionInformation motion;
  const WalkedSum walked =
      SumSteps(evidence, path, step_scale, begin_ns, end_ns, settings.step_length_m);
  const bool has_distance = NeedsDistance(settings.motion_case);
  if (has_distance) {
    motion.distance_m = walked.distance_m;
    motion.distance_tolerance_m =
        std::max(settings.tolerance_share * walked.distance_m, spacing_m / 2);
  } else {
    motion.range_m = settings.max_speed_mps * SecondsBetween(begin_ns, end_ns);
  }
  if (NeedsHeading(settings.motion_case) && path.source == HeadingSource::kAbsolute) {
    motion.heading_rad = has_distance && walked.displacement_m.norm() > 0
                             ? std::atan2(walked.displacement_m.y(), walked.displacement_m.x())
                             : MeanHeading(path, begin_ns, end_ns);
    motion.heading_tolerance_rad = settings.heading_tolerance_rad;
  }
  return motion;
}

TransitionRows HipeTransition(const ConsistentPairs& pairs, double k) {
  TransitionRows rows;
  const std::size_t n = pairs.begin.size() - 1;
  rows.begin = pairs.begin;
  rows.elsewhere.reserve(n);
  rows.entries.reserve(pairs.to.size());
  for (std::size_t i = 0; i < n; ++i) {
    const auto consistent = static_cast<double>(pairs.begin[i + 1] - pairs.begin[i]);
    const double low = 1 / (static_cast<double>(n) + (k - 1) * consistent);
    rows.elsewhere.push_back(low);
    for (std::size_t e = pairs.begin[i]; e < pairs.begin[i + 1]; ++e) {
      rows.entries.push_back({pairs.to[e], k * low});
    }
  }
  return rows;
}

ReferencePairs::ReferencePairs(const ReferencePoints& points, std::span<const Polygon> obstacles,
                               HipeDistance distance, double max_distance_m)
    : points_(points), distance_(distance) {
  if (distance_ == HipeDistance::kWalkable) {
    ways_ = FindWalkableWays(points, obstacles, max_distance_m);
    return;
  }
  const int reach = static_cast<int>(max_distance_m / points.spacing_m());
  for (int row = -reach; row <= reach; ++row) {
    for (int column = -reach; column <= reach; ++column) {
      const double distance_m = points.spacing_m() * std::hypot(column, row);
      if (distance_m > max_distance_m) continue;
      offsets_.push_back({{column, row}, distance_m, std::atan2(row, column)});
    }
  }
}

ConsistentPairs ReferencePairs::Find(const MotionInformation& motion) const {
  ConsistentPairs pairs;
  std::vector<ReferencePoints::Cell> consistent;
  for (const Offset& offset : offsets_) {
    if (IsConsistent(motion, offset.distance_m, offset.direction_rad)) {
      consistent.push_back(offset.cell);
    }
  }
  for (std::size_t i = 0; i < points_.size(); ++i) {
    const ReferencePoints::Cell& from = points_.cell(i);
    for (const ReferencePoints::Cell& offset : consistent) {
      const int to = points_.IndexAt({from.column + offset.column, from.row + offset.row});
      if (to >= 0) pairs.to.push_back(to);
    }
    if (distance_ == HipeDistance::kWalkable) {
      for (const WalkableWay& way : ways_[i]) {
        if (IsConsistent(motion, way.distance_m, way.direction_rad)) pairs.to.push_back(way.to);
      }
    }
    pairs.begin.push_back(pairs.to.size());
  }
  return pairs;
}

}  // namespace walkgraph
