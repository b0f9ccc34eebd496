#ifndef WALKGRAPH_EVAL_CLI_COMMAND_LINE_H_
#define WALKGRAPH_EVAL_CLI_COMMAND_LINE_H_

#include <string>
#include <vector>

namespace walkgraph {

// What stands behind the verb, once its flags have been taken off.
struct CommandLine {
  std::vector<std::string> arguments;    // what is not a flag
  std::vector<std::string> assignments;  // of --set, in order
  bool help = false;
  std::string text;  // the whole line, for the record
};

// A verb of the program.
struct Verb {
  std::string name;
  std::string usage;                         // arguments behind the name
  std::string summary;                       // one line
  std::vector<std::string> flags;            // names of the gflags that it takes
  int (*run)(const CommandLine&) = nullptr;  // returns the exit code
};

// Sets the gflags of a verb from `--name=value`, `--name value` and, for switches, `--name` and
// `--noname`. gflags itself would accept the flags of every verb, keep only the last --set and
// leave with exit code 1. Throws UsageError for a flag that the verb does not take, a missing value
// or one of the wrong type.
CommandLine ParseCommandLine(const Verb& verb, const std::vector<std::string>& words);

// "  --name  description (default)" per flag of the verb.
std::string DescribeFlags(const Verb& verb);

}  // namespace walkgraph

#endif  // WALKGRAPH_EVAL_CLI_COMMAND_LINE_H_
