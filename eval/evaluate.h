#ifndef WALKGRAPH_EVAL_EVALUATE_H_
#define WALKGRAPH_EVAL_EVALUATE_H_

#include <functional>
#include <string>
#include <vector>

#include "eval/config.h"
#include "eval/cross_validation.h"
#include "eval/methods.h"

namespace walkgraph {

// Exit codes of the program.
inline constexpr int kExitOk = 0;
inline constexpr int kExitFailure = 1;  // of the system: a full disk, no memory
inline constexpr int kExitUsage = 2;
inline constexpr int kExitBadInput = 3;
inline constexpr int kExitNoTrajectory = 4;
inline constexpr int kExitInterrupted = 130;

struct EvaluateOptions {
  // Either one folder that is split into folds, or two that are not.
  std::string dataset;
  std::string train;
  std::string test;
  std::string out;
  std::vector<const Method*> methods;
  int folds = 5;
  SplitBy split = SplitBy::kWalk;
  std::string split_name = "walk";
  bool floor_given = true;
  bool tum = false;
  int workers = 1;
  std::vector<ConfigOverride> overrides;
  std::string command_line;
  std::function<bool()> stopped = [] { return false; };
};

// Survey, calibrate, estimate and score: reads every walk, trains a site per fold on the walks that
// the fold does not hold out, runs every method on those that it does, writes the result files
// under `out` and prints the table on standard output. Every walk of the data set gets a row per
// method. Returns an exit code. Throws InputError or UsageError before anything is written.
int EvaluateDataset(const EvaluateOptions& options);

}  // namespace walkgraph

#endif  // WALKGRAPH_EVAL_EVALUATE_H_
