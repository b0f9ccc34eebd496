#ifndef WALKGRAPH_EVAL_CALIBRATE_CALIBRATED_VALUES_H_
#define WALKGRAPH_EVAL_CALIBRATE_CALIBRATED_VALUES_H_

#include <cstddef>
#include <string>
#include <vector>

#include "data/truth.h"
#include "frontends/evidence/evidence.h"

namespace walkgraph {

// A walk with truth (in the building frame), to learn noise from.
struct CalibrationWalk {
  const Evidence* evidence = nullptr;
  const Truth* truth = nullptr;
};

// One calibrated setting: what it was set to and on how much it rests.
struct CalibratedValue {
  std::string key;  // as in the configuration file, "noise.step.sigma_along_m"
  double value = 0;
  std::size_t samples = 0;
  std::string basis;  // what the samples are: "walks", "pairs of legs", "samples"
};

// Fewer samples say nothing about a setting: it keeps its default.
inline constexpr std::size_t kMinCalibrationSamples = 10;

// Sets a setting and remembers that it was. `key` is the setting's below "noise.".
inline void SetCalibrated(const std::string& key, double value, std::size_t samples,
                          const char* basis, double* setting,
                          std::vector<CalibratedValue>* values) {
  *setting = value;
  values->push_back({"noise." + key, value, samples, basis});
}

}  // namespace walkgraph

#endif  // WALKGRAPH_EVAL_CALIBRATE_CALIBRATED_VALUES_H_
