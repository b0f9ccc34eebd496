#ifndef WALKGRAPH_EVAL_CALIBRATE_LEG_COMPARISON_H_
#define WALKGRAPH_EVAL_CALIBRATE_LEG_COMPARISON_H_

#include <cstddef>
#include <vector>

#include "data/truth.h"
#include "factors/dead_reckoning.h"
#include "frontends/evidence/evidence.h"

namespace walkgraph {

// A leg between two waypoints against dead reckoning over the same time.
struct Leg {
  TimeNs middle_ns = 0;
  double duration_s = 0;
  double length_m = 0;  // between the waypoints
  int steps = 0;
  double direction_rad = 0;  // true, in the building
  double heading_rad = 0;    // true minus dead-reckoned direction
  double log_scale = 0;      // log of true over dead-reckoned distance
};

using WalkLegs = std::vector<Leg>;

// Legs of 3 m and more along which dead reckoning moved at all.
WalkLegs CompareLegs(const Evidence& evidence, const Truth& truth, const DeadReckonedPath& path);

// The mean of a walk's legs, weighted by their squared length; of angles on the circle.
// Precondition: not empty.
double WalkMean(const WalkLegs& legs, double Leg::*value, bool circular);

// Variances of the end of a leg against its beginning, along or across it: by its two waypoints,
// and by each of its steps. And of its direction, by a compass that errs anew after the correlation
// time.
struct LegError {
  double waypoints_m2 = 0;
  double step_m2 = 0;
  double compass_rad2 = 0;
  double compass_correlation_s = 1;
};

// What the mean over a leg leaves of the variance of an error that is drawn anew after a time.
double ShareLeft(const Leg& leg, double correlation_s);

// What these errors make of the variance of WalkMean. A waypoint moves the end of one leg and the
// beginning of the next, which cancels where the way goes straight on.
double VarianceOfWalkMean(const WalkLegs& legs, const LegError& error);

// Differences of all pairs of legs of one walk up to 40 s apart: farther ones are many and say
// little more.
struct PairDifferences {
  std::vector<double> difference;
  std::vector<double> lag_s;
};
PairDifferences DifferencesWithinWalks(const std::vector<WalkLegs>& walks, double Leg::*value,
                                       bool circular);

// The same of angles after each walk has lost the straight line through its legs' values over time:
// no steady bias of a gyroscope is left in it. Only walks of three legs and more. The variance of a
// difference is `noise` times that of one leg's value (equal and independent) plus `wander` times
// the rate of a random walk of the value plus `bias` times that of a random walk of the value's
// drift, as the lost line leaves them.
struct DriftFreeDifferences {
  std::vector<double> difference;
  std::vector<double> noise;
  std::vector<double> wander;  // s
  std::vector<double> bias;    // s^3
  std::size_t long_walks = 0;  // of a minute and more, which tell a drift that changes from turns
};
DriftFreeDifferences DifferencesWithoutDrift(const std::vector<WalkLegs>& walks,
                                             double Leg::*value);

// What a leg's value deviates from its walk's mean, in metres at the leg's end, with the number of
// steps that it took. Only walks of three legs and more; corrected for the mean that the legs
// themselves made.
struct LegDeviations {
  std::vector<double> deviation_m;
  std::vector<double> steps;
  std::vector<double> wander;  // see DeviationsFromNeighbours
};
LegDeviations DeviationsFromWalk(const std::vector<WalkLegs>& walks, double Leg::*value,
                                 bool circular);

// The same against the legs before and after, interpolated by time: neither what a walk's legs
// share nor a steady drift is in it. With c + s n the variance of the end of a leg of n steps, and
// r the rate at which the value wanders, that of a deviation is c + s `steps` + r `wander` (m^2 per
// rate).
LegDeviations DeviationsFromNeighbours(const std::vector<WalkLegs>& walks, double Leg::*value,
                                       bool circular);

}  // namespace walkgraph

#endif  // WALKGRAPH_EVAL_CALIBRATE_LEG_COMPARISON_H_
