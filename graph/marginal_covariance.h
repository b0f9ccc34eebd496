#ifndef WALKGRAPH_GRAPH_MARGINAL_COVARIANCE_H_
#define WALKGRAPH_GRAPH_MARGINAL_COVARIANCE_H_

#include <Eigen/Core>
#include <optional>
#include <utility>
#include <vector>

#include "graph/linear_system.h"

namespace walkgraph {

struct BlockElimination;

// What is known about one block, or about two blocks stacked.
struct BlockMarginal {
  // Square, in the units of the block. Where directions are unobservable it is the covariance of
  // the part orthogonal to them, so that it stays finite and does not depend on a choice of gauge.
  Eigen::MatrixXd covariance;
  // Directions of infinite variance, orthonormal columns; no columns where all is observable.
  Eigen::MatrixXd unobservable;

  bool observable() const { return unobservable.cols() == 0; }
};

// The diagonal blocks of H^-1, H = sum of J^T J, and chosen off-diagonal ones, without ever forming
// the dense inverse: block QR in a fill-reducing order (graph/block_elimination.h), then the
// selected inverse from the last block eliminated to the first (Takahashi, Fagan and Chen 1973).
// Working on J instead of H keeps half of the digits that the normal equations lose, and every
// covariance is a sum of positive semi-definite terms, so that no variance turns out negative.
//
// Rank-deficient systems are answered, not refused: see BlockMarginal.
class MarginalCovariance {
 public:
  // `pairs`: blocks whose joint covariance will be asked for; pairs that share a factor need not be
  // named. Nothing is returned if a Jacobian or residual is not finite. Throws
  // std::invalid_argument on a malformed system (see CheckShapes) or pair.
  static std::optional<MarginalCovariance> Compute(
      const LinearSystem& system, const std::vector<std::pair<int, int>>& pairs = {});

  // Number of independent unobservable directions of the whole system.
  int nullity() const { return nullity_; }
  // log det H; none if the system is rank-deficient.
  std::optional<double> log_determinant() const;

  const BlockMarginal& block(int index) const { return blocks_[index]; }
  // The joint of two different blocks, `first` on top. None if they neither share a factor nor were
  // named in `pairs`.
  std::optional<BlockMarginal> Joint(int first, int second) const;

 private:
  // A front of the elimination: one block and those that it was conditioned on.
  struct Front {
    std::vector<int> blocks;
    std::vector<int> offsets;    // row of each block
    Eigen::MatrixXd finite;      // covariance with the unobservable variables held
    Eigen::MatrixXd divergence;  // growth of the covariance with their variance; empty if none
  };
  MarginalCovariance() = default;
  void InvertFronts(const BlockElimination& elimination);
  void ReadBlocks();
  int Size(int block) const { return column_offsets_[block + 1] - column_offsets_[block]; }

  std::vector<Front> fronts_;  // by block
  std::vector<int> position_;  // in the order of elimination, by block
  std::vector<BlockMarginal> blocks_;
  Eigen::VectorXd scale_;  // square root of the diagonal of H, by column
  std::vector<int> column_offsets_;
  double divergence_threshold_ = 0;
  double log_determinant_ = 0;
  int nullity_ = 0;
};

}  // namespace walkgraph

#endif  // WALKGRAPH_GRAPH_MARGINAL_COVARIANCE_H_
