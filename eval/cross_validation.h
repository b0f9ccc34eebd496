#ifndef WALKGRAPH_EVAL_CROSS_VALIDATION_H_
#define WALKGRAPH_EVAL_CROSS_VALIDATION_H_

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "data/truth.h"
#include "frontends/evidence/evidence.h"

namespace walkgraph {

// Which walks must stay on the same side of the split between training and test.
enum class SplitBy : std::uint8_t {
  kWalk,     // every walk for itself
  kSession,  // walks chained where one starts within 60 s and 1 m of where the last one ended
  kTrial,    // repetitions of one route
  kPhone,    // one device
  kBlock,    // walks whose mean position lies in the same 20 m square of a floor
};

// "walk", "session", "trial", "phone" or "block"; nullopt for anything else.
std::optional<SplitBy> SplitByName(std::string_view name);

// What grouping looks at. The truth is in the building frame.
struct WalkToSplit {
  std::string id;
  std::string trial;
  std::string device;
  const Truth* truth = nullptr;
};

// The group of each walk, a name that hangs only on the walks of the group. Walks without waypoints
// are grouped by themselves under kSession and kBlock.
std::vector<std::string> GroupWalks(const std::vector<WalkToSplit>& walks, SplitBy split);

// The fold in [0, folds) that holds a group out: a hash of its name, so that adding walks moves no
// other. Precondition: folds > 0.
int FoldOfGroup(std::string_view group, int folds);

// Readings of test walks. A reading is known by transmitter and time heard: the phone reports it
// again in the next walk, and training on it would be training on the test.
class HeardReadings {
 public:
  void Add(const Evidence& evidence);
  // To be called once after the last Add.
  void Freeze();
  // Removes from `evidence` the readings heard here; returns their number.
  int RemoveFrom(Evidence* evidence) const;

 private:
  std::vector<std::uint64_t> keys_;  // hashes of (radio, transmitter, time heard), sorted
};

}  // namespace walkgraph

#endif  // WALKGRAPH_EVAL_CROSS_VALIDATION_H_
