#ifndef WALKGRAPH_SOLVERS_SETTINGS_H_
#define WALKGRAPH_SOLVERS_SETTINGS_H_

namespace walkgraph {

// How the batch and window smoothers search. Work is capped in iterations, never in seconds, so
// that a result does not depend on the machine.
struct SolverSettings {
  int max_iterations = 50;
  // A step that changes the cost by less ends the search. In nats, not in shares of the cost: what
  // a walk of half an hour costs in all says nothing about what one of its minutes may yet gain.
  double tolerance_nats = 0.01;
  int hypotheses = 4;          // dead-reckoned starts beside those of the discrete smoother
  double mode_limit_nats = 6;  // modes this much worse than the best are dropped
  double distinct_m = 1.0;     // root mean square distance under which two solutions are one mode
  // Chance under the noise model that map errors are as large as a walk's, below which its
  // covariance takes what they show instead. The usual level of a global test (our choice).
  double map_error_test = 0.05;
};

struct WindowSettings {
  double seconds = 10;          // nodes older than this before the newest leave the window
  int nodes = 0;                // if positive, this many nodes stay instead
  int hypotheses = 4;           // followed at once at most, until evidence tells them apart
  double hypothesis_nats = 12;  // and dropped when this much worse than the best
  // Nodes do not leave before the oldest position is known this well over all hypotheses, and they
  // agree about it: what is marginalised while the walk may be anywhere stays wrong. Well above the
  // spread of one mode and below that of a floor.
  double located_sigma_m = 20;
  double map_error_s = 60;     // errors of maps stay this long for who comes back to a place
  bool report_newest = false;  // report a node when it arrives (no lag), not when it leaves
  bool innovations = false;    // hold every reading against what was expected of it
};

template <typename Visitor>
void Visit(Visitor& v, SolverSettings& s) {
  v.Field("max_iterations", s.max_iterations, "Levenberg-Marquardt iterations per solve at most");
  v.Field("tolerance_nats", s.tolerance_nats,
          "a step that changes the cost by less ends a solve, nats");
  v.Field("hypotheses", s.hypotheses,
          "dead-reckoned starts beside the paths of the discrete smoother");
  v.Field("mode_limit_nats", s.mode_limit_nats, "modes this much worse than the best are dropped");
  v.Field("distinct_m", s.distinct_m, "solutions closer than this (RMS) are one mode, m");
  v.Field(
      "map_error_test", s.map_error_test,
      "where a walk's map errors are less likely than this under the noise model, its covariance "
      "takes the variance that they show; 0: never");
}
template <typename Visitor>
void Visit(Visitor& v, WindowSettings& s) {
  v.Field("seconds", s.seconds, "nodes older than this leave the window, s");
  v.Field("nodes", s.nodes, "if positive, the window keeps this many nodes instead");
  v.Field("hypotheses", s.hypotheses, "hypotheses that the window follows at once at most");
  v.Field("hypothesis_nats", s.hypothesis_nats,
          "a hypothesis this much worse than the best is dropped, nats");
  v.Field("map_error_s", s.map_error_s,
          "errors of maps stay in the window this long, for who comes back to a place, s");
  v.Field("located_sigma_m", s.located_sigma_m,
          "no node leaves before the oldest position is known this well over all hypotheses, m");
  v.Field("report_newest", s.report_newest,
          "report a node when it arrives instead of when it leaves the window");
  v.Field(
      "innovations", s.innovations,
      "hold every reading against what was expected before it came, at a solve per arrival, for "
      "explain/ (`walkgraph honesty` always does)");
}

}  // namespace walkgraph

#endif  // WALKGRAPH_SOLVERS_SETTINGS_H_
