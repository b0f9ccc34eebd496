#ifndef WALKGRAPH_FRONTENDS_RADIO_MAP_HELD_OUT_PIECES_H_
#define WALKGRAPH_FRONTENDS_RADIO_MAP_HELD_OUT_PIECES_H_

#include <Eigen/Core>
#include <cstddef>
#include <cstdint>
#include <map>
#include <vector>

#include "frontends/radio_map/map_builder.h"
#include "frontends/radio_map/shift_posterior.h"

namespace walkgraph {

// The transmitters of a floor that the searches for a model and for the biases of directions see,
// at most: a hundred walks are to be trained on in seconds.
inline constexpr std::size_t kSearchTransmitters = 150;
// Trials are held out in thirds.
inline constexpr std::size_t kCalibrationFolds = 3;
// By which held-out pieces are moved, 21 m to each side: by steps of 2.5 m, which is enough to tell
// models apart, or by half a metre in the middle, for dense surveys and clear air.
const ShiftGrid& WideShifts();
const ShiftGrid& FineShifts();

// -log p of a scan, moved by every shift: of its signal strengths, and of what it heard and missed.
struct ScanCost {
  std::size_t readings = 0;  // that the map knows
  Eigen::ArrayXd signal_nats;
  Eigen::ArrayXd hearing_nats;
};

// 20 s of a walk that the map has not seen.
struct HeldOutPiece {
  std::vector<ScanCost> scans;
  double survey_distance_m = 0;  // mean over its scans, as the map has it
};

// The scans of a floor by trial and walk, and the maps that leave one third of the trials out.
class HeldOutTrials {
 public:
  // The references must outlive it. Maps are made of an even selection of at most
  // `max_transmitters`.
  HeldOutTrials(const FloorSurvey& survey, const TrainerSettings& settings,
                std::size_t max_transmitters, const Executor& run);

  const Executor& run() const { return run_; }

  // Six walks of three trials, fewer of which say nothing.
  bool enough() const { return enough_; }

  // The walks of a fold, and the map of the others.
  const std::vector<const ScanList*>& HeldOut(std::size_t fold) { return FoldAt(fold).held_out; }
  RadioMap MapWithout(std::size_t fold, const FieldModel& model);

  // Pieces of an even selection of at most `max_walks` walks of a fold, on the map of the others.
  void AppendFold(std::size_t fold, const FieldModel& model, const ShiftGrid& shifts,
                  std::size_t max_walks, std::vector<HeldOutPiece>* pieces);

 private:
  // A fold's walks, and what its maps are made of.
  struct Fold {
    std::vector<const ScanList*> held_out;
    MapInput input;
  };
  Fold MakeFold(std::size_t fold) const;
  const Fold& FoldAt(std::size_t fold);

  const FloorSurvey& survey_;
  const TrainerSettings& settings_;
  const Executor& run_;
  std::map<std::uint32_t, std::map<std::uint32_t, ScanList>> by_trial_;
  bool enough_ = false;
  TransmitterSelection selection_;
  std::map<std::size_t, Fold> folds_;  // those asked for
};

}  // namespace walkgraph

#endif  // WALKGRAPH_FRONTENDS_RADIO_MAP_HELD_OUT_PIECES_H_
