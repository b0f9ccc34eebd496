// The verbs that learn from walks.
#include <gflags/gflags.h>

#include <algorithm>
#include <string>

#include "common_flags.h"
#include "eval/site_update.h"
#include "eval/suggest.h"
#include "eval/survey.h"
#include "eval/usage_error.h"
#include "verbs.h"

DEFINE_string(update, "",
              "graph, kriging or covariance: how the site given by --site learns from the walks, "
              "whose truth it does not use");

DECLARE_string(method);
DECLARE_string(site);

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

SiteUpdate UpdateOfFlag() {
  const auto name = std::find(kSiteUpdateNames.begin(), kSiteUpdateNames.end(), FLAGS_update);
  if (name == kSiteUpdateNames.end()) {
    throw UsageError("--update=" + FLAGS_update +
                     DidYouMean(FLAGS_update, {kSiteUpdateNames.begin(), kSiteUpdateNames.end()}) +
                     ", expected graph, kriging or covariance");
  }
  return static_cast<SiteUpdate>(name - kSiteUpdateNames.begin());
}

bool IsGiven(const char* flag) { return !gflags::GetCommandLineFlagInfoOrDie(flag).is_default; }

// Empty where the command line names none: the flag's default is another verb's.
std::string MethodOfFlag() { return IsGiven("method") ? FLAGS_method : ""; }

// A survey has its walks' truth, so that nothing locates them and their floors are known.
void RefuseFlagsOfUpdates() {
  for (const char* flag : {"method", "floor"}) {
    if (IsGiven(flag)) {
      throw UsageError("--" + std::string(flag) + " is for --update, expected --update and --site");
    }
  }
}

int RunSurvey(const CommandLine& line) {
  if (FLAGS_update.empty() && FLAGS_site.empty()) {
    RefuseFlagsOfUpdates();
    return SurveyDataset(Options(line));
  }
  RequireFlag("update", FLAGS_update);
  RequireFlag("site", FLAGS_site);
  return UpdateSurveyedSite({.learn = Options(line),
                             .site = FLAGS_site,
                             .method = MethodOfFlag(),
                             .update = UpdateOfFlag(),
                             .floor_given = FloorGiven()});
}

int RunCalibrate(const CommandLine& line) { return CalibrateDataset(Options(line)); }

}  // namespace

Verb SurveyVerb() {
  return {"survey",
          "--dataset=DIR --out=SITE",
          "train a radio map from walks with truth, or (--site, --update) let one learn from walks",
          {"dataset", "out", "site", "update", "method", "floor", "workers", "config", "set"},
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
