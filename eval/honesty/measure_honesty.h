#ifndef WALKGRAPH_EVAL_HONESTY_MEASURE_HONESTY_H_
#define WALKGRAPH_EVAL_HONESTY_MEASURE_HONESTY_H_

#include <cstdint>
#include <functional>
#include <string>
#include <vector>

#include "eval/config.h"
#include "eval/honesty/matched_walk.h"
#include "eval/methods.h"

namespace walkgraph {

struct HonestyOptions {
  // Walks to test on and to train on; both empty: walks drawn from the graph's own model.
  std::string train;
  std::string test;
  int walks = 200;          // drawn
  double duration_s = 180;  // of each drawn walk, at least
  std::uint64_t seed = 1;   // of the drawn walks
  std::string out;
  std::vector<const Method*> methods;
  bool floor_given = true;
  int workers = 1;
  std::vector<ConfigOverride> overrides;
  std::string command_line;
  std::function<bool()> stopped = [] { return false; };
};

// Measures whether covariances are honest: runs the methods, scores them every kScoredEveryS,
// prints the tables and writes honesty.csv and honesty.json under `out`. Returns an exit code.
// Throws InputError or UsageError before anything is written.
int MeasureHonesty(const HonestyOptions& options);

}  // namespace walkgraph

#endif  // WALKGRAPH_EVAL_HONESTY_MEASURE_HONESTY_H_
