#ifndef WALKGRAPH_EVAL_SURVEY_H_
#define WALKGRAPH_EVAL_SURVEY_H_

#include <functional>
#include <string>
#include <vector>

#include "eval/config.h"

namespace walkgraph {

// What is learnt from all walks of a data set that have waypoints.
struct LearnOptions {
  std::string dataset;
  std::string out;  // file, written whole or not at all
  int workers = 1;
  std::vector<ConfigOverride> overrides;
  std::function<bool()> stopped = [] { return false; };
};

// Both return an exit code and throw InputError where the data set cannot be opened or no walk has
// waypoints; walks that cannot be read are named on standard error and left out.

// Trains a site and writes it to `out`.
int SurveyDataset(const LearnOptions& options);

// Calibrates the noise model and writes the settings that differ from the defaults to `out`, as a
// configuration that --config reads.
int CalibrateDataset(const LearnOptions& options);

}  // namespace walkgraph

#endif  // WALKGRAPH_EVAL_SURVEY_H_
