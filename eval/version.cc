#include "eval/version.h"

namespace walkgraph {

std::string_view Version() { return WALKGRAPH_VERSION; }

}  // namespace walkgraph
