#include "eval/calibrate/leg_comparison.h"

#include <Eigen/QR>
#include <algorithm>
#include <cmath>
#include <complex>

#include "data/angle.h"

namespace walkgraph {
namespace {

constexpr double kMinLegM = 3.0;
constexpr double kMaxLagS = 40.0;
constexpr double kLongWalkS = 60.0;

int StepsBetween(const Evidence& evidence, TimeNs begin, TimeNs end) {
  return static_cast<int>(
      std::count_if(evidence.steps.begin(), evidence.steps.end(), [&](const StepEvidence& step) {
        const TimeNs middle = step.begin_ns + (step.end_ns - step.begin_ns) / 2;
        return middle >= begin && middle < end;
      }));
}

// Variance, over its rate, of a random walk's mean over a leg about the line between its means over
// the legs before and after, `later` being the share of the way from one to the other. (Means over
// neighbouring times a and b differ by (a + b) / 3, and both differences by b share -b / 6.)
double WanderBetween(const Leg& before, const Leg& leg, const Leg& after, double later) {
  const auto between = [](const Leg& from, const Leg& to) {
    const double both_s = from.duration_s + to.duration_s;
    const double gap_s = SecondsBetween(from.middle_ns, to.middle_ns) - both_s / 2;
    return both_s / 3 + gap_s;
  };
  const double earlier = 1.0 - later;
  return earlier * earlier * between(before, leg) + later * later * between(leg, after) -
         earlier * later * leg.duration_s / 3;
}

// Whether a leg begins at the waypoint at which the one before it ends.
bool Adjoin(const Leg& before, const Leg& leg) {
  constexpr double kRoundingS = 1e-3;
  const double apart_s = SecondsBetween(before.middle_ns, leg.middle_ns);
  return apart_s - (before.duration_s + leg.duration_s) / 2 < kRoundingS;
}

std::vector<double> SecondsOfLegs(const WalkLegs& legs) {
  std::vector<double> seconds;
  for (const Leg& leg : legs) {
    seconds.push_back(SecondsBetween(legs.front().middle_ns, leg.middle_ns));
  }
  return seconds;
}

// An angle of each leg, continued from leg to leg by the shorter way.
Eigen::VectorXd Unwrapped(const WalkLegs& legs, double Leg::*value) {
  Eigen::VectorXd angles(static_cast<Eigen::Index>(legs.size()));
  angles[0] = legs.front().*value;
  for (std::size_t i = 1; i < legs.size(); ++i) {
    const auto at = static_cast<Eigen::Index>(i);
    angles[at] = angles[at - 1] + WrapAngle(legs[i].*value - legs[i - 1].*value);
  }
  return angles;
}

// The projection that takes the straight line by least squares from values at these times. Least
// squares in an orthonormal basis, for which no times are too close.
Eigen::MatrixXd WithoutLine(const std::vector<double>& seconds) {
  const auto n = static_cast<Eigen::Index>(seconds.size());
  Eigen::MatrixXd line(n, 2);
  line.col(0).setOnes();
  line.col(1) = Eigen::Map<const Eigen::VectorXd>(seconds.data(), n);
  const Eigen::MatrixXd basis =
      line.householderQr().householderQ() * Eigen::MatrixXd::Identity(n, 2);
  return Eigen::MatrixXd::Identity(n, n) - basis * basis.transpose();
}

// Of a random walk of rate one that begins at the first time.
Eigen::MatrixXd RandomWalkCovariance(const std::vector<double>& seconds) {
  const auto n = static_cast<Eigen::Index>(seconds.size());
  return Eigen::MatrixXd::NullaryExpr(n, n, [&seconds](Eigen::Index i, Eigen::Index j) {
    return seconds[static_cast<std::size_t>(std::min(i, j))];
  });
}

// Of the integral of such a walk.
Eigen::MatrixXd IntegratedWalkCovariance(const std::vector<double>& seconds) {
  const auto n = static_cast<Eigen::Index>(seconds.size());
  return Eigen::MatrixXd::NullaryExpr(n, n, [&seconds](Eigen::Index i, Eigen::Index j) {
    const double first = seconds[static_cast<std::size_t>(std::min(i, j))];
    const double second = seconds[static_cast<std::size_t>(std::max(i, j))];
    return first * first * (3 * second - first) / 6;
  });
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
                    StepsBetween(evidence, from.time_ns, to.time_ns), std::atan2(leg.y(), leg.x()),
                    std::arg(ratio), std::log(std::abs(ratio))});
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

double ShareLeft(const Leg& leg, double correlation_s) {
  return 1.0 / std::max(1.0, leg.duration_s / correlation_s);
}

double VarianceOfWalkMean(const WalkLegs& legs, const LegError& error) {
  // Of the sum over legs of length times error at the end; length squared is a leg's weight.
  double variance = 0, weights = 0;
  for (std::size_t i = 0; i < legs.size(); ++i) {
    const Leg& leg = legs[i];
    const double weight = leg.length_m * leg.length_m;
    weights += weight;
    variance += weight * (error.waypoints_m2 + leg.steps * error.step_m2);
    variance += weight * weight * error.compass_rad2 * ShareLeft(leg, error.compass_correlation_s);
    if (i == 0 || !Adjoin(legs[i - 1], leg)) continue;
    const double turn = std::cos(leg.direction_rad - legs[i - 1].direction_rad);
    variance -= legs[i - 1].length_m * leg.length_m * error.waypoints_m2 * turn;
  }
  return variance / (weights * weights);
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

DriftFreeDifferences DifferencesWithoutDrift(const std::vector<WalkLegs>& walks,
                                             double Leg::*value) {
  DriftFreeDifferences all;
  for (const WalkLegs& legs : walks) {
    if (legs.size() < 3) continue;
    const std::vector<double> seconds = SecondsOfLegs(legs);
    const Eigen::MatrixXd residual = WithoutLine(seconds);
    const Eigen::VectorXd left = residual * Unwrapped(legs, value);
    const Eigen::MatrixXd wandered = residual * RandomWalkCovariance(seconds) * residual;
    const Eigen::MatrixXd drifted = residual * IntegratedWalkCovariance(seconds) * residual;
    if (seconds.back() >= kLongWalkS) ++all.long_walks;
    const auto between = [](const Eigen::MatrixXd& m, Eigen::Index i, Eigen::Index j) {
      return m(i, i) + m(j, j) - 2 * m(i, j);
    };
    for (Eigen::Index i = 0; i < left.size(); ++i) {
      for (Eigen::Index j = i + 1; j < left.size(); ++j) {
        if (seconds[static_cast<std::size_t>(j)] - seconds[static_cast<std::size_t>(i)] > kMaxLagS)
          break;
        all.difference.push_back(left[j] - left[i]);
        all.noise.push_back(between(residual, i, j));
        all.wander.push_back(between(wandered, i, j));
        all.bias.push_back(between(drifted, i, j));
      }
    }
  }
  return all;
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

LegDeviations DeviationsFromNeighbours(const std::vector<WalkLegs>& walks, double Leg::*value,
                                       bool circular) {
  LegDeviations deviations;
  const auto difference = [&](const Leg& from, const Leg& to) {
    const double plain = to.*value - from.*value;
    return circular ? WrapAngle(plain) : plain;
  };
  for (const WalkLegs& legs : walks) {
    for (std::size_t i = 1; i + 1 < legs.size(); ++i) {
      const Leg &before = legs[i - 1], &leg = legs[i], &after = legs[i + 1];
      const double span_s = SecondsBetween(before.middle_ns, after.middle_ns);
      if (span_s > kMaxLagS) continue;
      const double later = SecondsBetween(before.middle_ns, leg.middle_ns) / span_s;
      const double earlier = 1.0 - later;
      const double turned = difference(before, leg) - later * difference(before, after);
      // The neighbours' own errors, as the leg's length turns them into metres at its end.
      const double from_before = std::pow(earlier * leg.length_m / before.length_m, 2);
      const double from_after = std::pow(later * leg.length_m / after.length_m, 2);
      const double ends = 1.0 + from_before + from_after;
      deviations.deviation_m.push_back(leg.length_m * (circular ? WrapAngle(turned) : turned) /
                                       std::sqrt(ends));
      deviations.steps.push_back(
          (leg.steps + from_before * before.steps + from_after * after.steps) / ends);
      deviations.wander.push_back(leg.length_m * leg.length_m *
                                  WanderBetween(before, leg, after, later) / ends);
    }
  }
  return deviations;
}

}  // namespace walkgraph
