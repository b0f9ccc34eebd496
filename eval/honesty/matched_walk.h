#ifndef WALKGRAPH_EVAL_HONESTY_MATCHED_WALK_H_
#define WALKGRAPH_EVAL_HONESTY_MATCHED_WALK_H_

#include <Eigen/Core>

#include "data/simulator/random.h"
#include "data/truth.h"
#include "eval/settings.h"
#include "frontends/radio_map/site.h"

namespace walkgraph {

// A walk whose evidence comes from the model that the graph itself holds, so that a smoother whose
// covariance is honest must show it here: nothing is left that the model does not know.
//
// The inputs (when steps fall, how long they are, what the gyroscope integrates) are planned
// without knowing the walk. States are drawn from the factors of the graph that these inputs make,
// each from its factor's own density given those before it; the map's error is a field over the
// floor, drawn anew for every walk, which all scans at a place share; compass headings and scans
// come from the absolute-heading, fingerprint and hearing factors at these states.
struct MatchedWalk {
  Evidence evidence;
  Truth truth;             // a waypoint per node
  Eigen::VectorXd values;  // of all blocks of the walk's graph, as FactorGraph::values()
  int silent_scans = 0;    // heard nothing and are no evidence: the model's one omission
};

// The settings under which densities are exact: robust losses off (they are no densities that
// readings follow), every reading of a scan counted (n_eff: they are drawn independently), the
// walk's start as uncertain as it is drawn, a gyroscope bias that leaves the walk inside the site.
Settings MatchedSettings();

// `settings` are those of the estimators. Precondition: the site has one floor with a Wi-Fi map.
MatchedWalk DrawMatchedWalk(const Site& site, const FactorSettings& settings, double duration_s,
                            Random random);

}  // namespace walkgraph

#endif  // WALKGRAPH_EVAL_HONESTY_MATCHED_WALK_H_
