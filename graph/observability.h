#ifndef WALKGRAPH_GRAPH_OBSERVABILITY_H_
#define WALKGRAPH_GRAPH_OBSERVABILITY_H_

#include <map>
#include <optional>
#include <string>
#include <vector>

#include "graph/linear_system.h"

namespace walkgraph {

// What a block is, in the words of the caller.
struct BlockLabel {
  std::string kind;               // "position", "heading", "step_scale"
  std::vector<std::string> axes;  // a name per coordinate: {"x", "y"}; empty if it needs none
};

// How far one kind of state takes part in an unobservable direction.
struct KindMovement {
  std::string kind;
  double share = 0;               // of the squared movement, each coordinate in its own sigmas
  std::vector<std::string> axes;  // coordinates that move
  int blocks = 0;                 // how many blocks of the kind move, from `first` to `last`
  int first_block = 0;
  int last_block = 0;
};

// Directions of the state that no factor sees, alike in which kinds they move.
struct UnobservableDirections {
  int dimension = 0;                    // how many independent ones
  std::vector<KindMovement> movements;  // the largest share first
};

struct ObservabilityReport {
  int nullity = 0;  // 0: everything is observable
  // Directions that move one kind alone come first, in the order of the kinds' first labels, then
  // those that move several together (a rotation of the walk: heading and position). They add up to
  // `nullity` unless that exceeds kMaxNamedDirections; then the rest stays unnamed.
  std::vector<UnobservableDirections> directions;
};

inline constexpr int kMaxNamedDirections = 24;

// Finds the null space of J (equal to that of H = J^T J) by block QR. A direction counts as
// unobservable if, in the order of elimination, its pivot is below kRankTolerance of the norm of
// its column: its own information under 1e-18 of what the column would have with all others known.
// Nothing is returned if a Jacobian is not finite. Throws std::invalid_argument on a malformed
// system or if `labels` has not one entry per block.
std::optional<ObservabilityReport> AnalyzeObservability(const LinearSystem& system,
                                                        const std::vector<BlockLabel>& labels);

// One sentence per entry of the report: "unobservable: position along (x, y); no factor of type
// fingerprint or position_anchor". `remedies` names per kind the factor types that would fix it;
// the clause after the semicolon is left out where none is named.
std::vector<std::string> DescribeObservability(
    const ObservabilityReport& report,
    const std::map<std::string, std::vector<std::string>>& remedies);

}  // namespace walkgraph

#endif  // WALKGRAPH_GRAPH_OBSERVABILITY_H_
