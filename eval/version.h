#ifndef WALKGRAPH_EVAL_VERSION_H_
#define WALKGRAPH_EVAL_VERSION_H_

#include <string_view>

namespace walkgraph {

// The project's version as CMake knows it, "0.1.0".
std::string_view Version();

}  // namespace walkgraph

#endif  // WALKGRAPH_EVAL_VERSION_H_
