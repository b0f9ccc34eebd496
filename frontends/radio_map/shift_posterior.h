#ifndef WALKGRAPH_FRONTENDS_RADIO_MAP_SHIFT_POSTERIOR_H_
#define WALKGRAPH_FRONTENDS_RADIO_MAP_SHIFT_POSTERIOR_H_

#include <Eigen/Core>
#include <cstddef>
#include <map>
#include <vector>

namespace walkgraph {

// How well a map places a piece of a walk whose place is known: the posterior of a shift common to
// all of the piece, whose density at zero is a proper score.

// Shifts about the truth, each standing for a square cell.
class ShiftGrid {
 public:
  // (2 half_count + 1)^2 cells of `spacing_m`. Those at most `refined_half_count` from the middle
  // are cut into `parts` x `parts`, an odd number: a map may be far off, and it may be sharp.
  ShiftGrid(double spacing_m, int half_count, int refined_half_count = -1, int parts = 1);

  // The lattices that the shifts are taken from, parallel to the axes and about zero: all places
  // but those at most `hole_half_count` from the middle, row by row, one lattice after the other.
  struct Lattice {
    double spacing_m = 0;
    int half_count = 0;
    int hole_half_count = -1;
    int side() const { return 2 * half_count + 1; }
  };
  const std::vector<Lattice>& lattices() const { return lattices_; }
  // Numbers by shift from those at all places of each lattice.
  Eigen::ArrayXd Join(const std::vector<Eigen::ArrayXd>& by_lattice) const;

  std::size_t size() const { return shifts_m_.size(); }
  const Eigen::Vector2d& At(std::size_t index) const { return shifts_m_[index]; }
  const Eigen::ArrayXd& area_m2() const { return area_m2_; }  // by shift

 private:
  struct Place {
    std::size_t lattice = 0;
    Eigen::Index index = 0;
  };
  std::vector<Lattice> lattices_;
  std::vector<Place> places_;  // of the shifts
  std::vector<Eigen::Vector2d> shifts_m_;
  Eigen::ArrayXd area_m2_;
};

// The normal density of an error of the map that the whole piece shares, over the shifts,
// normalised over the grid, so that a sigma below its spacing stays a density.
class SharedErrorKernel {
 public:
  SharedErrorKernel(const ShiftGrid& grid, double sigma_m);

  // log of the density (1/m^2) that a posterior (probability by shift), blurred by the error, gives
  // to shift zero. A small chance of being lost bounds it from below.
  double LogScoreAtTruth(const Eigen::ArrayXd& posterior) const;

 private:
  Eigen::ArrayXd density_;  // 1/m^2
  double lost_density_ = 0;
};

// Kernels of any sigma, each made once. The grid must outlive them.
class SharedErrorKernels {
 public:
  explicit SharedErrorKernels(const ShiftGrid& grid) : grid_(grid) {}
  const SharedErrorKernel& At(double sigma_m);

 private:
  const ShiftGrid& grid_;
  std::map<double, SharedErrorKernel> by_sigma_m_;
};

// A piece of a walk as its parts see it, all of them together and each alone.
class PiecePosterior {
 public:
  PiecePosterior() = default;  // of nothing
  // -log p of each part by shift of the grid, nats; at least one part.
  PiecePosterior(const ShiftGrid& grid, const std::vector<Eigen::ArrayXd>& part_nats);

  // Once for the whole piece and once for the average part.
  double Score(const SharedErrorKernel& kernel) const;

 private:
  Eigen::ArrayXd whole_;  // probability by shift
  std::vector<Eigen::ArrayXd> parts_;
};

}  // namespace walkgraph

#endif  // WALKGRAPH_FRONTENDS_RADIO_MAP_SHIFT_POSTERIOR_H_
