#ifndef WALKGRAPH_SOLVERS_BASELINES_DSFF_DSFF_H_
#define WALKGRAPH_SOLVERS_BASELINES_DSFF_DSFF_H_

#include <string>
#include <string_view>
#include <vector>

#include "factors/settings.h"
#include "solvers/baselines/description.h"
#include "solvers/baselines/dsff/motion.h"
#include "solvers/baselines/dsff/tracker.h"
#include "solvers/baselines/wknn.h"
#include "solvers/estimator.h"

namespace walkgraph {

// Which sensors learn their errors, and which are replaced by the truth.
struct DsffVariant {
  bool moves = true;  // else the absolute evidence alone
  bool learns_distance = false, learns_heading = false, learns_height = false;
  TrueSensors truth;
  // Its sensor tells nothing where there is one floor.
  bool needs_floors() const {
    return (learns_height && !learns_heading) || (truth.height && !truth.heading);
  }
};

struct DsffMethod {
  DsffVariant variant;
  MethodDescription description;
};

inline constexpr std::string_view kDsffSource =
    "Dynamic Sensor Fusion Framework (DSFF), error blocks in a hidden Markov model";
inline constexpr std::string_view kDsffChoices =
    "cells: within 20 m of a survey path, as of viterbi. Densities of signals: the site's radio "
    "map "
    "at the cell, weighted by n_eff as in the graph; with several floors joined with what scans "
    "say of the floors. Epochs: Wi-Fi scans, 10 s apart at most. Way between two: straight, of the "
    "shared steps (calibrated scale) along the integrated gyroscope, which agrees with the compass "
    "(calibrated mean offset) in the mean over the walk. Staying has the mean of a fan over the "
    "circle. Sigmas of distance and heading: calibrated, with the cells' share. Height by the "
    "barometer from the first epoch, which is tried on every floor; the likeliest trace wins. "
    "Where no way leads to an epoch all cells follow the best one. Linear in time between epochs; "
    "the k - 1 next traces are hypotheses; no covariance";
inline constexpr std::string_view kDsffTruthChoices =
    "as dsff_hmm, but KNOWS THE TRUTH of the sensor named: what a perfect one would be worth, no "
    "competitor. Truth: by walked distance between surveyed waypoints; unsupported without any";

// Every one of them, in the order of the paper's tables.
inline constexpr DsffMethod kDsffMethods[] = {
    {{false, false, false, false, {}},
     {"dsff_absolute", "DSFF's Wi-Fi and magnetic map alone, epoch by epoch", kDsffSource,
      kDsffChoices}},
    {{true, false, false, false, {}},
     {"dsff_hmm", "DSFF without error blocks: ring, fan and bar as measured", kDsffSource,
      kDsffChoices}},
    {{true, false, false, false, {true, false, false}},
     {"dsff_true_distance", "HMM+: dsff_hmm told the distance", kDsffSource, kDsffTruthChoices}},
    {{true, false, false, false, {false, true, false}},
     {"dsff_true_heading", "HMM+: dsff_hmm told the heading", kDsffSource, kDsffTruthChoices}},
    {{true, false, false, false, {true, true, false}},
     {"dsff_true_both", "HMM+: dsff_hmm told distance and heading", kDsffSource,
      kDsffTruthChoices}},
    {{true, false, false, false, {false, false, true}},
     {"dsff_true_pressure", "HMM+: dsff_hmm told the height", kDsffSource, kDsffTruthChoices}},
    {{true, false, false, false, {true, true, true}},
     {"dsff_true_all", "HMM+: dsff_hmm told distance, heading and height", kDsffSource,
      kDsffTruthChoices}},
    {{true, true, false, false, {}},
     {"dsff_distance", "DSFF with error blocks for the distance", kDsffSource, kDsffChoices}},
    {{true, false, true, false, {}},
     {"dsff_heading", "DSFF with error blocks for the heading", kDsffSource, kDsffChoices}},
    {{true, true, true, false, {}},
     {"dsff_both", "DSFF with error blocks for distance and heading", kDsffSource, kDsffChoices}},
    {{true, false, false, true, {}},
     {"dsff_pressure", "DSFF with error blocks for the pressure", kDsffSource, kDsffChoices}},
    {{true, true, true, true, {}},
     {"dsff", "DSFF with error blocks for distance, heading and pressure", kDsffSource,
      kDsffChoices}},
};

// DSFF, its parts and its bounds. Unsupported without accelerometer, gyroscope or absolute heading
// (but for dsff_absolute), without barometer where the floor is not known, without truth where it
// is asked for. Its slow states are the error blocks' mean and spread at every epoch.
class DsffEstimator : public Estimator {
 public:
  DsffEstimator(const DsffMethod& method, const DsffSettings& settings, const WknnSettings& wknn,
                const FactorSettings& factors)
      : method_(method), settings_(settings), wknn_(wknn), factors_(factors) {}
  std::string_view name() const override { return method_.description.name; }
  bool uses_truth() const override { return method_.variant.truth.any(); }
  EstimateResult Estimate(const Site& site, const Evidence& evidence) const override;
  EstimateResult EstimateKnowing(const Trajectory& truth, const Site& site,
                                 const Evidence& evidence) const override;

 private:
  // What the walk lacks; empty where it has everything.
  std::string Lack(const Evidence& evidence, const DsffCells& cells) const;
  RelativeSensors MakeSensors(const std::vector<DsffMotion>& motion) const;
  DsffTrack Track(const Site& site, const DsffCells& cells, const AbsoluteEvidence& absolute,
                  const std::vector<DsffMotion>& motion) const;
  EstimateResult Locate(const Site& site, const Evidence& evidence, const DsffCells& cells,
                        const Trajectory& truth) const;

  DsffMethod method_;
  DsffSettings settings_;
  WknnSettings wknn_;
  FactorSettings factors_;
};

}  // namespace walkgraph

#endif  // WALKGRAPH_SOLVERS_BASELINES_DSFF_DSFF_H_
