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
      : std::runtime_error(Message(file, line, what, expected)) {}

 private:
  static std::string Message(const std::string& file, std::int64_t line, const std::string& what,
                             const std::string& expected) {
    std::string message = file;
    if (line > 0) message.append(":").append(std::to_string(line));
    return message.append(": ").append(what).append(", expected ").append(expected);
  }
};

}  // namespace walkgraph

#endif  // WALKGRAPH_DATA_INPUT_ERROR_H_
