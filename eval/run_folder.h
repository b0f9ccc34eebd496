#ifndef WALKGRAPH_EVAL_RUN_FOLDER_H_
#define WALKGRAPH_EVAL_RUN_FOLDER_H_

#include <map>
#include <string>

#include "eval/outcome.h"

namespace walkgraph {

// `run` is OUT/run, which holds what differs from run to run and is outside the promise of equal
// bytes, or the part of it that belongs to one of several processes.

// From here on the log goes to log.* in it; warnings to standard error too.
void LogToRunFolder(const std::string& run);

// Writes command.txt (the command line) and machine.json (date, host, processor, cores,
// memory, workers, compiler).
void WriteRunDescription(const std::string& run, const std::string& command_line, int workers);

// Writes timings.csv: walk,method,seconds.
void WriteTimings(const std::string& run, const Evaluation& evaluation);

// Mean wall time per finished walk, by method.
std::map<std::string, double> SecondsPerWalk(const Evaluation& evaluation);

}  // namespace walkgraph

#endif  // WALKGRAPH_EVAL_RUN_FOLDER_H_
