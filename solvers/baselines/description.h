#ifndef WALKGRAPH_SOLVERS_BASELINES_DESCRIPTION_H_
#define WALKGRAPH_SOLVERS_BASELINES_DESCRIPTION_H_

#include <string_view>

namespace walkgraph {

// What `walkgraph methods` prints about a method. Its parameters document themselves in the Visit()
// of its settings.
struct MethodDescription {
  std::string_view name;
  std::string_view summary;
  std::string_view source;
  std::string_view own_choices;  // what the source leaves open and we decided; empty where nothing
};

}  // namespace walkgraph

#endif  // WALKGRAPH_SOLVERS_BASELINES_DESCRIPTION_H_
