#ifndef WALKGRAPH_EVAL_USAGE_ERROR_H_
#define WALKGRAPH_EVAL_USAGE_ERROR_H_

#include <stdexcept>

namespace walkgraph {

// A command line that cannot be obeyed: unknown verb, flag, method or key. Exit code 2.
class UsageError : public std::runtime_error {
 public:
  using std::runtime_error::runtime_error;
};

}  // namespace walkgraph

#endif  // WALKGRAPH_EVAL_USAGE_ERROR_H_
