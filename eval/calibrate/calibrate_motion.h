#ifndef WALKGRAPH_EVAL_CALIBRATE_CALIBRATE_MOTION_H_
#define WALKGRAPH_EVAL_CALIBRATE_CALIBRATE_MOTION_H_

#include <vector>

#include "data/building.h"
#include "eval/calibrate/calibrated_values.h"
#include "factors/settings.h"

namespace walkgraph {

// Sets the noise of steps and headings, and the spread and random walk of their slow states, to
// what the walks show; where fewer than ten samples bear on a value it keeps its default and is not
// reported. Legs between consecutive waypoints (3 m or more apart) are compared with dead reckoning
// over the same time: the ratio of the two displacements, as a complex number, is the leg's step
// scale and heading offset.
//  - prior mean and sigma: mean and spread over walks of the walk's weighted mean;
//  - random walk: the squared difference of two legs of one walk is 2 noise + rate x time apart, a
//    straight line fitted over all pairs;
//  - heading increments: the same on the gyroscope alone, once each walk has lost a steady drift,
//    which is its bias and has a state of its own; with ten walks of a minute and more also the
//    random walk of that bias, whose part of the variance grows with the cube of the time;
//  - error of a step: how the squared error of a leg grows with its steps (what it does not grow
//    with is the waypoints' own); sideways from legs reckoned on the gyroscope, which has no
//    compass in it, against the legs before and after, and beside what their direction wanders;
//  - the absolute heading's sigma: what legs reckoned on it err beyond those on the gyroscope, as
//    independent samples `correlation_s` apart;
//  - spread of the gyroscope's bias, and the barometer: sensor_noise.h.
// Spreads are clipped at three robust standard deviations, so that a few wrong legs do not decide.
std::vector<CalibratedValue> CalibrateMotion(const Building& building,
                                             const std::vector<CalibrationWalk>& walks,
                                             FactorSettings* settings);

}  // namespace walkgraph

#endif  // WALKGRAPH_EVAL_CALIBRATE_CALIBRATE_MOTION_H_
