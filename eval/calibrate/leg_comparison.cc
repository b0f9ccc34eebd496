#include "eval/calibrate/leg_comparison.h"

#include <algorithm>
#include <cmath>
#include <complex>

#include "data/angle.h"

namespace walkgraph {
namespace {

constexpr double kMinLegM = 3.0;
constexpr double kMaxLagS = 40.0;

int StepsBetween(const Evidence& evidence, TimeNs begin, TimeNs end) {
  return static_cast<int>(
      std::count_if(evidence.steps.begin(), evidence.steps.end(), [&](const StepEvidence& step) {
        const TimeNs middle = step.begin_ns + (step.end_ns - step.begin_ns) / 2;
        return middle >= begin && middle < end;
      }));
}

}  // namespace

WalkLegs CompareLegs(const Evidence& evidence, const Truth& truth, const DeadReckonedPath& path) {
  WalkLegs legs;
  for (std::size_t i = 1; i < truth.waypoints.size(); ++i) {
    const Waypoint& from = truth.waypoints[i - 1];
    const Waypoint& to = truth.waypoints[i];
    const Eigen::Vector2d leg = to.position - from.position;
    const Eigen::Vector2d walked = path.PositionAt(to.time_ns) - path.PositionAt(from.time_ns);
    if (leg.norm() < kMinLegM || walked.norm() < 0.5 * kMinLegM) continue;
    const std::complex<double> ratio =
        std::complex<double>(leg.x(), leg.y()) / std::complex<double>(walked.x(), walked.y());
    legs.push_back({from.time_ns + (to.time_ns - from.time_ns) / 2,
                    SecondsBetween(from.time_ns, to.time_ns), leg.norm(),
                    StepsBetween(evidence, from.time_ns, to.time_ns), std::arg(ratio),
                    std::log(std::abs(ratio))});
  }
  return legs;
}

double WalkMean(const WalkLegs& legs, double Leg::*value, bool circular) {
  double weights = 0, sum = 0;
  std::complex<double> turn = 0;
  for (const Leg& leg : legs) {
    const double weight = leg.length_m * leg.length_m;
    weights += weight;
    sum += weight * leg.*value;
    turn += std::polar(weight, leg.*value);
  }
  return circular ? std::arg(turn) : sum / weights;
}

PairDifferences DifferencesWithinWalks(const std::vector<WalkLegs>& walks, double Leg::*value,
                                       bool circular) {
  PairDifferences pairs;
  for (const WalkLegs& legs : walks) {
    for (std::size_t i = 0; i < legs.size(); ++i) {
      for (std::size_t j = i + 1; j < legs.size(); ++j) {
        const double lag = SecondsBetween(legs[i].middle_ns, legs[j].middle_ns);
        if (lag > kMaxLagS) break;
        const double difference = legs[j].*value - legs[i].*value;
        pairs.difference.push_back(circular ? WrapAngle(difference) : difference);
        pairs.lag_s.push_back(lag);
      }
    }
  }
  return pairs;
}

LegDeviations DeviationsFromWalk(const std::vector<WalkLegs>& walks, double Leg::*value,
                                 bool circular) {
  LegDeviations deviations;
  for (const WalkLegs& legs : walks) {
    if (legs.size() < 3) continue;
    const double mean = WalkMean(legs, value, circular);
    double total = 0;
    for (const Leg& leg : legs) total += leg.length_m * leg.length_m;
    for (const Leg& leg : legs) {
      const double difference = leg.*value - mean;
      // The leg's own share of the mean hides that part of its error.
      const double visible = 1.0 - leg.length_m * leg.length_m / total;
      deviations.deviation_m.push_back(
          leg.length_m * (circular ? WrapAngle(difference) : difference) / std::sqrt(visible));
      deviations.steps.push_back(leg.steps);
    }
  }
  return deviations;
}

}  // namespace walkgraph
