#ifndef WALKGRAPH_EVAL_STUDY_STUDY_FILE_H_
#define WALKGRAPH_EVAL_STUDY_STUDY_FILE_H_

#include <string>
#include <vector>

#include "eval/study/study.h"

namespace walkgraph {

// Reads a declared study:
//
//   datasets: {site1: real-data/ilc20/data/site1}   # name: folder, from the working directory
//   split: walk                                     # and folds, floor: as for evaluate
//   set: {noise.step.sigma_along_m: 0.1}            # keys of the configuration, for every cell
//   methods: [batch, viterbi]                       # a cell each
//   factors:                                        # a cell per subset
//     method: batch
//     design: all-subsets                           # or leave-one-out, add-one-in
//     list: [step, fingerprint]                     # or left out: the default seven
//   grids:                                          # a cell per combination of values
//     - method: window
//       keys: {window.seconds: [5, 10, 20]}
//   reference: batch                                # or left out: all factors, or the first cell
//
// `overrides` (of --config and --set) hold for every cell too and win over `set`. Throws InputError
// with file:line for what cannot be used and UsageError for contradictions.
Study ReadStudyFile(const std::string& path, const std::vector<ConfigOverride>& overrides);

// Throws UsageError where the study has no data set or cell, two of a name, a name that is no
// folder name, or a reference that is none of its cells.
void CheckStudy(const Study& study);

// "site1" of "real-data/ilc20/data/site1/".
std::string DatasetNameOf(const std::string& path);

}  // namespace walkgraph

#endif  // WALKGRAPH_EVAL_STUDY_STUDY_FILE_H_
