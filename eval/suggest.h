#ifndef WALKGRAPH_EVAL_SUGGEST_H_
#define WALKGRAPH_EVAL_SUGGEST_H_

#include <string>
#include <string_view>
#include <vector>

namespace walkgraph {

// Number of single-character insertions, deletions and replacements between two words.
int EditDistance(std::string_view a, std::string_view b);

// `, did you mean "x"?` with the known word nearest to `word`, or an empty string where none is
// closer than a third of the word's length (at least two edits). Ties go to the earlier word.
std::string DidYouMean(std::string_view word, const std::vector<std::string>& known);

}  // namespace walkgraph

#endif  // WALKGRAPH_EVAL_SUGGEST_H_
