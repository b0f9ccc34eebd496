// The verbs that learn from walks with truth.
#include "common_flags.h"
#include "eval/survey.h"
#include "verbs.h"

namespace walkgraph {
namespace {

LearnOptions Options(const CommandLine& line) {
  RequireNoArguments(line);
  RequireFlag("dataset", FLAGS_dataset);
  RequireFlag("out", FLAGS_out);
  HandleInterrupt();
  return {.dataset = FLAGS_dataset,
          .out = FLAGS_out,
          .workers = Workers(),
          .overrides = ReadOverrides(line),
          .stopped = Interrupted};
}

int RunSurvey(const CommandLine& line) { return SurveyDataset(Options(line)); }

int RunCalibrate(const CommandLine& line) { return CalibrateDataset(Options(line)); }

}  // namespace

Verb SurveyVerb() {
  return {"survey",
          "--dataset=DIR --out=SITE",
          "train a radio map from walks with truth",
          {"dataset", "out", "workers", "config", "set"},
          RunSurvey};
}

Verb CalibrateVerb() {
  return {"calibrate",
          "--dataset=DIR --out=FILE",
          "fit sigmas and random-walk rates to walks with truth",
          {"dataset", "out", "workers", "config", "set"},
          RunCalibrate};
}

}  // namespace walkgraph
