#include "common_flags.h"
#include "eval/evaluate.h"
#include "eval/methods.h"
#include "eval/usage_error.h"
#include "verbs.h"

DEFINE_string(train, "", "walks to train on (a folder or one recording), in place of --dataset");
DEFINE_string(test, "",
              "walks to test on, in place of --dataset; for simulate the number of test "
              "walks");
DEFINE_string(methods, "", "comma-separated names; `walkgraph methods` lists them");

namespace walkgraph {
namespace {

void CheckDatasets() {
  const bool one = !FLAGS_dataset.empty();
  const bool two = !FLAGS_train.empty() && !FLAGS_test.empty();
  if (one == two || (one && (!FLAGS_train.empty() || !FLAGS_test.empty()))) {
    throw UsageError("expected either --dataset=DIR or both --train=DIR and --test=DIR");
  }
}

int RunEvaluate(const CommandLine& line) {
  RequireNoArguments(line);
  CheckDatasets();
  RequireFlag("methods", FLAGS_methods);
  RequireFlag("out", FLAGS_out);
  const EvaluateOptions options = {.dataset = FLAGS_dataset,
                                   .train = FLAGS_train,
                                   .test = FLAGS_test,
                                   .out = FLAGS_out,
                                   .methods = ParseMethods(FLAGS_methods),
                                   .folds = Folds(),
                                   .split = SplitOfFlags(),
                                   .split_name = FLAGS_split,
                                   .floor_given = FloorGiven(),
                                   .tum = FLAGS_tum,
                                   .workers = Workers(),
                                   .overrides = ReadOverrides(line),
                                   .command_line = line.text,
                                   .stopped = Interrupted};
  HandleInterrupt();
  return EvaluateDataset(options);
}

}  // namespace

Verb EvaluateVerb() {
  return {"evaluate",
          "--dataset=DIR --methods=a,b --out=DIR",
          "survey, calibrate, estimate and score by cross-validation",
          {"dataset", "train", "test", "methods", "folds", "split", "floor", "out", "tum", "lag",
           "workers", "config", "set"},
          RunEvaluate};
}

}  // namespace walkgraph
