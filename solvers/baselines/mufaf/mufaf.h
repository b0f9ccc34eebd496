#ifndef WALKGRAPH_SOLVERS_BASELINES_MUFAF_MUFAF_H_
#define WALKGRAPH_SOLVERS_BASELINES_MUFAF_MUFAF_H_

#include <cstdint>
#include <string_view>
#include <vector>

#include "factors/settings.h"
#include "solvers/baselines/description.h"
#include "solvers/baselines/mufaf/cell_map.h"
#include "solvers/baselines/mufaf/map_update.h"
#include "solvers/baselines/mufaf/site_cells.h"
#include "solvers/baselines/wknn.h"
#include "solvers/estimator.h"

namespace walkgraph {

struct MufafSettings {
  double cell_m = 3;
  double bandwidth_db = 0.8;
  int neighbours = 4;
  double window_s = 1;
  double acceleration_sigma_mps2 = 1;
  double input_mps2 = 0;
  double alpha = 0.3;
  double fix_error_m = 0;
  MapUpdateSettings update = SiteMapUpdate();
};

template <typename Visitor>
void Visit(Visitor& v, MufafSettings& s) {
  v.Field("cell_m", s.cell_m, "survey scans in a square of this side are a fingerprint cell, m");
  v.Field("bandwidth_db", s.bandwidth_db, "h of the kernels, dB (the paper's 0.8, without a unit)");
  v.Field("neighbours", s.neighbours, "cells that the nearest-neighbour estimate averages");
  v.Field("window_s", s.window_s, "radios that report within this are fused, s (the paper's)");
  v.Field("acceleration_sigma_mps2", s.acceleration_sigma_mps2,
          "white acceleration of the tracks, m/s^2 (the paper's)");
  v.Field("input_mps2", s.input_mps2,
          "known acceleration along +x and +y, m/s^2: 0.1 as printed pushes every walk there");
  v.Field("alpha", s.alpha, "of the last smoothing (the paper: up to 0.3); 0 leaves it out");
  v.Field("fix_error_m", s.fix_error_m,
          "error of a radio's fix per axis, m; 0 takes the mean error of placing cells by others");
  v.Group("update", s.update);
}

enum class MufafStage : std::uint8_t {
  kEstimate,     // TPE of one radio
  kTrack,        // and its Kalman filter
  kTrackFusion,  // TTTF: a filter per radio, fused
  kGroupFusion,  // KSGF: one filter of all
};

struct MufafMethod {
  CellEstimator estimator = CellEstimator::kExponential;
  MufafStage stage = MufafStage::kGroupFusion;
  MethodDescription description;
};

inline constexpr std::string_view kMufafSource =
    "Multi-sensor fusion with adaptive fingerprint (MUFAF), Belmonte-Hernandez et al.";
inline constexpr std::string_view kMufafCells =
    "cells: squares of the survey's scans (there: visited cells); a missing anchor at the level of "
    "wknn in cell and scan. Of the radios switched on and surveyed the first. Linear in time "
    "between scans; no covariance";
inline constexpr std::string_view kMufafTracks =
    "cells as mufaf_exponential. Radios within a second of each other are one epoch. R: the error "
    "of placing every cell by the others. Starts at the first fix, at rest. Default u = 0, for "
    "0.1 as printed pushes all walks to +x+y. Linear in time; the covariance is the filter's";

// Every one of them, in the order of the paper's figures.
inline constexpr MufafMethod kMufafMethods[] = {
    {CellEstimator::kExponential,
     MufafStage::kEstimate,
     {"mufaf_exponential", "kernel regression over cells, exponential kernel", kMufafSource,
      kMufafCells}},
    {CellEstimator::kGaussian,
     MufafStage::kEstimate,
     {"mufaf_gaussian", "kernel regression over cells, Gaussian kernel", kMufafSource,
      kMufafCells}},
    {CellEstimator::kNearestNeighbours,
     MufafStage::kEstimate,
     {"mufaf_knn", "mean of the nearest cells in signal space", kMufafSource, kMufafCells}},
    {CellEstimator::kEuclidean,
     MufafStage::kEstimate,
     {"mufaf_euclidean", "nearest cell in signal space", kMufafSource, kMufafCells}},
    {CellEstimator::kMahalanobis,
     MufafStage::kEstimate,
     {"mufaf_mahalanobis", "nearest cell, every anchor by its variance there", kMufafSource,
      kMufafCells}},
    {CellEstimator::kExponential,
     MufafStage::kTrack,
     {"mufaf_kalman", "mufaf_exponential tracked by a Kalman filter at constant velocity",
      kMufafSource, kMufafTracks}},
    {CellEstimator::kExponential,
     MufafStage::kTrackFusion,
     {"mufaf_tttf", "a track per radio, fused, then an alpha-beta filter", kMufafSource,
      kMufafTracks}},
    {CellEstimator::kExponential,
     MufafStage::kGroupFusion,
     {"mufaf_ksgf", "all radios in one Kalman filter, then an alpha-beta filter", kMufafSource,
      kMufafTracks}},
};

// MUFAF and its stages. TTTF's covariance is too small under more than one radio (see FuseTracks).
// Unobservable where nobody heard an anchor.
class MufafEstimator : public Estimator {
 public:
  MufafEstimator(const MufafMethod& method, const MufafSettings& settings, const WknnSettings& wknn,
                 const FactorSettings& factors)
      : method_(method), settings_(settings), wknn_(wknn), factors_(factors) {}
  std::string_view name() const override { return method_.description.name; }
  EstimateResult Estimate(const Site& site, const Evidence& evidence) const override;

 private:
  // Of one radio's positions, per axis.
  double FixError(const CellMap& cells, const CellEstimatorSettings& estimator) const;

  MufafMethod method_;
  MufafSettings settings_;
  WknnSettings wknn_;
  FactorSettings factors_;
};

}  // namespace walkgraph

#endif  // WALKGRAPH_SOLVERS_BASELINES_MUFAF_MUFAF_H_
