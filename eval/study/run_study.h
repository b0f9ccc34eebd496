#ifndef WALKGRAPH_EVAL_STUDY_RUN_STUDY_H_
#define WALKGRAPH_EVAL_STUDY_RUN_STUDY_H_

#include <functional>
#include <string>

#include "eval/study/study.h"

namespace walkgraph {

struct StudyOptions {
  std::string out;
  int workers = 1;
  // This process works on the `shard`-th of `shards` equal parts of each data set's walks, counted
  // from 1. Shards hold few folds each, so that few sites are trained twice.
  int shard = 1;
  int shards = 1;
  std::string command_line;
  std::function<bool()> stopped = [] { return false; };
};

// Computes what is missing of a study in the folder `out`. Walks, evidence and sites are made once
// for all cells that share them; a walk's file is written when all its cells are done. Once every
// walk of the study is there, writes summary and tables and prints the summary. The same study
// ends with the same bytes outside run/, however often it was killed and by whatever shards it was
// computed. Returns an exit code. Throws UsageError where `out` holds something else, or results of
// another version or of other inputs.
int RunStudy(const Study& study, const StudyOptions& options);

}  // namespace walkgraph

#endif  // WALKGRAPH_EVAL_STUDY_RUN_STUDY_H_
