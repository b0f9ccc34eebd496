#ifndef WALKGRAPH_EVAL_SETTINGS_H_
#define WALKGRAPH_EVAL_SETTINGS_H_

#include <cstdint>

#include "factors/settings.h"
#include "frontends/radio_map/map_update.h"
#include "frontends/radio_map/trainer.h"
#include "frontends/settings.h"
#include "solvers/baselines/ahf/filters.h"
#include "solvers/baselines/dead_reckoning.h"
#include "solvers/baselines/discrete_smoother.h"
#include "solvers/baselines/dsff/tracker.h"
#include "solvers/baselines/hipe.h"
#include "solvers/baselines/mle.h"
#include "solvers/baselines/mufaf/mufaf.h"
#include "solvers/baselines/tcpf/fusion.h"
#include "solvers/baselines/wknn.h"
#include "solvers/settings.h"

namespace walkgraph {

// How survey walks are placed between their waypoints: on the straight lines by the distance walked
// (SurveyTrajectory), or where the motion sensors say, held at the waypoints (AnchoredSmoother).
enum class SurveyPositions : std::uint8_t { kWalkedDistance, kSmoother };

struct SurveySettings {
  SurveyPositions positions = SurveyPositions::kSmoother;
};

template <typename Visitor>
void Visit(Visitor& v, SurveySettings& s) {
  v.Field("positions", s.positions, "survey walks between waypoints: walked_distance or smoother");
}

// How estimates are scored.
struct ScoringSettings {
  // Error of a waypoint itself, as the survey assumes it: a person taps while passing a mark.
  double waypoint_sigma_m = 0.3;
};

template <typename Visitor>
void Visit(Visitor& v, ScoringSettings& s) {
  v.Field("waypoint_sigma_m", s.waypoint_sigma_m,
          "error of a waypoint per axis, in coverage and as an anchor, m");
}

// Parameters of the methods that are compared with the graph.
struct BaselineSettings {
  WknnSettings wknn;
  DeadReckoningSettings pdr;
  MleSettings mle;
  HipeSettings hipe;
  TcpfSettings tcpf;
  AhfSettings ahf;
  DsffSettings dsff;
  MufafSettings mufaf;
  DiscreteSettings viterbi;
};

template <typename Visitor>
void Visit(Visitor& v, BaselineSettings& s) {
  v.Group("wknn", s.wknn);
  v.Group("pdr", s.pdr);
  v.Group("mle", s.mle);
  v.Group("hipe", s.hipe);
  v.Group("tcpf", s.tcpf);
  v.Group("ahf", s.ahf);
  v.Group("dsff", s.dsff);
  v.Group("mufaf", s.mufaf);
  v.Group("viterbi", s.viterbi);
}

// Everything that can be configured, made of the settings structs of the layers below. The defaults
// are the documented reference that `walkgraph config` prints.
struct Settings {
  FactorSettings factors;
  FrontendSettings frontend;
  SurveySettings survey;
  TrainerSettings radio_map;
  MapChangeSettings map_change;
  SolverSettings solver;
  WindowSettings window;
  BaselineSettings baselines;
  ScoringSettings scoring;
};

}  // namespace walkgraph

#endif  // WALKGRAPH_EVAL_SETTINGS_H_
