#ifndef WALKGRAPH_SOLVERS_BASELINES_FLOOR_MODEL_H_
#define WALKGRAPH_SOLVERS_BASELINES_FLOOR_MODEL_H_

#include <Eigen/Core>
#include <optional>
#include <vector>

#include "factors/settings.h"
#include "frontends/evidence/evidence.h"
#include "frontends/radio_map/barometric_history.h"
#include "frontends/radio_map/site.h"

namespace walkgraph {

// The hidden Markov model behind TrackFloors: which floor, or the way between two, and how far the
// barometer is off, on a grid. Time goes in epochs.
class FloorModel {
 public:
  static constexpr double kEpochS = 2.0;  // from one epoch to the next, s

  // A distribution, or a likelihood: a column for each floor and a last one for "between", a row
  // for each cell of the offset (one alone where no barometer takes part or its offset is known).
  using Belief = Eigen::MatrixXd;

  // Keeps references to the evidence and the settings. `log_prior`: of each floor, nats.
  FloorModel(const Site& site, const Evidence& evidence, const FactorSettings& settings,
             std::vector<int> floors, Eigen::VectorXd log_prior);

  // Before anything was heard.
  Belief Start() const;
  // One epoch on.
  Belief Predict(const Belief& belief) const;
  // The transpose: what a later epoch's likelihoods say about the one before.
  Belief Retrodict(const Belief& likelihood) const;
  // Likelihood of an epoch's pressure, up to a factor; ones where nothing was measured.
  Belief OfPressure(std::optional<double> height_m) const;
  // The barometer's last height at a time, where it still ran.
  std::optional<double> HeightAt(TimeNs time_ns) const;

  Eigen::Index Columns() const { return static_cast<Eigen::Index>(floors_.size()) + 1; }

 private:
  void LayOutCells();
  Eigen::VectorXd OffsetPriorOfCells() const;
  Belief Drift(const Belief& belief) const;
  Eigen::MatrixXd MixMatrix() const;

  const Evidence& evidence_;
  const FactorSettings& settings_;
  std::optional<OffsetPrior> offset_prior_;
  std::vector<int> floors_;
  Eigen::VectorXd log_prior_;      // by floor
  std::vector<double> heights_m_;  // by floor
  double lowest_m_ = 0, highest_m_ = 0;
  double first_m_ = 0, cell_m_;  // the first offset of the grid, and its spacing
  int cells_ = 1;
  bool measured_ = false;  // a barometer takes part
};

}  // namespace walkgraph

#endif  // WALKGRAPH_SOLVERS_BASELINES_FLOOR_MODEL_H_
