#ifndef WALKGRAPH_FRONTENDS_RADIO_MAP_SHIFT_POSTERIOR_H_
#define WALKGRAPH_FRONTENDS_RADIO_MAP_SHIFT_POSTERIOR_H_

#include <Eigen/Core>
#include <cstddef>
#include <map>
#include <vector>

namespace walkgraph {

// How well a map places a piece of a walk whose place is known: the posterior of a shift common to
// all of the piece, whose density at zero is a proper score.

// A square grid of shifts about the truth.
class ShiftGrid {
 public:
  // (2 half_count + 1)^2 shifts.
  constexpr ShiftGrid(double spacing_m, int half_count)
      : spacing_m_(spacing_m), half_count_(half_count) {}

  constexpr std::size_t size() const {
    return static_cast<std::size_t>(side()) * static_cast<std::size_t>(side());
  }
  Eigen::Vector2d At(std::size_t index) const {
    const int i = static_cast<int>(index);
    return spacing_m_ * Eigen::Vector2d(i % side() - half_count_, i / side() - half_count_);
  }
  double cell_m2() const { return spacing_m_ * spacing_m_; }

 private:
  constexpr int side() const { return 2 * half_count_ + 1; }
  double spacing_m_;
  int half_count_;
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
  ShiftGrid grid_;
  Eigen::ArrayXd weight_;
};

// Kernels of any sigma, each made once.
class SharedErrorKernels {
 public:
  explicit SharedErrorKernels(const ShiftGrid& grid) : grid_(grid) {}
  const SharedErrorKernel& At(double sigma_m);

 private:
  ShiftGrid grid_;
  std::map<double, SharedErrorKernel> by_sigma_m_;
};

// A piece of a walk as its parts see it, all of them together and each alone.
class PiecePosterior {
 public:
  // -log p of each part by shift, nats; at least one part.
  explicit PiecePosterior(const std::vector<Eigen::ArrayXd>& part_nats);

  // Once for the whole piece and once for the average part.
  double Score(const SharedErrorKernel& kernel) const;

 private:
  Eigen::ArrayXd whole_;  // probability by shift
  std::vector<Eigen::ArrayXd> parts_;
};

}  // namespace walkgraph

#endif  // WALKGRAPH_FRONTENDS_RADIO_MAP_SHIFT_POSTERIOR_H_
