#ifndef WALKGRAPH_EVAL_METHODS_H_
#define WALKGRAPH_EVAL_METHODS_H_

#include <functional>
#include <memory>
#include <string>
#include <string_view>
#include <vector>

#include "eval/settings.h"
#include "solvers/baselines/description.h"
#include "solvers/estimator.h"

namespace walkgraph {

// A method by its name on the command line.
struct Method {
  std::string name;  // [a-z0-9_]+
  MethodDescription description;
  std::function<std::unique_ptr<Estimator>(const Settings&)> make;
  bool floor_by_floor = false;  // it knows one floor, see FloorByFloor
};

// Every method, in the order in which tables list them.
const std::vector<Method>& Methods();

std::vector<std::unique_ptr<Estimator>> MakeEstimators(const std::vector<const Method*>& methods,
                                                       const Settings& settings);

// The methods of a comma-separated list, each once, in the order given.
// Throws UsageError for an empty list, a name that is unknown or given twice.
std::vector<const Method*> ParseMethods(std::string_view list);

}  // namespace walkgraph

#endif  // WALKGRAPH_EVAL_METHODS_H_
