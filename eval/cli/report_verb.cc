#include <algorithm>

#include "common_flags.h"
#include "eval/evaluate.h"
#include "eval/report/report.h"
#include "eval/report/study_report.h"
#include "eval/usage_error.h"
#include "verbs.h"

DEFINE_string(walk, "", "explain this walk of a result folder");
DEFINE_bool(allow_differences, false,
            "put results of different versions or inputs into one report all the same");

namespace walkgraph {
namespace {

int RunReport(const CommandLine& line) {
  if (line.arguments.empty()) throw UsageError("expected a result folder, or several");
  RequireFlag("out", FLAGS_out);
  if (!FLAGS_walk.empty()) {
    if (line.arguments.size() != 1) throw UsageError("--walk: expected one result folder");
    WriteWalkReport(line.arguments.front(), FLAGS_walk, FLAGS_out);
    return kExitOk;
  }
  const bool study = std::any_of(line.arguments.begin(), line.arguments.end(), IsStudyFolder);
  if (study) {
    WriteStudyReport(line.arguments, FLAGS_out, FLAGS_allow_differences);
  } else {
    WriteReport(line.arguments, FLAGS_out, FLAGS_allow_differences);
  }
  return kExitOk;
}

}  // namespace

Verb ReportVerb() {
  return {"report",
          "DIR... --out=FILE",
          "one self-contained HTML page from result folders, or from the shards of a study",
          {"out", "allow_differences", "walk"},
          RunReport};
}

}  // namespace walkgraph
