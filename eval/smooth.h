#ifndef WALKGRAPH_EVAL_SMOOTH_H_
#define WALKGRAPH_EVAL_SMOOTH_H_

#include <functional>
#include <string>
#include <vector>

#include "eval/config.h"
#include "eval/methods.h"

namespace walkgraph {

struct SmoothOptions {
  std::string site;  // file
  std::string out;
  std::vector<std::string> recordings;  // files, walk folders or data sets
  std::vector<const Method*> methods;
  int anchor_every = 0;  // waypoints 0, K, 2K, ... become anchors; 0: none
  bool floor_given = true;
  bool tum = false;
  int workers = 1;
  std::vector<ConfigOverride> overrides;
  std::string command_line;
  std::function<bool()> stopped = [] { return false; };
};

// Estimates recordings on a trained site, writes the result files under `out` and, where recordings
// have waypoints, prints their scores. Returns an exit code. Throws InputError or UsageError before
// anything is written: where the site or every recording is unusable.
int SmoothRecordings(const SmoothOptions& options);

}  // namespace walkgraph

#endif  // WALKGRAPH_EVAL_SMOOTH_H_
