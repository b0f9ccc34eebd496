#ifndef WALKGRAPH_EVAL_RUN_FOLDER_H_
#define WALKGRAPH_EVAL_RUN_FOLDER_H_

#include <map>
#include <string>

#include "eval/outcome.h"

namespace walkgraph {

// OUT/run/ holds what differs from run to run and is outside the promise of equal bytes.

// From here on the log goes to run/log.*; warnings to standard error too.
void LogToRunFolder(const std::string& out);

// Writes run/command.txt (the command line) and run/machine.json (date, host, processor, cores,
// memory, workers, compiler).
void WriteRunDescription(const std::string& out, const std::string& command_line, int workers);

// Writes run/timings.csv: walk,method,seconds.
void WriteTimings(const std::string& out, const Evaluation& evaluation);

// Mean wall time per finished walk, by method.
std::map<std::string, double> SecondsPerWalk(const Evaluation& evaluation);

}  // namespace walkgraph

#endif  // WALKGRAPH_EVAL_RUN_FOLDER_H_
