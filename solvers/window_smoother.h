#ifndef WALKGRAPH_SOLVERS_WINDOW_SMOOTHER_H_
#define WALKGRAPH_SOLVERS_WINDOW_SMOOTHER_H_

#include <string_view>

#include "factors/settings.h"
#include "solvers/estimator.h"
#include "solvers/settings.h"

namespace walkgraph {

// `window`: the graph of `batch`, played in order of time as a phone would meet it.
//   - Nodes arrive one by one, predicted from the one before by dead reckoning. Every arrival takes
//     in the evidence that has come in by then and solves the window.
//   - The window grows until the walk is located. It starts from the proposals that its own
//     evidence makes, with the first evidence of a place and again just before the first node would
//     leave; while these leave the walk anywhere on the floor, nothing leaves and new ones are made
//     whenever the window has grown by half. How long it waited is a message.
//   - Several hypotheses are followed until the evidence tells them apart, each with the errors of
//     maps at the places that it went by; the best one is reported, with the covariance of their
//     mixture.
//   - Once every window length, and at the walk's end, the hypotheses are held against the
//     whole-walk smoother on the last six lengths. Likely modes that none of them follows become
//     hypotheses. When one of these is the best, the track was lost and is taken up there, with a
//     message that counts it.
//   - A node that is too old leaves: it and its factors become a prior on its neighbours (see
//     graph/sliding_window.h), and its estimate at that moment is the one reported, unless
//     `report_newest` asks for the one at arrival.
//   - Late evidence is used while its nodes are in the window, dropped and counted afterwards. A
//     failed solve leaves the values as they were, is counted, and the next arrival tries again.
//   - With `innovations` every reading is held against what was expected before it came.
// A person who stands still is no exception: nodes go on arriving every second.
class WindowSmoother : public Estimator {
 public:
  WindowSmoother(const FactorSettings& factors, const SolverSettings& solver,
                 const WindowSettings& window)
      : factors_(factors), solver_(solver), window_(window) {}

  std::string_view name() const override { return "window"; }
  EstimateResult Estimate(const Site& site, const Evidence& evidence) const override;

 private:
  FactorSettings factors_;
  SolverSettings solver_;
  WindowSettings window_;
};

}  // namespace walkgraph

#endif  // WALKGRAPH_SOLVERS_WINDOW_SMOOTHER_H_
