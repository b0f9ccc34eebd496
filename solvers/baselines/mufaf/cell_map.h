#ifndef WALKGRAPH_SOLVERS_BASELINES_MUFAF_CELL_MAP_H_
#define WALKGRAPH_SOLVERS_BASELINES_MUFAF_CELL_MAP_H_

#include <Eigen/Core>
#include <array>
#include <cstdint>
#include <string_view>
#include <vector>

namespace walkgraph {

// How a position is estimated from one radio's signals (TPE, the target positioning estimation).
enum class CellEstimator : std::uint8_t {
  kExponential,        // Nadaraya-Watson regression, K(x) = exp(-|x|)
  kGaussian,           // K(x) = exp(-x^2 / 2)
  kNearestNeighbours,  // mean of the nearest cells
  kEuclidean,          // nearest cell
  kMahalanobis,        // nearest cell, every anchor by its variance there
};
inline constexpr std::array<std::string_view, 5> kCellEstimatorNames = {
    "exponential", "gaussian", "knn", "euclidean", "mahalanobis"};

// Fingerprint cells of one radio: the signals of its anchors in each, a missing one at a fixed
// level.
class CellMap {
 public:
  explicit CellMap(Eigen::Index anchors) : anchors_(anchors) {}

  // A cell of `count` samples (>= 1) whose means and variances by anchor are given.
  void AddCell(const Eigen::Vector2d& center_m, const Eigen::VectorXd& mean_dbm,
               const Eigen::VectorXd& variance_db2, double count);
  // One more sample of a cell: its means are those of all its samples, or with a `memory` (> 0) of
  // about the last so many: a new one then has a share of 1 / memory at least.
  void AddSample(Eigen::Index cell, const Eigen::VectorXd& rssi_dbm, int memory);

  Eigen::Index size() const { return static_cast<Eigen::Index>(centers_m_.size()); }
  Eigen::Index anchors() const { return anchors_; }
  const std::vector<Eigen::Vector2d>& centers_m() const { return centers_m_; }
  // Anchors by cell: columns are cells.
  auto mean_dbm() const { return mean_dbm_.leftCols(size()); }
  auto variance_db2() const { return variance_db2_.leftCols(size()); }
  Eigen::Index NearestCell(const Eigen::Vector2d& position_m) const;

 private:
  Eigen::Index anchors_;
  std::vector<Eigen::Vector2d> centers_m_;
  Eigen::MatrixXd mean_dbm_, variance_db2_;  // with room for more cells
  std::vector<double> count_;
};

struct CellEstimatorSettings {
  CellEstimator estimator = CellEstimator::kExponential;
  double bandwidth_db = 0.8;
  int neighbours = 4;
};

// Where the signals were heard, by the cells but for `left_out` (-1: none). The regression weighs
// every cell by its kernel over the sum of all, z = sum w_l p_l: equations (4)-(6) of the MUFAF
// paper. Precondition: a cell is left.
Eigen::Vector2d EstimatePosition(const CellMap& map, const Eigen::VectorXd& rssi_dbm,
                                 const CellEstimatorSettings& settings, Eigen::Index left_out = -1);

// Mean error of the estimator, m: every cell's mean is placed by all other cells (our choice; the
// paper measures it by experiments). Too large rather than too small, by the spacing of the cells.
// At most `most` cells, evenly chosen. Precondition: two cells at least.
double LeaveOneCellOutError(const CellMap& map, const CellEstimatorSettings& settings,
                            Eigen::Index most);

}  // namespace walkgraph

#endif  // WALKGRAPH_SOLVERS_BASELINES_MUFAF_CELL_MAP_H_
