#ifndef WALKGRAPH_DATA_INPUT_ERROR_H_
#define WALKGRAPH_DATA_INPUT_ERROR_H_

#include <cstdint>
#include <stdexcept>
#include <string>

namespace walkgraph {

// Input that cannot be used: `file:line: what, what was expected`. The command line turns it into
// exit code 3, an evaluation into a row with status `input_error`.
class InputError : public std::runtime_error {
 public:
  // `line` counts from 1; 0 where a line makes no sense.
  InputError(const std::string& file, std::int64_t line, const std::string& what,
             const std::string& expected)
      : std::runtime_error(file + (line > 0 ? ":" + std::to_string(line) : "") + ": " + what +
                           ", expected " + expected) {}
};

}  // namespace walkgraph

#endif  // WALKGRAPH_DATA_INPUT_ERROR_H_
