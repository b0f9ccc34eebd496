#ifndef WALKGRAPH_SOLVERS_WINDOW_RUN_H_
#define WALKGRAPH_SOLVERS_WINDOW_RUN_H_

#include <Eigen/Core>
#include <cstddef>
#include <optional>
#include <vector>

#include "data/trajectory.h"
#include "factors/dead_reckoning.h"
#include "factors/floor_path.h"
#include "factors/settings.h"
#include "frontends/evidence/evidence.h"
#include "frontends/radio_map/site.h"
#include "graph/statistics.h"
#include "graph/walk_graph.h"
#include "solvers/modes.h"
#include "solvers/settings.h"
#include "solvers/window_hypotheses.h"
#include "solvers/window_recovery.h"

namespace walkgraph {

// One walk, whose floors are known, played through a sliding window.
class WindowRun {
 public:
  // Keeps references: all arguments must outlive the run.
  WindowRun(const Site& site, const Evidence& evidence, const FactorSettings& factors,
            const SolverSettings& solver, const WindowSettings& settings, const FloorPath& floors);

  // Plays the whole walk.
  void Play();

  WalkGraph& walk() { return walk_; }
  // The reported values and covariances of all blocks, as one mode.
  const Mode& reported() const { return reported_; }
  int failed_solves() const { return failed_solves_; }
  int dropped_late() const { return dropped_late_; }
  // How long the window was full, but the walk not yet located, s.
  double waited_s() const { return waited_s_; }
  // How often the track was lost and taken up elsewhere.
  int recoveries() const { return recoveries_; }
  // Of the readings since the first node left, where the settings ask for them.
  const std::vector<FactorFit>& innovations() const { return innovations_; }

 private:
  void Arrive(std::size_t node);
  void PredictNode(std::size_t node, const std::vector<int>& new_slow_blocks);
  std::vector<int> TakeSlowBlocks(TimeNs now_ns);
  void ConditionMapErrors(TimeNs now_ns, const std::vector<int>& blocks,
                          WindowHypothesis* hypothesis);
  std::vector<int> AddReadyFactors(TimeNs now_ns, bool last);
  void JudgeReadings(const std::vector<int>& joined);
  void Solve(WindowHypothesis* hypothesis);
  bool StartIsDue(TimeNs now_ns, bool full) const;
  void Restart(std::size_t node, bool full);
  void Weigh();
  bool IsLocated();
  bool CheckIsDue(std::size_t node) const;
  void CheckTracks(std::size_t node);
  void TakeUpOthers(const Stretch& stretch, double margin_nats, std::size_t newest);
  WindowHypothesis TakeUp(const Stretch& stretch, const Mode& mode, std::size_t newest,
                          double negative_log_mass);
  std::vector<int> LeftNodeBlocks(TimeNs since_ns) const;
  std::vector<Trajectory> Tracks(TimeNs since_ns, std::size_t newest) const;
  Evidence Seen(std::size_t newest) const;
  void Marginalize(std::size_t first_kept);
  std::vector<int> LeavingBlocks(std::size_t first_kept) const;
  std::size_t FirstKeptNode(std::size_t newest) const;
  void Report(const std::vector<int>& blocks);
  const SlidingWindow& window() const { return hypotheses_.front().window; }

  const Site& site_;
  const Evidence& evidence_;
  const FactorSettings& factors_;
  const SolverSettings& solver_;
  const WindowSettings& settings_;
  WalkGraph walk_;
  DeadReckonedPath dead_reckoning_;
  std::vector<WindowHypothesis> hypotheses_;  // never empty; by mass once weighed
  std::vector<int> waiting_;                  // factors, by time of arrival
  std::vector<int> slow_blocks_;              // not yet active, by time
  std::size_t oldest_ = 0;                    // node still in the window
  bool has_evidence_ = false;                 // some evidence of a place took part
  std::optional<TimeNs> started_ns_;          // when proposals were last made
  bool started_full_ = false;                 // with as much evidence as the window is to hold
  bool located_ = false;  // the last proposals agreed on a place: nodes may leave
  bool marginalized_ = false;
  Mode reported_;
  std::optional<TimeNs> checked_ns_;  // when the tracks were last checked
  std::optional<TimeNs> full_ns_;     // when the first node could have left
  double waited_s_ = 0;
  int recoveries_ = 0;
  int failed_solves_ = 0;
  int dropped_late_ = 0;
  std::vector<FactorFit> innovations_;
};

}  // namespace walkgraph

#endif  // WALKGRAPH_SOLVERS_WINDOW_RUN_H_
