#ifndef WALKGRAPH_EVAL_SPLIT_H_
#define WALKGRAPH_EVAL_SPLIT_H_

#include <string_view>
#include <vector>

namespace walkgraph {

// The parts of a text between separators; one more than there are separators. They point into it.
std::vector<std::string_view> Split(std::string_view text, char separator);

}  // namespace walkgraph

#endif  // WALKGRAPH_EVAL_SPLIT_H_
