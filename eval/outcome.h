#ifndef WALKGRAPH_EVAL_OUTCOME_H_
#define WALKGRAPH_EVAL_OUTCOME_H_

#include <limits>
#include <string>
#include <vector>

#include "data/time.h"
#include "data/truth.h"
#include "eval/metrics.h"
#include "frontends/evidence/evidence.h"
#include "solvers/estimator.h"

namespace walkgraph {

// What one method made of one walk, scored. The trajectory itself has gone to its file.
struct MethodOutcome {
  EstimateStatus status = EstimateStatus::kUnsupported;
  bool has_trajectory = false;
  std::vector<WaypointError> errors;  // empty without trajectory or waypoints
  std::vector<bool> trusted;          // at the waypoints; see TrustedAt
  std::vector<std::string> messages;
  double seconds = 0;  // wall time, outside the promise of equal bytes
};

// One walk of an evaluation.
struct WalkOutcome {
  std::string walk;
  int fold = 0;
  bool finished = false;  // false where the run was stopped before its turn
  double duration_s = 0;  // of the recording
  double survey_distance_m = std::numeric_limits<double>::quiet_NaN();
  Truth truth;                                 // building frame; the scored waypoints
  std::vector<MotionState> motion;             // at each of them, as the evidence has it
  std::vector<WaypointError> centroid_errors;  // what a missing output is scored as
  std::vector<MethodOutcome> methods;          // in the order of Evaluation::methods
};

// All that a run found, in the order of walk ids.
struct Evaluation {
  std::vector<std::string> methods;
  std::vector<WalkOutcome> walks;
};

inline bool AnyTrajectory(const Evaluation& evaluation) {
  for (const WalkOutcome& walk : evaluation.walks) {
    for (const MethodOutcome& method : walk.methods) {
      if (method.has_trajectory) return true;
    }
  }
  return false;
}

}  // namespace walkgraph

#endif  // WALKGRAPH_EVAL_OUTCOME_H_
