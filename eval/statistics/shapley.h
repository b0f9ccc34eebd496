#ifndef WALKGRAPH_EVAL_STATISTICS_SHAPLEY_H_
#define WALKGRAPH_EVAL_STATISTICS_SHAPLEY_H_

#include <vector>

namespace walkgraph {

// What each of `players` contributes to the value of all of them together: its marginal
// contribution averaged over every order of joining (Shapley 1953, A value for n-person games).
// values[s] is the value of the subset whose members are the set bits of s. The contributions add
// up to values.back() - values[0]. Precondition: values has 2^players entries, players <= 20.
std::vector<double> ShapleyValues(const std::vector<double>& values, int players);

}  // namespace walkgraph

#endif  // WALKGRAPH_EVAL_STATISTICS_SHAPLEY_H_
