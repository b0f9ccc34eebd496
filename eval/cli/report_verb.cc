#include "common_flags.h"
#include "eval/evaluate.h"
#include "eval/report/report.h"
#include "eval/usage_error.h"
#include "verbs.h"

namespace walkgraph {
namespace {

int RunReport(const CommandLine& line) {
  if (line.arguments.empty()) throw UsageError("expected a result folder, or several");
  RequireFlag("out", FLAGS_out);
  WriteReport(line.arguments, FLAGS_out);
  return kExitOk;
}

}  // namespace

Verb ReportVerb() {
  return {"report",
          "DIR... --out=FILE",
          "one self-contained HTML page from result folders",
          {"out"},
          RunReport};
}

}  // namespace walkgraph
