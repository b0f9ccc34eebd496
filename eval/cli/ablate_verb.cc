#include <charconv>

#include "common_flags.h"
#include "eval/study/factor_design.h"
#include "eval/study/run_study.h"
#include "eval/study/study_file.h"
#include "eval/usage_error.h"
#include "verbs.h"

DECLARE_string(methods);
DEFINE_string(study, "", "YAML file that declares a study");
DEFINE_string(factors, "",
              "factors whose subsets are compared: all-subsets, leave-one-out or add-one-in of the "
              "default seven, or a list");
DEFINE_string(shard, "", "i/n: work on the i-th of n parts of the walks only");

namespace walkgraph {
namespace {

struct Shard {
  int index = 1;
  int count = 1;
};

Shard ParseShard(const std::string& text) {
  Shard shard;
  if (text.empty()) return shard;
  const char* end = text.data() + text.size();
  const auto first = std::from_chars(text.data(), end, shard.index);
  if (first.ec == std::errc() && first.ptr != end && *first.ptr == '/') {
    const auto second = std::from_chars(first.ptr + 1, end, shard.count);
    if (second.ec == std::errc() && second.ptr == end && shard.index >= 1 &&
        shard.index <= shard.count) {
      return shard;
    }
  }
  throw UsageError("--shard=" + text + ": expected i/n with 1 <= i <= n");
}

// The common case: one data set, methods or one method's factors.
Study StudyOfFlags(const CommandLine& line) {
  RequireFlag("dataset", FLAGS_dataset);
  Study study;
  study.datasets = {{DatasetNameOf(FLAGS_dataset), FLAGS_dataset}};
  study.folds = Folds();
  study.split = SplitOfFlags();
  study.split_name = FLAGS_split;
  study.floor_given = FloorGiven();
  study.base = ReadOverrides(line);
  if (FLAGS_factors.empty()) {
    RequireFlag("factors", FLAGS_methods);
    for (const Method* method : ParseMethods(FLAGS_methods)) {
      study.cells.push_back({method->name, method, {}});
    }
    study.reference = study.cells.front().name;
  } else {
    const FactorStudy factors = ParseFactorStudy(FLAGS_factors);
    const std::string names = FLAGS_methods.empty() ? "batch" : FLAGS_methods;
    const std::vector<const Method*> methods = ParseMethods(names);
    if (methods.size() > 1) {
      throw UsageError("--methods=" + names + ": expected one method with --factors");
    }
    AddFactorCells(factors, *methods.front(), &study);
  }
  CheckStudy(study);
  return study;
}

// A flag that the study file speaks of would be passed over.
void RequireNothingDeclared() {
  for (const char* flag : {"dataset", "factors", "methods", "folds", "split", "floor"}) {
    if (gflags::GetCommandLineFlagInfoOrDie(flag).is_default) continue;
    throw UsageError(std::string("--") + flag + ": expected in the file of --study, not beside it");
  }
}

int RunAblate(const CommandLine& line) {
  RequireNoArguments(line);
  RequireFlag("out", FLAGS_out);
  if (!FLAGS_study.empty()) RequireNothingDeclared();
  const Study study =
      FLAGS_study.empty() ? StudyOfFlags(line) : ReadStudyFile(FLAGS_study, ReadOverrides(line));
  const Shard shard = ParseShard(FLAGS_shard);
  HandleInterrupt();
  return RunStudy(study, {.out = FLAGS_out,
                          .workers = Workers(),
                          .shard = shard.index,
                          .shards = shard.count,
                          .command_line = line.text,
                          .stopped = Interrupted});
}

}  // namespace

Verb AblateVerb() {
  return {"ablate",
          "--dataset=DIR --factors=all-subsets --out=DIR, or --study=FILE --out=DIR",
          "compare configurations over factor sets, methods and settings; resumes what was begun",
          {"dataset", "factors", "methods", "study", "folds", "split", "floor", "out", "shard",
           "workers", "config", "set"},
          RunAblate};
}

}  // namespace walkgraph
