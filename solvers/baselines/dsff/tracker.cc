#include "solvers/baselines/dsff/tracker.h"

#include <algorithm>
#include <cmath>
#include <optional>
#include <string>
#include <utility>

namespace walkgraph {
namespace {

class Tracker {
 public:
  Tracker(const DsffCells& cells, RelativeSensors sensors, double first_height_m,
          const MapMatching* map_matching, const DsffSettings& settings)
      : cells_(cells),
        sensors_(std::move(sensors)),
        first_height_m_(first_height_m),
        map_matching_(map_matching),
        settings_(settings),
        viterbi_(cells.size(), settings.k, settings.beam_nats) {}

  DsffTrack Run(const AbsoluteEvidence& evidence, const std::vector<DsffMotion>& motion) {
    for (std::size_t e = 0; e < evidence.time_ns.size(); ++e) {
      std::vector<double> emission = evidence.log_likelihood[e];
      AddHeights(motion[e], &emission);
      if (e == 0) {
        viterbi_.Begin(emission);
      } else {
        const double seconds = SecondsBetween(evidence.time_ns[e - 1], evidence.time_ns[e]);
        Advance(motion[e], seconds, emission);
      }
      Learn(motion[e]);
      Report(evidence.time_ns[e]);
    }
    track_.traces = viterbi_.Best();
    return std::move(track_);
  }

 private:
  bool HasFloors() const { return cells_.floors().size() > 1; }

  // The bar over z: the height that the barometer tells against that of each floor.
  void AddHeights(const DsffMotion& motion, std::vector<double>* emission) const {
    if (!HasFloors() || !motion.height_m) return;
    for (const DsffCells::FloorCells& floor : cells_.floors()) {
      const double log_p =
          sensors_.height.LogDensity(floor.height_m - first_height_m_ - *motion.height_m);
      for (std::size_t i = 0; i < floor.points.size(); ++i) (*emission)[floor.begin + i] += log_p;
    }
  }

  void Advance(const DsffMotion& motion, double seconds, const std::vector<double>& emission) {
    const double reach_m = std::max(2 * cells_.spacing_m(), settings_.max_speed_mps * seconds);
    const TransitionKernel kernel = MakeKernel(motion, sensors_, cells_.spacing_m(), reach_m);
    const auto transitions = [&](int from, const auto& relax) {
      const double share = map_matching_ != nullptr ? map_matching_->LogBranchShare(from) : 0.0;
      for (std::size_t f = 0; f < cells_.floors().size(); ++f) {
        for (const TransitionKernel::Entry& entry : kernel.entries) {
          const int to = cells_.Move(from, entry.offset, f);
          if (to < 0 || (map_matching_ != nullptr && map_matching_->Blocks(from, to))) continue;
          relax(to, entry.log_probability + share);
        }
      }
    };
    if (viterbi_.Advance(transitions, emission)) return;
    viterbi_.Restart(emission);
    ++track_.restarts;
    restarted_ = true;
  }

  void Learn(const DsffMotion& motion) {
    const KBestViterbi::Step step = viterbi_.LastStep();
    std::optional<double> height_error_m;
    if (HasFloors() && motion.height_m) {
      height_error_m = *motion.height_m + first_height_m_ - cells_.FloorOf(step.to).height_m;
    }
    // A jump says nothing about steps and headings.
    const DsffMotion heeded = std::exchange(restarted_, false) ? DsffMotion() : motion;
    LearnFromTrace(heeded, cells_.PositionOf(step.to) - cells_.PositionOf(step.from),
                   height_error_m, &sensors_);
  }

  void Report(TimeNs time_ns) {
    const std::pair<const char*, const RelativeSensor*> named[] = {
        {"step_length_error_m", &sensors_.distance},
        {"heading_error_rad", &sensors_.heading},
        {"height_error_m", &sensors_.height}};
    for (const auto& [name, sensor] : named) {
      const ErrorBlock* block = sensor->block();
      if (block == nullptr) continue;
      track_.learnt.push_back({name, time_ns, block->Mean(), std::sqrt(block->Variance())});
    }
  }

  const DsffCells& cells_;
  RelativeSensors sensors_;
  double first_height_m_;
  const MapMatching* map_matching_;
  const DsffSettings& settings_;
  KBestViterbi viterbi_;
  bool restarted_ = false;  // the last epoch
  DsffTrack track_;
};

}  // namespace

DsffTrack TrackByErrorBlocks(const DsffCells& cells, const AbsoluteEvidence& evidence,
                             const std::vector<DsffMotion>& motion, RelativeSensors sensors,
                             double first_height_m, const MapMatching* map_matching,
                             const DsffSettings& settings) {
  return Tracker(cells, std::move(sensors), first_height_m, map_matching, settings)
      .Run(evidence, motion);
}

}  // namespace walkgraph
