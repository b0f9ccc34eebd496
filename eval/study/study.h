#ifndef WALKGRAPH_EVAL_STUDY_STUDY_H_
#define WALKGRAPH_EVAL_STUDY_STUDY_H_

#include <cstddef>
#include <cstdint>
#include <map>
#include <string>
#include <vector>

#include "eval/config.h"
#include "eval/cross_validation.h"
#include "eval/methods.h"

namespace walkgraph {

// One configuration of one method.
struct StudyCell {
  std::string name;
  const Method* method = nullptr;
  std::vector<ConfigOverride> overrides;  // on top of the study's own
};

// A data set under the name that tables give it.
struct StudyDataset {
  std::string name;
  std::string path;
};

// A comparison as it was declared, written out into its cells. Every data set is cross-validated
// for itself.
struct Study {
  std::vector<StudyDataset> datasets;
  int folds = 5;
  SplitBy split = SplitBy::kWalk;
  std::string split_name = "walk";
  bool floor_given = false;
  std::vector<ConfigOverride> base;  // hold for every cell
  std::vector<StudyCell> cells;      // names are unique
  std::string reference;             // the cell that the others are compared with
  // The factors that subsets were made of, by bit, and the cell of each subset that is in the study
  // (members are the set bits). Empty where the study makes no subsets.
  std::vector<std::string> factors;
  std::map<std::uint32_t, std::size_t> cell_of_subset;
};

// Splits overrides into those that change the evidence or the radio map (frontend.*, radio_map.*),
// for which walks are read and sites trained anew, and those that only estimators see.
std::vector<ConfigOverride> PreparationOverrides(const std::vector<ConfigOverride>& overrides);
std::vector<ConfigOverride> EstimatorOverrides(const std::vector<ConfigOverride>& overrides);

// The values that hold where later overrides win over earlier ones.
std::map<std::string, std::string> EffectiveOverrides(const std::vector<ConfigOverride>& base,
                                                      const std::vector<ConfigOverride>& cell);

// 16 hexadecimal digits that hang on all that makes a cell's results, given version and inputs:
// its method and every value that was set for it.
std::string ConfigurationHash(const Study& study, const StudyCell& cell);

}  // namespace walkgraph

#endif  // WALKGRAPH_EVAL_STUDY_STUDY_H_
