#ifndef WALKGRAPH_SOLVERS_WINDOW_RECOVERY_H_
#define WALKGRAPH_SOLVERS_WINDOW_RECOVERY_H_

#include <Eigen/Core>
#include <optional>
#include <vector>

#include "data/time.h"
#include "data/trajectory.h"
#include "factors/settings.h"
#include "frontends/evidence/evidence.h"
#include "frontends/radio_map/site.h"
#include "graph/linear_prior.h"
#include "graph/walk_graph.h"
#include "solvers/initial_trajectory.h"
#include "solvers/modes.h"
#include "solvers/settings.h"

namespace walkgraph {

// Starts for FindModes: the tracks that a window follows, then what the evidence proposes, with at
// most `placements` rigid ones (ProposeTrajectories).
std::vector<InitialTrajectory> TracksAndProposals(const std::vector<Trajectory>& tracks,
                                                  const Site& site, const Evidence& evidence,
                                                  const FactorSettings& factors,
                                                  const FloorPath& floors, int placements);

// Where a track that a window follows stands in a stretch.
struct TrackPlace {
  int mode = -1;    // that it leads to; -1: none worth refining
  bool at = false;  // it goes by that mode's path since the window's begin, not only leads there
};

// A stretch of a walk as the whole-walk smoother has it.
struct Stretch {
  WalkGraph walk;                  // of that stretch alone
  std::vector<Mode> modes;         // best first
  std::vector<TrackPlace> tracks;  // as given
};

// What the whole-walk smoother makes of the recent evidence: it sees the whole floor, a window the
// neighbourhood of its own modes. The tracks that the window follows, which hold positions and
// headings over that time, are starts like any other, so that they are held against the rest on one
// graph. Rigid placements are not among them: once a walk is located they cost as much as all else
// and found nothing (365 walks of a mall, 2026-12-01). None where the evidence knows no place.
std::optional<Stretch> SmoothStretch(const Site& site, const Evidence& recent,
                                     const FactorSettings& factors, const SolverSettings& solver,
                                     const std::vector<Trajectory>& tracks, TimeNs window_begin_ns,
                                     const FloorPath& floors);

// Moves blocks of a window to a mode of a stretch: nodes to its trajectory, slow states to its own
// that hold at their time. `values` are those of the window's graph.
void MoveTo(const WalkGraph& stretch, const Mode& mode, const FactorGraph& graph,
            const std::vector<int>& blocks, Eigen::VectorXd* values);

// What stands for all that the window has forgotten: the first node, the first knot of every
// slow state and all from before the first node, each alone, with twice the mode's sigma, because
// the window's own evidence took part in that. `blocks` are the window's. Precondition:
// MoveTo(stretch, mode, graph, blocks, values).
LinearPrior PriorFrom(const WalkGraph& stretch, const Mode& mode, const FactorGraph& graph,
                      const std::vector<int>& blocks, const Eigen::VectorXd& values);

}  // namespace walkgraph

#endif  // WALKGRAPH_SOLVERS_WINDOW_RECOVERY_H_
