#ifndef WALKGRAPH_SOLVERS_BASELINES_TRELLIS_H_
#define WALKGRAPH_SOLVERS_BASELINES_TRELLIS_H_

#include <Eigen/Core>
#include <cstddef>
#include <cstdint>
#include <vector>

#include "solvers/baselines/discrete_motion.h"
#include "solvers/baselines/lattice.h"

namespace walkgraph {

// A state of the discrete smoother at one epoch: the best way to be in a cell with a heading
// offset.
struct TrellisState {
  std::int32_t cell = 0;
  std::int32_t bin = 0;
  std::int32_t previous = -1;  // index into the states of the epoch before
  float nats = 0;              // -log posterior of that way
};
using TrellisLayer = std::vector<TrellisState>;

// The beam search of the discrete smoother (Viterbi), epoch by epoch. Keeps references to lattice
// and bins.
class Trellis {
 public:
  Trellis(const Lattice& lattice, const HeadingBins& bins, double beam_nats)
      : lattice_(lattice),
        bins_(bins),
        beam_nats_(static_cast<float>(beam_nats)),
        slot_(lattice.size() * bins.offset_rad.size(), -1) {}

  // Emissions are -log p of the epoch's evidence by cell, nats. Begin() once, then Advance() once
  // per epoch; where the walk leaves the lattice every state stays where it was.
  void Begin(const std::vector<float>& emission);
  void Advance(const Transition& transition, const std::vector<float>& emission);

  const std::vector<TrellisLayer>& layers() const { return layers_; }

 private:
  struct Move {
    int columns, rows;
    float nats;
  };

  std::size_t Slot(const TrellisState& state) const;
  TrellisLayer Prune(TrellisLayer layer) const;
  static TrellisLayer Stay(const TrellisLayer& from);
  void PrepareMoves(const Eigen::Vector2d& displacement_m, double variance_m2);
  // What the best state reaches: the next layer's best is no worse, so that whatever lies a beam
  // above it need not be kept at all. Infinite where that state has left the lattice.
  float LimitOf(const TrellisLayer& from, const Transition& transition,
                const std::vector<float>& emission);

  void Spread(const TrellisLayer& from, std::int32_t index, const std::vector<float>& emission,
              TrellisLayer* to);
  void Relax(const TrellisState& candidate, TrellisLayer* to);

  const Lattice& lattice_;
  const HeadingBins& bins_;
  float beam_nats_;
  float limit_nats_ = 0;            // see LimitOf
  std::vector<std::int32_t> slot_;  // of each (bin, cell) in the layer under construction
  std::vector<Move> moves_;
  std::vector<TrellisLayer> layers_;
};

}  // namespace walkgraph

#endif  // WALKGRAPH_SOLVERS_BASELINES_TRELLIS_H_
