#ifndef WALKGRAPH_EVAL_LOADED_WALK_H_
#define WALKGRAPH_EVAL_LOADED_WALK_H_

#include <string>
#include <vector>

#include "data/building.h"
#include "data/dataset.h"
#include "data/truth.h"
#include "frontends/evidence/evidence.h"
#include "frontends/settings.h"

namespace walkgraph {

// A walk read and turned into evidence, or the reason why it could not be.
struct LoadedWalk {
  WalkFile file;
  std::string checksum;            // of the file's bytes
  Evidence evidence;               // with the floor, where it is given and known
  Truth truth;                     // building frame
  std::string error;               // empty where the walk is usable
  std::vector<std::string> notes;  // what its results should be read with
};

// Reads one walk. With `floor_given` the evidence carries the floor of the folder or, failing that,
// of the waypoints; that of a walk whose waypoints lie on several floors has none. Never throws on
// input: a walk that cannot be read has its error set.
LoadedWalk LoadWalk(const WalkFile& file, const Building& building,
                    const FrontendSettings& settings, bool floor_given);

// One line in the log for all walks with notes.
void LogNotes(const std::vector<LoadedWalk>& walks);

// The k-th, 2k-th, ... waypoints after the first, and the first itself, become anchors of the
// evidence with `sigma_m`, and leave the truth: what an estimator has been told is not scored.
void UseWaypointsAsAnchors(int every, double sigma_m, LoadedWalk* walk);

}  // namespace walkgraph

#endif  // WALKGRAPH_EVAL_LOADED_WALK_H_
