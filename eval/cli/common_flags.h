#ifndef WALKGRAPH_EVAL_CLI_COMMON_FLAGS_H_
#define WALKGRAPH_EVAL_CLI_COMMON_FLAGS_H_

#include <gflags/gflags.h>

#include <string>
#include <vector>

#include "command_line.h"
#include "eval/config.h"
#include "eval/cross_validation.h"

// Flags that several verbs share.
DECLARE_string(config);
DECLARE_string(dataset);
DECLARE_string(floor);
DECLARE_string(split);
DECLARE_int32(folds);
DECLARE_bool(tum);
DECLARE_string(out);
DECLARE_int32(workers);

namespace walkgraph {

// The values of --config and then of every --set. Throws InputError or UsageError.
std::vector<ConfigOverride> ReadOverrides(const CommandLine& line);

// Defaults with ReadOverrides applied.
Settings ReadSettings(const CommandLine& line);

// --workers, or the number of cores where it is 0. Throws UsageError where it is negative.
int Workers();

// Whether --floor is `given`; UsageError unless it is `given` or `unknown`.
bool FloorGiven();

// --split and --folds; UsageError for a split that is unknown or fewer than two folds.
SplitBy SplitOfFlags();
int Folds();

// Throws UsageError unless a flag that the verb cannot do without has been set.
void RequireFlag(const char* name, const std::string& value);

// Throws UsageError where there is any argument that is not a flag.
void RequireNoArguments(const CommandLine& line);

// Whether Ctrl-C was pressed since HandleInterrupt(). A second Ctrl-C ends the program at once.
bool Interrupted();
void HandleInterrupt();

}  // namespace walkgraph

#endif  // WALKGRAPH_EVAL_CLI_COMMON_FLAGS_H_
