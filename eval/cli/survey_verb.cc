#include "common_flags.h"
#include "eval/smooth.h"
#include "verbs.h"

namespace walkgraph {
namespace {

int RunSurvey(const CommandLine& line) {
  RequireNoArguments(line);
  RequireFlag("dataset", FLAGS_dataset);
  RequireFlag("out", FLAGS_out);
  HandleInterrupt();
  return SurveyDataset(FLAGS_dataset, FLAGS_out, Workers(), ReadOverrides(line), Interrupted);
}

}  // namespace

Verb SurveyVerb() {
  return {"survey",
          "--dataset=DIR --out=SITE",
          "train a radio map from walks with truth",
          {"dataset", "out", "workers", "config", "set"},
          RunSurvey};
}

}  // namespace walkgraph
